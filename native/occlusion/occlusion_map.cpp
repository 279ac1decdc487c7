#include "occlusion/occlusion_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "surface/locate.h"

namespace illustrate {
namespace {

// What is larger is seldom covered all over, and takes long to look at.
constexpr int most_cells_across = 64;  // of a box that is looked at
// A triangle that is seen from its edge recedes by no more than so many of its edges.
constexpr double most_recession = 3;

// greatest[i] = max(greatest[i], values[i + shift]) wherever both are there.
void take_greater(float* greatest, const float* values, std::ptrdiff_t count,
                  std::ptrdiff_t shift) {
  const std::ptrdiff_t begin = std::max<std::ptrdiff_t>(-shift, 0);
  const std::ptrdiff_t end = std::min(count - shift, count);
  for (std::ptrdiff_t i = begin; i < end; ++i) {
    greatest[i] = std::max(greatest[i], values[i + shift]);
  }
}

// The greatest value within a square of cells.
std::vector<float> greatest_within(const std::vector<float>& values, int width, int height,
                                   int reach) {
  std::vector<float> in_rows = values;
  for (int row = 0; row < height; ++row) {
    const std::ptrdiff_t start = static_cast<std::ptrdiff_t>(row) * width;
    for (int shift = -reach; shift <= reach; ++shift) {
      take_greater(in_rows.data() + start, values.data() + start, width, shift);
    }
  }
  std::vector<float> result = in_rows;
  const auto count = static_cast<std::ptrdiff_t>(values.size());
  for (int shift = -reach; shift <= reach; ++shift) {
    take_greater(result.data(), in_rows.data(), count, static_cast<std::ptrdiff_t>(shift) * width);
  }
  return result;
}

// Between a triangle and what it hides. What is flat is where its curves are.
double gap(const Surface& surface, int triangle) {
  const bool is_flat =
      !surface.is_smooth_at(triangle) || surface.triangle_planes[idx(triangle)] != none;
  return is_flat ? 0 : reach_of_own_curves(surface, triangle);
}

// Depths from which on each cell's triangle hides, so much behind it; rounded up.
template <class Slack>
std::vector<float> hiding_depths(const Surface& surface, const VisibleImage& image,
                                 const Slack& slack) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  std::vector<float> depths(image.depth.size(), infinity);
  for (std::size_t cell = 0; cell < depths.size(); ++cell) {
    const int triangle = image.triangle[cell];
    if (triangle == none) continue;
    const double depth = image.depth[cell] + gap(surface, triangle) + slack(triangle);
    depths[cell] = std::nextafter(static_cast<float>(depth), infinity);
  }
  return depths;
}

// How far the triangle's plane recedes in so many px.
double recession(const Surface& surface, const Camera& camera, int triangle, double px) {
  std::array<ImagePoint, 3> p;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& corner = surface.positions[idx(surface.triangles[idx(triangle)][k])];
    if (!(camera.near_distance(corner) > 0)) return 0;
    p[k] = camera.project(corner);
  }
  const Vec2 a = p[1].xy - p[0].xy, b = p[2].xy - p[0].xy;
  const double da = p[1].depth - p[0].depth, db = p[2].depth - p[0].depth;
  const double area = a.x() * b.y() - a.y() * b.x();
  const double slope =
      Vec2(da * b.y() - db * a.y(), db * a.x() - da * b.x()).norm() / std::abs(area);
  const double most = most_recession * longest_edge(surface, triangle);
  return slope * px < most ? slope * px : most;
}

}  // namespace

OcclusionMap::OcclusionMap(const Surface& surface, const VisibleImage& image, int reach)
    : width_(image.width),
      height_(image.height),
      cell_px_(image.cell_px),
      farthest_(greatest_within(hiding_depths(surface, image, [](int) { return 0.0; }), width_,
                                height_, reach)) {}

OcclusionMap::OcclusionMap(const Surface& surface, const VisibleImage& image, const Camera& camera)
    : width_(image.width), height_(image.height), cell_px_(image.cell_px) {
  farthest_ = hiding_depths(surface, image, [&](int triangle) {
    return recession(surface, camera, triangle, 2 * cell_px_);
  });
}

OcclusionMap OcclusionMap::with_more_reach(int cells) const {
  OcclusionMap result = *this;
  result.farthest_ = greatest_within(farthest_, width_, height_, cells);
  return result;
}

bool OcclusionMap::hides(const Vec2& low, const Vec2& high, double depth) const {
  const Vec2 first = low / cell_px_, last = high / cell_px_;
  if (!(first.minCoeff() >= 0 && last.x() < width_ && last.y() < height_)) return false;
  const int column = static_cast<int>(first.x()), column_end = static_cast<int>(last.x()) + 1;
  const int row = static_cast<int>(first.y()), row_end = static_cast<int>(last.y()) + 1;
  if (std::max(column_end - column, row_end - row) > most_cells_across) return false;
  for (int j = row; j < row_end; ++j) {
    for (int i = column; i < column_end; ++i) {
      if (!(static_cast<double>(farthest_[idx(j * width_ + i)]) < depth)) return false;
    }
  }
  return true;
}

}  // namespace illustrate
