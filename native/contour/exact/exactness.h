// Which points of a contour become exact.
#pragma once

#include <cstdint>

namespace illustrate {

// Near cusps and ends, where it decides what the contour does; or everywhere, which takes longer.
enum class Exactness : std::uint8_t { where_needed, everywhere };

}  // namespace illustrate
