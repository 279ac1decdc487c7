#include "tone/fold_sides.h"

#include <algorithm>
#include <cmath>

namespace illustrate {
namespace {

constexpr double first_beyond = 2, last_beyond = 8;  // cells beyond a fold whose light counts

// Parts up to so many times as wide as a band count as narrow, others more and more as wide.
constexpr double narrow_part = 3;
// And those with so small a share of the light beyond as dark, up to that as light.
constexpr double dark_share = 0.5, light_share = 0.75;

// From 0 to 1 between two values.
double rise(double value, double from, double to) {
  return std::clamp((value - from) / (to - from), 0.0, 1.0);
}

class Mean {
 public:
  void add(double value) {
    sum_ += std::min(value, 1.0);
    ++count_;
  }
  double value() const { return count_ > 0 ? sum_ / count_ : 0; }

 private:
  double sum_ = 0;
  int count_ = 0;
};

bool are_other_faces(const Surface& surface, int a, int b) {
  const int one = surface.triangle_planes[idx(a)], other = surface.triangle_planes[idx(b)];
  return one != none && other != none && one != other;
}

}  // namespace

FoldSides fold_sides(const Surface& surface, const VisibleImage& visible,
                     const std::vector<float>& brightness, const Vec2& at, const Vec2& beyond,
                     double most_px, double most_step) {
  const auto cell_at = [&](double cells) {
    const int cell = visible.cell_of(at + cells * visible.cell_px * beyond);
    return cell == none || visible.triangle[idx(cell)] == none ? none : cell;
  };
  Mean part, other;
  FoldSides sides;
  int before = none;
  for (double cells = 1; cells * visible.cell_px <= most_px; ++cells) {
    const int cell = cell_at(-cells);
    if (cell == none) break;
    const bool goes_on =
        before == none ||
        (std::abs(visible.depth[idx(cell)] - visible.depth[idx(before)]) <= most_step &&
         !are_other_faces(surface, visible.triangle[idx(before)], visible.triangle[idx(cell)]));
    if (!goes_on) break;
    part.add(brightness[idx(cell)]);
    sides.width_px = cells * visible.cell_px;
    before = cell;
  }
  for (double cells = first_beyond; cells <= last_beyond; ++cells) {
    const int cell = cell_at(cells);
    if (cell != none) other.add(brightness[idx(cell)]);
  }
  sides.light = part.value();
  sides.light_beyond = other.value();
  return sides;
}

double kept_mach_band(const FoldSides& sides, double band_px) {
  if (!(band_px > 0 && sides.light_beyond > 0)) return 1;
  const double wide = rise(sides.width_px, narrow_part * band_px, wide_part * band_px);
  const double light =
      rise(sides.light, dark_share * sides.light_beyond, light_share * sides.light_beyond);
  return std::max(wide, light);
}

}  // namespace illustrate
