// What decides softly how far a mesh is rounded.
#pragma once

#include <algorithm>

namespace illustrate {

// How far a surface is off is measured in pixels of a drawing in which the object's diagonal has so
// many: the object fills a page.
constexpr double diagonal_px = 1400;
// Lines a pixel wide do not show less, and clearly show the other.
constexpr double invisible_px = 0.75, visible_px = 2.25;

// 0 up to `from`, 1 beyond `to`, smooth between.
inline double smoothstep(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0., 1.);
  return t * t * (3 - 2 * t);
}

}  // namespace illustrate
