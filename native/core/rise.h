// A ramp from 0 to 1.
#pragma once

#include <algorithm>

namespace illustrate {

// 0 up to `from`, 1 beyond `to`, linear between them; from < to.
inline double rise(double value, double from, double to) {
  return std::clamp((value - from) / (to - from), 0.0, 1.0);
}

}  // namespace illustrate
