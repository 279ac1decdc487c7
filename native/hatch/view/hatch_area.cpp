#include "hatch/view/hatch_area.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/angles.h"

namespace illustrate {
namespace {

// Depths in sizes of a cell: a point is hidden when it is farther behind all cells around it than
// `hidden_cells`; cells of one sheet differ by less than `sheet_cells`.
constexpr double hidden_cells = 0.5;
constexpr double sheet_cells = 4;
// Sheets that are no farther apart lie in one place.
constexpr double least_gap_cells = 1e-3;

// Families that cross at less are a scribble where the band that they fill is narrow.
const double scribble_cotangent = 1 / std::tan(radians(50));

}  // namespace

std::optional<Region> region_beyond(const HatchScene& scene, const Vec2& before, const Vec2& last,
                                    double reach_px) {
  const Vec2 beyond = last + reach_px * (last - before).normalized();
  if (scene.curves.separate(last, beyond)) return {};
  return region_of(scene.tone, beyond);
}

std::vector<std::uint8_t> hatched_objects(const Surface& surface, const VisibleImage& visible,
                                          const ToneMap& tone) {
  std::vector<std::uint8_t> hatched(surface.object_is_smooth.size(), 0);
  for (std::size_t cell = 0; cell < tone.level.size(); ++cell) {
    const int triangle = visible.triangle[cell];
    if (triangle == none || !is_hatched(tone, cell)) continue;
    hatched[idx(surface.object_of(triangle))] = 1;
  }
  return hatched;
}

// Whether `test` accepts the cell of an image point or, asked then, one of the eight around it,
// within the frame.
template <class Test>
bool HatchArea::any_around(const Vec2& image, const Test& test) const {
  const int centre_column = static_cast<int>(image.x() / visible_.cell_px);
  const int centre_row = static_cast<int>(image.y() / visible_.cell_px);
  const int centre = visible_.index(centre_column, centre_row);
  if (test(centre)) return true;
  const int column_from = std::max(centre_column - 1, 0), row_from = std::max(centre_row - 1, 0);
  const int column_to = std::min(centre_column + 1, visible_.width - 1);
  const int row_to = std::min(centre_row + 1, visible_.height - 1);
  for (int row = row_from; row <= row_to; ++row) {
    const int to = visible_.index(column_to, row);
    for (int cell = visible_.index(column_from, row); cell <= to; ++cell) {
      if (cell != centre && test(cell)) return true;
    }
  }
  return false;
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
  if (visible_.triangle[idx(centre)] == point.on.triangle) return true;
  const double depth = camera_.depth(point.position) - hidden_cells * cell_size(point.position);
  const auto is_near = [&](int cell) { return depth <= visible_.depth[idx(cell)]; };
  return any_around(point.image, is_near) && !is_covered_at(centre, point);
}

// Of sheets that are nearer to each other than cells tell apart, a sheet of paper and the table,
// the triangles decide.
bool HatchArea::is_covered_at(int centre, const HatchPoint& point) const {
  const int own = surface_.object_of(point.on.triangle);
  int last = none;
  const auto covers = [&](int cell) {
    const int triangle = visible_.triangle[idx(cell)];
    if (triangle == none || triangle == last || triangle == point.on.triangle) return false;
    last = triangle;
    return passes_before(triangle, point);
  };
  const int seen = visible_.triangle[idx(centre)];
  if (seen == none || surface_.object_of(seen) == own) return covers(centre);
  return any_around(point.image, covers);
}

bool HatchArea::passes_before(int triangle, const HatchPoint& point) const {
  const Vec3 before =
      position_at(surface_, surface_point_under(surface_, map_, triangle, point.image));
  const double gap = least_gap_cells * cell_size(point.position);
  if (camera_.depth(before) > camera_.depth(point.position) - gap) return false;
  return (camera_.project(before).xy - point.image).norm() < least_gap_cells * visible_.cell_px;
}

// Nobody needs to ask for the triangle where the cell itself is wanted.
bool HatchArea::is_wanted_at(int centre, const Vec2& image, Area area) const {
  if (wanted(centre, area)) return true;
  if (visible_.triangle[idx(centre)] != none) return false;
  return any_around(image, [&](int cell) { return wanted(cell, area); });
}

// A point at the outline whose own cell is empty goes with the cells around.
bool HatchArea::is_crossed(const Vec2& image) const {
  const auto has_both = [&](int cell) {
    return illustrate::is_crossed(region_of(tone_.level[idx(cell)], tone_.band[idx(cell)]));
  };
  const int centre = visible_.cell_of(image);
  if (centre == none) return false;
  return has_both(centre) ||
         (visible_.triangle[idx(centre)] == none && any_around(image, has_both));
}

// Whether the two families cross narrowly in an undercut.
bool HatchArea::is_scribble(const HatchPoint& point, const Vec3& tangent) const {
  if (tone_.band[idx(visible_.cell_of(point.image))] != Band::undercut) return false;
  const Vec3 aside = normal_at(surface_, point.on).cross(tangent);
  const double w = apply(map_, point.position)[2];
  const Vec2 a = image_direction(map_, point.image, w, tangent);
  const Vec2 b = image_direction(map_, point.image, w, aside);
  return std::abs(a.dot(b)) > scribble_cotangent * std::abs(cross(a, b));
}

SurfacePoint HatchArea::visible_point(const Vec2& image) const {
  const int centre = visible_.cell_of(image);
  SurfacePoint best;
  if (centre == none || visible_.triangle[idx(centre)] == none) return best;
  double least_error = std::numeric_limits<double>::infinity();
  int last = none;
  any_around(image, [&](int cell) {
    const int triangle = visible_.triangle[idx(cell)];
    if (triangle == none || triangle == last) return false;
    last = triangle;
    const SurfacePoint on = surface_point_under(surface_, map_, triangle, image);
    const Vec3 position = position_at(surface_, on);
    if (!(camera_.near_distance(position) > 0)) return false;
    const ImagePoint seen = camera_.project(position);
    const double error = (seen.xy - image).norm();
    const double apart = std::abs(seen.depth - visible_.depth[idx(centre)]);
    if (error >= least_error || apart > sheet_cells * cell_size(position)) return false;
    least_error = error;
    best = on;
    return least_error < 1e-6;
  });
  return best;
}

}  // namespace illustrate
