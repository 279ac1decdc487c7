// Loops over independent elements on several threads.
//
// The body writes only to what belongs to its own indices, so the result does not depend on the
// number of threads. Sums over elements are not formed here: floating-point addition is not
// associative.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

#include "core/progress.h"

namespace illustrate {

// How many threads are meant: 0 = all cores.
std::size_t asked_threads(int threads);

// Calls body(begin, end) for consecutive ranges that cover [0, count). threads: 0 = all cores.
// An exception in a body is thrown again in the caller, after all threads have ended.
void parallel_for(std::size_t count, int threads,
                  const std::function<void(std::size_t begin, std::size_t end)>& body);

// The same, a few milliseconds of work at a time, with a report before each.
void parallel_for(std::size_t count, int threads, const Progress& progress,
                  const std::function<void(std::size_t begin, std::size_t end)>& body);

// Calls body(i) for every i in [0, count), each on the thread that is free first: for elements of a
// millisecond of work or more. The body writes only to what belongs to i. Reports at the start, and
// before each element of the calling thread.
void parallel_each(std::size_t count, int threads, const Progress& progress,
                   const std::function<void(std::size_t i)>& body);

// Which parts of some work are done one after another, each on all threads, and how much of the
// others a thread takes at a time: in the unit of their sizes.
struct PartSizes {
  std::size_t large = std::numeric_limits<std::size_t>::max();
  std::size_t at_a_time = 1;
};

// Calls body(part, threads, progress) for each part of some work. One that is larger than `limits`
// says, or more than half of the whole, gets the calling thread, all `threads` and its share of the
// progress; so a single part does. The others follow side by side, each on one thread and without
// progress. The body writes only to what belongs to its part.
void parallel_parts(
    const std::vector<std::size_t>& sizes, const PartSizes& limits, int threads,
    const Progress& progress,
    const std::function<void(std::size_t part, int threads, const Progress& progress)>& body);

// Consecutive elements put together to shares of so much work at least: the first element of each
// share, and the count.
std::vector<std::size_t> shares_of(const std::vector<std::size_t>& work, std::size_t least);

}  // namespace illustrate
