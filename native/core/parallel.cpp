#include "core/parallel.h"

#include <algorithm>
#include <exception>
#include <thread>
#include <vector>

namespace illustrate {
namespace {

// Below this many elements a thread costs more than it saves.
constexpr std::size_t smallest_share = 2048;

// Elements of a thread between two reports of progress.
constexpr std::size_t share_between_reports = 4096;

std::size_t thread_count(std::size_t count, int threads) {
  const std::size_t asked = threads > 0 ? static_cast<std::size_t>(threads)
                                        : std::max(1U, std::thread::hardware_concurrency());
  return std::max<std::size_t>(1, std::min(asked, count / smallest_share));
}

}  // namespace

void parallel_for(std::size_t count, int threads,
                  const std::function<void(std::size_t, std::size_t)>& body) {
  const std::size_t shares = thread_count(count, threads);
  if (shares == 1) {
    if (count > 0) body(0, count);
    return;
  }
  std::vector<std::exception_ptr> failures(shares);
  std::vector<std::thread> workers;
  for (std::size_t s = 0; s < shares; ++s) {
    workers.emplace_back([&, s] {
      try {
        body(count * s / shares, count * (s + 1) / shares);
      } catch (...) {
        failures[s] = std::current_exception();
      }
    });
  }
  for (std::thread& worker : workers) worker.join();
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
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

}  // namespace illustrate
