#include "surface/surface.h"

#include "core/spread.h"

namespace illustrate {
namespace {

// Weights of the three corners.
Vec3 weights(const SurfacePoint& point) { return {1 - point.b1 - point.b2, point.b1, point.b2}; }

}  // namespace

std::vector<Eigen::AlignedBox3d> object_boxes(const Surface& surface) {
  std::vector<Eigen::AlignedBox3d> boxes(surface.object_is_smooth.size());
  for (std::size_t v = 0; v < surface.positions.size(); ++v) {
    boxes[idx(surface.objects[v])].extend(surface.positions[v]);
  }
  return boxes;
}

void measure_diagonals(Surface& surface) {
  Spread all;
  std::vector<Spread> objects(surface.object_is_smooth.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const Triangle& v = surface.triangles[t];
    for (Spread* spread : {&all, &objects[idx(surface.triangle_objects[t])]})
      spread->add(surface.positions[idx(v[0])], surface.positions[idx(v[1])],
                  surface.positions[idx(v[2])]);
  }
  surface.diagonal = all.diagonal();
  surface.object_diagonals.clear();
  for (const Spread& object : objects) surface.object_diagonals.push_back(object.diagonal());
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
