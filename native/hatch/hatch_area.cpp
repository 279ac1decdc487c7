#include "hatch/hatch_area.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace illustrate {
namespace {

// Depths in sizes of a cell: a point is hidden when it is farther behind all cells around it than
// `hidden_cells`; cells of one sheet differ by less than `sheet_cells`.
constexpr double hidden_cells = 0.5;
constexpr double sheet_cells = 4;

}  // namespace

double HatchArea::pixel_per_w(const Camera& camera) {
  const Mat4 clip = camera.projection() * camera.view();
  return 2 / (clip.row(1).head<3>().norm() * camera.height_px());
}

// The cell of an image point, then the eight around it, within the frame.
template <class Use>
void HatchArea::around(const Vec2& image, const Use& use) const {
  const int centre_column = static_cast<int>(image.x() / visible_.cell_px);
  const int centre_row = static_cast<int>(image.y() / visible_.cell_px);
  use(visible_.index(centre_column, centre_row));
  for (int row = centre_row - 1; row <= centre_row + 1; ++row) {
    for (int column = centre_column - 1; column <= centre_column + 1; ++column) {
      if (row == centre_row && column == centre_column) continue;
      if (row < 0 || column < 0 || row >= visible_.height || column >= visible_.width) continue;
      use(visible_.index(column, row));
    }
  }
}

bool HatchArea::may_pass(const HatchPoint& point, Area area) const {
  const int centre = cell_in_frame(point);
  return centre != none && is_wanted_at(centre, point.image, area) && is_seen_at(centre, point);
}

bool HatchArea::is_seen(const HatchPoint& point) const {
  const int centre = cell_in_frame(point);
  return centre != none && is_seen_at(centre, point);
}

bool HatchArea::is_wanted(const HatchPoint& point, Area area) const {
  return is_wanted_at(visible_.cell_of(point.image), point.image, area);
}

bool HatchArea::is_seen_at(int centre, const HatchPoint& point) const {
  double depth = -(camera_.view().row(2) * point.position.homogeneous()).value();
  if (depth <= visible_.depth[centre]) return true;
  depth -= hidden_cells * cell_size(point.position);
  if (depth <= visible_.depth[centre]) return true;
  bool is_seen = false;
  around(point.image, [&](int cell) { is_seen = is_seen || depth <= visible_.depth[cell]; });
  return is_seen;
}

// Nobody needs to ask for the triangle where the cell itself is wanted.
bool HatchArea::is_wanted_at(int centre, const Vec2& image, Area area) const {
  if (wanted(centre, area)) return true;
  if (visible_.triangle[centre] != none) return false;
  bool is_wanted = false;
  around(image, [&](int cell) { is_wanted = is_wanted || wanted(cell, area); });
  return is_wanted;
}

SurfacePoint HatchArea::visible_point(const Vec2& image) const {
  const int centre = visible_.cell_of(image);
  SurfacePoint best;
  if (centre == none || visible_.triangle[centre] == none) return best;
  double least_error = std::numeric_limits<double>::infinity();
  int last = none;
  around(image, [&](int cell) {
    const int triangle = visible_.triangle[cell];
    if (triangle == none || triangle == last || least_error < 1e-6) return;
    last = triangle;
    const SurfacePoint on = surface_point_under(surface_, map_, triangle, image);
    const Vec3 position = position_at(surface_, on);
    if (!(camera_.near_distance(position) > 0)) return;
    const ImagePoint seen = camera_.project(position);
    const double error = (seen.xy - image).norm();
    const double apart = std::abs(seen.depth - visible_.depth[centre]);
    if (error >= least_error || apart > sheet_cells * cell_size(position)) return;
    least_error = error;
    best = on;
  });
  return best;
}

}  // namespace illustrate
