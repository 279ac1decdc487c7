// Square cells over the frame; what is outside belongs to the nearest.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/types.h"

namespace illustrate {

struct ImageCells {
  ImageCells(double width_px, double height_px, double cell_px)
      : per_px(1 / cell_px),
        columns(static_cast<int>(std::ceil(width_px / cell_px))),
        rows(static_cast<int>(std::ceil(height_px / cell_px))) {}

  int column_of(double x) const {
    return static_cast<int>(std::clamp(x * per_px, 0.0, columns - 1.0));
  }
  int row_of(double y) const { return static_cast<int>(std::clamp(y * per_px, 0.0, rows - 1.0)); }
  int of(const Vec2& p) const { return row_of(p.y()) * columns + column_of(p.x()); }
  int count() const { return rows * columns; }

  // Calls use(cell) for those that a box touches.
  template <class Use>
  void visit(const Vec2& low, const Vec2& high, const Use& use) const {
    for (int row = row_of(low.y()); row <= row_of(high.y()); ++row) {
      for (int i = column_of(low.x()); i <= column_of(high.x()); ++i) use(row * columns + i);
    }
  }

  double per_px;
  int columns, rows;
};

}  // namespace illustrate
