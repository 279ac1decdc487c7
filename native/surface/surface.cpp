#include "surface/surface.h"

namespace illustrate {
namespace {

// Weights of the three corners.
Vec3 weights(const SurfacePoint& point) { return {1 - point.b1 - point.b2, point.b1, point.b2}; }

}  // namespace

double diagonal(const Points& positions) {
  Eigen::AlignedBox3d box;
  for (const Vec3& p : positions) box.extend(p);
  return box.isEmpty() ? 0 : box.diagonal().stableNorm();
}

std::vector<Eigen::AlignedBox3d> object_boxes(const Surface& surface) {
  std::vector<Eigen::AlignedBox3d> boxes(surface.object_is_smooth.size());
  for (std::size_t v = 0; v < surface.positions.size(); ++v) {
    boxes[idx(surface.objects[v])].extend(surface.positions[v]);
  }
  return boxes;
}

void measure_diagonals(Surface& surface) {
  surface.diagonal = diagonal(surface.positions);
  surface.object_diagonals.clear();
  for (const Eigen::AlignedBox3d& box : object_boxes(surface))
    surface.object_diagonals.push_back(box.isEmpty() ? 0 : box.diagonal().norm());
}

Vec3 position_at(const Surface& surface, const SurfacePoint& point) {
  const Triangle& t = surface.triangles[idx(point.triangle)];
  const Vec3 w = weights(point);
  Vec3 sum = Vec3::Zero();
  for (int k = 0; k < 3; ++k) {
    sum += w[k] * surface.positions[idx(t[idx(k)])];
  }
  return sum;
}

Vec3 normal_at(const Surface& surface, const SurfacePoint& point) {
  const Triangle& t = surface.triangles[idx(point.triangle)];
  const Vec3 w = weights(point);
  Vec3 sum = Vec3::Zero();
  for (int k = 0; k < 3; ++k) {
    sum += w[k] * surface.corner_sign(point.triangle, k) * surface.normals[idx(t[idx(k)])];
  }
  const double length = sum.norm();
  if (length > 0) return sum / length;
  return surface.corner_sign(point.triangle, 0) * surface.normals[idx(t[0])];
}

}  // namespace illustrate
