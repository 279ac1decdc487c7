// Exact counts of work done and of defects found, and seconds per stage, by name.
#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace illustrate {

using Counts = std::map<std::string, std::int64_t>;
using Timings = std::map<std::string, double>;

}  // namespace illustrate
