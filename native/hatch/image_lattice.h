// Points of a square lattice over the image.
#pragma once

#include <cstdint>
#include <numeric>

#include "core/types.h"

namespace illustrate {

// Calls visit(i, point) for the middles of all squares of side `step_px` that lie in the image, in
// an order that spreads evenly: steps of the golden ratio round the list.
template <class Visit>
void visit_lattice(double width_px, double height_px, double step_px, const Visit& visit) {
  const auto columns = static_cast<std::int64_t>(width_px / step_px);
  const std::int64_t count = columns * static_cast<std::int64_t>(height_px / step_px);
  if (count < 1) return;
  auto stride = static_cast<std::int64_t>(0.6180339887498949 * static_cast<double>(count)) | 1;
  while (std::gcd(stride, count) != 1) ++stride;
  for (std::int64_t i = 0, at = 0; i < count; ++i, at = (at + stride) % count) {
    const std::int64_t row = at / columns, column = at % columns;
    const Vec2 square(static_cast<double>(column), static_cast<double>(row));
    visit(i, Vec2((square + Vec2(0.5, 0.5)) * step_px));
  }
}

}  // namespace illustrate
