// Choices that depend on the seed alone, on every machine.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

namespace illustrate::fuzz {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  // 0 .. count - 1; 0 when there is nothing to choose from.
  int below(std::size_t count) {
    return count == 0 ? 0 : static_cast<int>(engine_() % static_cast<std::uint64_t>(count));
  }
  bool one_in(int count) { return below(static_cast<std::size_t>(count)) == 0; }
  // In [0, 1).
  double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  double between(double low, double high) { return low + (high - low) * unit(); }

  template <class T>
  const T& of(const std::vector<T>& values) {
    return values[static_cast<std::size_t>(below(values.size()))];
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace illustrate::fuzz
