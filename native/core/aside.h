// Work that another thread does beside the calling one, which takes the result later.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <future>

#include "core/parallel.h"

namespace illustrate {

// Where it goes out of scope before its work has ended, the work is cancelled and waited for.
template <class Result>
class Aside {
 public:
  using Work = std::function<Result(const Progress&)>;

  // Begins at once; where `threads` (0 = all cores) are one, not before the result is taken.
  Aside(int threads, Work work) : work_(std::move(work)) {
    if (asked_threads(threads) == 1) return;
    const auto tell = [this](double fraction, const std::string&) {
      fraction_ = fraction;
      return !is_cancelled_;
    };
    future_ = std::async(std::launch::async, [this, tell] { return work_(Progress(tell, {})); });
  }
  Aside(const Aside&) = delete;
  Aside& operator=(const Aside&) = delete;
  ~Aside() { is_cancelled_ = true; }

  // Once. Waits, with reports to `progress`; throws what the work threw.
  Result take(const Progress& progress) {
    if (!future_.valid()) return work_(progress);
    constexpr std::chrono::milliseconds between_reports(5);
    while (future_.wait_for(between_reports) != std::future_status::ready) {
      progress.report(fraction_);
    }
    return future_.get();
  }

 private:
  Work work_;
  std::atomic<double> fraction_{0};
  std::atomic<bool> is_cancelled_{false};
  std::future<Result> future_;  // last: it uses the others, and waits where it ends
};

}  // namespace illustrate
