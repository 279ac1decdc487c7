// Work that another thread does beside the calling one, which takes the result later.
#pragma once

#include <functional>
#include <optional>

#include "core/job.h"
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
    job_.emplace([this](const Progress& progress) { result_.emplace(work_(progress)); });
  }
  Aside(const Aside&) = delete;
  Aside& operator=(const Aside&) = delete;

  // Once. Waits, with reports to `progress`; throws what the work threw.
  Result take(const Progress& progress) {
    progress.report(0);
    if (!job_) return work_(progress);
    constexpr double between_reports_s = 0.005;
    while (!job_->wait(between_reports_s)) progress.report(job_->state().fraction);
    job_->rethrow();
    return std::move(*result_);
  }

 private:
  Work work_;
  std::optional<Result> result_;
  std::optional<Job> job_;  // last: it uses the others
};

}  // namespace illustrate
