#include "tone/fold_sides.h"

#include <algorithm>
#include <cmath>

#include "core/rise.h"

namespace illustrate {
namespace {

constexpr double first_beyond = 2, last_beyond = 8;  // cells beyond a fold whose light counts

// Parts up to so many times as wide as a band count as narrow, others more and more as wide.
constexpr double narrow_part = 3;
// And those with so small a share of the light beyond as dark, up to that as light.
constexpr double dark_share = 0.5, light_share = 0.75;

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

// The cells across a fold, positive beyond it.
struct Across {
  const Surface& surface;
  const VisibleImage& visible;
  const std::vector<float>& brightness;
  const Vec2 at, beyond;

  int cell(double cells) const { return visible.cell_of(at + cells * visible.cell_px * beyond); }
  int triangle(int cell) const { return visible.triangle[idx(cell)]; }

  bool is_same_part(int a, int b, double most_step) const {
    if (triangle(b) == none) return false;
    if (surface.object_of(triangle(a)) != surface.object_of(triangle(b))) return false;
    const int plane = surface.triangle_planes[idx(triangle(a))];
    const int other = surface.triangle_planes[idx(triangle(b))];
    return (plane == none || other == none || plane == other) &&
           visible.depth[idx(b)] - visible.depth[idx(a)] <= most_step;
  }

  // What leaves the frame goes on. Sets the mean light of the part.
  double part_width(double most_px, double most_step, double& light) const {
    Mean mean;
    double width = 0;
    int before = none;
    for (double cells = 1; cells * visible.cell_px <= most_px; ++cells) {
      const int here = cell(-cells);
      if (here == none) width = most_px;
      const bool goes_on = here != none && (before == none ? triangle(here) != none
                                                           : is_same_part(before, here, most_step));
      if (!goes_on) break;
      mean.add(brightness[idx(here)]);
      width = cells * visible.cell_px;
      before = here;
    }
    light = mean.value();
    return width;
  }

  double light_beyond() const {
    Mean mean;
    for (double cells = first_beyond; cells <= last_beyond; ++cells) {
      const int here = cell(cells);
      if (here != none && triangle(here) != none) mean.add(brightness[idx(here)]);
    }
    return mean.value();
  }
};

}  // namespace

FoldSides fold_sides(const Surface& surface, const VisibleImage& visible,
                     const std::vector<float>& brightness, const Vec2& at, const Vec2& beyond,
                     double most_px, double most_step) {
  const Across across{surface, visible, brightness, at, beyond};
  FoldSides sides;
  sides.width_px = across.part_width(most_px, most_step, sides.light);
  sides.light_beyond = across.light_beyond();
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
