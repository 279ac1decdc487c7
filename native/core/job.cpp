#include "core/job.h"

#include <algorithm>
#include <chrono>

namespace illustrate {

Job::Job(Work work) : thread_([this, work = std::move(work)]() mutable { run(work); }) {}

Job::~Job() {
  cancel();
  thread_.join();
}

Job::State Job::state() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return state_;
}

bool Job::is_done() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return is_done_;
}

void Job::cancel() {
  const std::lock_guard<std::mutex> lock(mutex_);
  is_cancelled_ = true;
}

bool Job::wait(double seconds) const {
  constexpr double most = 1e6;              // 12 days; the numbers of clocks end somewhere
  using Clock = std::chrono::system_clock;  // waiting by another needs a C library of 2020
  const std::chrono::duration<double> patience(std::clamp(seconds, 0.0, most));
  const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(patience);
  std::unique_lock<std::mutex> lock(mutex_);
  return ended_.wait_until(lock, end, [this] { return is_done_; });
}

void Job::rethrow() const {
  std::unique_lock<std::mutex> lock(mutex_);
  const std::exception_ptr failure = is_done_ ? failure_ : nullptr;
  lock.unlock();
  if (failure) std::rethrow_exception(failure);
}

void Job::run(Work& work) {
  std::exception_ptr failure;
  try {
    work(Progress(
        [this](double fraction, const std::string& stage) { return report(fraction, stage); }, ""));
  } catch (...) {
    failure = std::current_exception();
  }
  work = nullptr;
  const std::lock_guard<std::mutex> lock(mutex_);
  failure_ = failure;
  is_done_ = true;
  ended_.notify_all();
}

bool Job::report(double fraction, const std::string& stage) {
  const std::lock_guard<std::mutex> lock(mutex_);
  state_.fraction = std::max(state_.fraction, fraction);
  state_.stage = stage;
  return !is_cancelled_;
}

}  // namespace illustrate
