#include "hatch/view/walk.h"

#include <algorithm>
#include <cmath>

#include "core/prefetch.h"

namespace illustrate {
namespace {

std::array<double, 3> weights_of(const SurfacePoint& on) {
  return {1 - on.b1 - on.b2, on.b1, on.b2};
}

}  // namespace

Walker::Walker(const Surface& surface, const CrossField& field, const Camera& camera)
    : walker_(surface, field), surface_(surface), camera_(camera), map_(image_map(camera)) {
  front_.reserve(surface.positions.size());
  for (std::size_t i = 0; i < surface.positions.size(); ++i) {
    front_.push_back(surface.normals[i].dot(camera.to_eye(surface.positions[i])));
  }
}

Walk Walker::start(const SurfacePoint& on, const Vec3& towards) const {
  return {on, cross_direction(surface_, walker_.field(), on, towards),
          facing_at(on) < 0 ? -1.0 : 1.0};
}

Walk Walker::turned(Walk walk) {
  walk.tangent = -walk.tangent;
  return walk;
}

HatchPoint Walker::point(const SurfacePoint& on) const {
  const Vec3 position = position_at(surface_, on);
  return {position, on, camera_.project(position).xy};
}

void Walker::fetch(const SurfacePoint& on) const {
  prefetch(&surface_.neighbours[idx(on.triangle)]);
  for (const int vertex : surface_.triangles[idx(on.triangle)]) {
    prefetch(&surface_.positions[idx(vertex)]);
    prefetch(&surface_.normals[idx(vertex)]);
    prefetch(&walker_.field().directions[idx(vertex)]);
    prefetch(&front_[idx(vertex)]);
  }
}

// The function whose zero set is the silhouette: linear on a triangle of a smooth object, constant
// on a polygon's.
double Walker::facing_at(const SurfacePoint& on) const {
  const Triangle& corner = surface_.triangles[idx(on.triangle)];
  if (surface_.is_smooth_at(on.triangle)) {
    const std::array<double, 3> weight = weights_of(on);
    double sum = 0;
    for (int k = 0; k < 3; ++k) {
      sum += weight[idx(k)] * surface_.corner_sign(on.triangle, k) * front_[idx(corner[idx(k)])];
    }
    return sum;
  }
  const Vec3& origin = surface_.positions[idx(corner[0])];
  const Vec3 u = surface_.positions[idx(corner[1])] - origin,
             v = surface_.positions[idx(corner[2])] - origin;
  return u.cross(v).dot(camera_.to_eye(origin));
}

// Image length per length along a direction, turned into the triangle's plane.
double Walker::px_along(const SurfacePoint& on, const Vec3& direction) const {
  const Triangle& corner = surface_.triangles[idx(on.triangle)];
  const Vec3& origin = surface_.positions[idx(corner[0])];
  const Vec3 u = surface_.positions[idx(corner[1])] - origin,
             v = surface_.positions[idx(corner[2])] - origin;
  const Vec3 normal = u.cross(v);
  const double square = std::max(normal.squaredNorm(), 1e-300);
  const Vec3 flat = direction - normal * (normal.dot(direction) / square);
  return std::max(image_direction(origin + on.b1 * u + on.b2 * v, flat).norm(), 1e-300);
}

WalkEnd Walker::advance(Walk& walk, double length_px) const {
  double rest = length_px;
  int entry_edge = none;
  for (Headway headway(rest); headway.is_made(rest);) {
    const double front = walk.facing * facing_at(walk.on);
    if (!(front > 0)) return WalkEnd::silhouette;
    const Course step = walker_.course_along_cross(walk.on, walk.tangent, entry_edge,
                                                   rest / px_along(walk.on, walk.tangent));
    if (step.exit_edge == none) return WalkEnd::edge;
    const double px = px_along(walk.on, step.direction), reach = rest / px;
    const double length = std::min(step.exit, reach);
    SurfacePoint next = walk.on;
    FieldWalker::move(next, step, length);
    const double front_after = walk.facing * facing_at(next);
    if (!(front_after > 0)) {
      next = walk.on;
      FieldWalker::move(next, step, length * front / (front - front_after));
    }
    walk.on = next;
    walk.tangent = step.direction;
    if (!(front_after > 0)) return WalkEnd::silhouette;
    if (reach <= step.exit) return WalkEnd::whole;
    rest -= length * px;
    if (!walker_.cross_edge(walk.on, step.exit_edge, entry_edge, walk.facing)) return WalkEnd::edge;
  }
  return WalkEnd::edge;
}

}  // namespace illustrate
