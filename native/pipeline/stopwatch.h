// Seconds that the stages take.
#pragma once

#include <chrono>

namespace illustrate {

class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// What `make` returns; the time it takes is added to `seconds`.
template <class Make>
auto timed(double& seconds, Make&& make) {
  const Stopwatch watch;
  auto made = make();
  seconds += watch.seconds();
  return made;
}

}  // namespace illustrate
