// Points of a square lattice over the image.
#pragma once

#include <cstdint>
#include <numeric>

#include "core/types.h"

namespace illustrate {

struct ImageLattice {
  ImageLattice(double width_px, double height_px, double step)
      : step_px(step),
        columns(static_cast<std::int64_t>(width_px / step)),
        rows(static_cast<std::int64_t>(height_px / step)) {}

  std::int64_t count() const { return columns * rows; }
  // Of a square; they are numbered row by row.
  Vec2 middle(std::int64_t square) const { return middle(square / columns, square % columns); }
  Vec2 middle(std::int64_t row, std::int64_t column) const {
    const Vec2 corner(static_cast<double>(column), static_cast<double>(row));
    return (corner + Vec2(0.5, 0.5)) * step_px;
  }

  // Calls visit(square) for all squares of side `step_px` that lie in the image, in an order that
  // spreads evenly: steps of the golden ratio round the list.
  template <class Visit>
  void visit(const Visit& visit) const {
    if (count() < 1) return;
    auto stride = static_cast<std::int64_t>(0.6180339887498949 * static_cast<double>(count())) | 1;
    while (std::gcd(stride, count()) != 1) ++stride;
    stride %= count();
    for (std::int64_t i = 0, square = 0; i < count(); ++i) {
      visit(square);
      square += stride;
      if (square >= count()) square -= count();
    }
  }

  double step_px;
  std::int64_t columns, rows;
};

// Calls visit(i, middle) for the squares of a lattice, in the same order.
template <class Visit>
void visit_lattice(double width_px, double height_px, double step_px, const Visit& visit) {
  const ImageLattice lattice(width_px, height_px, step_px);
  std::int64_t i = 0;
  lattice.visit([&](std::int64_t square) { visit(i++, lattice.middle(square)); });
}

}  // namespace illustrate
