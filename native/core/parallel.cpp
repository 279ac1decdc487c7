#include "core/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <numeric>
#include <thread>
#include <vector>

namespace illustrate {
namespace {

// Below this many elements a thread costs more than it saves.
constexpr std::size_t smallest_share = 2048;

// Elements of a thread between two reports of progress.
constexpr std::size_t share_between_reports = 4096;

std::size_t thread_count(std::size_t count, int threads) {
  return std::max<std::size_t>(1, std::min(asked_threads(threads), count / smallest_share));
}

// The elements that are left, for whoever asks next; none once a body has failed.
class Queue {
 public:
  explicit Queue(std::size_t count) : count_(count) {}

  // Calls `before` and the body for elements until there are none; keeps what they throw.
  void work(const std::function<void(std::size_t)>& before,
            const std::function<void(std::size_t)>& body, std::exception_ptr& failure) {
    try {
      for (std::size_t i = next_++; i < count_ && !has_failed_; i = next_++) {
        before(i);
        body(i);
      }
    } catch (...) {
      failure = std::current_exception();
      has_failed_ = true;
    }
  }

 private:
  std::size_t count_;
  std::atomic<std::size_t> next_{0};
  std::atomic<bool> has_failed_{false};
};

void rethrow_first(const std::vector<std::exception_ptr>& failures) {
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
}

}  // namespace

std::size_t asked_threads(int threads) {
  return threads > 0 ? static_cast<std::size_t>(threads)
                     : std::max(1U, std::thread::hardware_concurrency());
}

void parallel_for(std::size_t count, int threads,
                  const std::function<void(std::size_t, std::size_t)>& body) {
  const std::size_t shares = thread_count(count, threads);
  if (shares == 1) {
    if (count > 0) body(0, count);
    return;
  }
  std::vector<std::exception_ptr> failures(shares);
  const auto work = [&](std::size_t s) {
    try {
      body(count * s / shares, count * (s + 1) / shares);
    } catch (...) {
      failures[s] = std::current_exception();
    }
  };
  std::vector<std::thread> workers;
  for (std::size_t s = 1; s < shares; ++s) workers.emplace_back(work, s);
  work(0);
  for (std::thread& worker : workers) worker.join();
  rethrow_first(failures);
}

void parallel_for(std::size_t count, int threads, const Progress& progress,
                  const std::function<void(std::size_t, std::size_t)>& body) {
  const std::size_t piece = share_between_reports * thread_count(count, threads);
  for (std::size_t done = 0; done < count; done += piece) {
    progress.report(static_cast<double>(done) / static_cast<double>(count));
    parallel_for(std::min(piece, count - done), threads,
                 [&](std::size_t begin, std::size_t end) { body(done + begin, done + end); });
  }
}

void parallel_each(std::size_t count, int threads, const Progress& progress,
                   const std::function<void(std::size_t)>& body) {
  if (count > 0) progress.report(0);  // the others may leave the calling thread nothing to do
  Queue queue(count);
  std::vector<std::exception_ptr> failures(
      std::max<std::size_t>(1, std::min(asked_threads(threads), count)));
  const auto report = [&](std::size_t i) {
    progress.report(static_cast<double>(i) / static_cast<double>(count));
  };
  std::vector<std::thread> others;
  for (std::size_t s = 1; s < failures.size(); ++s) {
    others.emplace_back([&, s] { queue.work([](std::size_t) {}, body, failures[s]); });
  }
  queue.work(report, body, failures[0]);
  for (std::thread& other : others) other.join();
  rethrow_first(failures);
}

void parallel_parts(
    const std::vector<std::size_t>& sizes, const PartSizes& limits, int threads,
    const Progress& progress,
    const std::function<void(std::size_t part, int threads, const Progress& progress)>& body) {
  const std::size_t whole = std::accumulate(sizes.begin(), sizes.end(), std::size_t{0});
  const auto share = [&](std::size_t done) {
    return static_cast<double>(done) / static_cast<double>(std::max<std::size_t>(whole, 1));
  };
  std::vector<std::size_t> small, small_sizes;
  std::size_t done = 0;
  for (std::size_t part = 0; part < sizes.size(); ++part) {
    const std::size_t size = sizes[part];
    if (size <= limits.large && 2 * size <= whole) {
      small.push_back(part);
      small_sizes.push_back(size);
      continue;
    }
    body(part, threads, progress.part(share(done), share(done + size)));
    done += size;
  }
  const std::vector<std::size_t> starts = shares_of(small_sizes, limits.at_a_time);
  parallel_each(starts.size() - 1, threads, progress.part(share(done), 1), [&](std::size_t s) {
    for (std::size_t k = starts[s]; k < starts[s + 1]; ++k) body(small[k], 1, {});
  });
}

std::vector<std::size_t> shares_of(const std::vector<std::size_t>& work, std::size_t least) {
  std::vector<std::size_t> starts{0};
  std::size_t sum = 0;
  for (std::size_t i = 0; i < work.size(); ++i) {
    sum += work[i];
    if (sum < least && i + 1 < work.size()) continue;
    starts.push_back(i + 1);
    sum = 0;
  }
  return starts;
}

}  // namespace illustrate
