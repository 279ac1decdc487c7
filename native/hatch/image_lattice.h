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
  const auto rows = static_cast<std::int64_t>(height_px / step_px), count = columns * rows;
  if (count < 1) return;
  auto stride = static_cast<std::int64_t>(0.6180339887498949 * static_cast<double>(count)) | 1;
  while (std::gcd(stride, count) != 1) ++stride;
  const std::int64_t row_stride = stride / columns, column_stride = stride % columns;
  for (std::int64_t i = 0, row = 0, column = 0; i < count; ++i) {
    const Vec2 square(static_cast<double>(column), static_cast<double>(row));
    visit(i, Vec2((square + Vec2(0.5, 0.5)) * step_px));
    row += row_stride, column += column_stride;
    if (column >= columns) column -= columns, ++row;
    if (row >= rows) row -= rows;
  }
}

}  // namespace illustrate
