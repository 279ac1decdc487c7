// Loops over independent elements on several threads.
//
// The body writes only to what belongs to its own indices, so the result does not depend on the
// number of threads. Sums over elements are not formed here: floating-point addition is not
// associative.
#pragma once

#include <cstddef>
#include <functional>

#include "core/progress.h"

namespace illustrate {

// Calls body(begin, end) for consecutive ranges that cover [0, count). threads: 0 = all cores.
// An exception in a body is thrown again in the caller, after all threads have ended.
void parallel_for(std::size_t count, int threads,
                  const std::function<void(std::size_t begin, std::size_t end)>& body);

// The same, a few milliseconds of work at a time, with a report before each.
void parallel_for(std::size_t count, int threads, const Progress& progress,
                  const std::function<void(std::size_t begin, std::size_t end)>& body);

}  // namespace illustrate
