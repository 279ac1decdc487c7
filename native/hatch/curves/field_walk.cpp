#include "hatch/curves/field_walk.h"

#include <algorithm>
#include <limits>

namespace illustrate {
namespace {

// Weights of corners that a walk crosses an edge with: never at a vertex exactly, where the next
// triangle is not known.
constexpr double least_weight = 1e-7;

std::array<double, 3> weights_of(const SurfacePoint& on) {
  return {1 - on.b1 - on.b2, on.b1, on.b2};
}

}  // namespace

void FieldWalker::move(SurfacePoint& on, const Course& course, double length) {
  on.b1 = std::clamp(on.b1 + length * course.change[1], 0.0, 1.0);
  on.b2 = std::clamp(on.b2 + length * course.change[2], 0.0, 1.0 - on.b1);
}

Course FieldWalker::course(const SurfacePoint& on, const Vec3& direction) const {
  const Triangle& corner = surface_.triangles[idx(on.triangle)];
  const Vec3& origin = surface_.positions[idx(corner[0])];
  const Vec3 u = surface_.positions[idx(corner[1])] - origin,
             v = surface_.positions[idx(corner[2])] - origin;
  const double uu = u.dot(u), uv = u.dot(v), vv = v.dot(v), determinant = uu * vv - uv * uv;
  Course result;
  result.direction = direction;
  if (!(determinant > 0)) return result;
  const double du = direction.dot(u), dv = direction.dot(v);
  const double c1 = (du * vv - dv * uv) / determinant, c2 = (dv * uu - du * uv) / determinant;
  result.change = {-c1 - c2, c1, c2};
  const std::array<double, 3> weight = weights_of(on);
  result.exit = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    if (!(result.change[idx(k)] < 0)) continue;
    const double length = std::max(0.0, weight[idx(k)]) / -result.change[idx(k)];
    if (length >= result.exit) continue;
    result.exit = length;
    result.exit_edge = next_corner(k);
  }
  return result;
}

Course FieldWalker::course_along_cross(const SurfacePoint& on, const Vec3& tangent, int entry_edge,
                                       double reach) const {
  const Course first = course(on, tangent);
  if (first.exit_edge == none) return first;
  SurfacePoint middle = on;
  move(middle, first, 0.5 * std::min(first.exit, reach));
  Course result = course(on, cross_direction(surface_, field_, middle, first.direction));
  if (entry_edge == none || result.change[idx(previous_corner(entry_edge))] > 0) return result;
  const Triangle& corner = surface_.triangles[idx(on.triangle)];
  const Vec3 edge = (surface_.positions[idx(corner[idx(next_corner(entry_edge))])] -
                     surface_.positions[idx(corner[idx(entry_edge)])])
                        .normalized();
  const Vec3 direction = result.direction;
  result = course(on, direction.dot(edge) < 0 ? Vec3(-edge) : edge);
  result.change[idx(previous_corner(entry_edge))] = 0;
  result.direction = direction;
  return result;
}

bool FieldWalker::cross_edge(SurfacePoint& on, int edge, int& entry_edge, double& side) const {
  const int from = on.triangle, to = surface_.neighbours[idx(from)][idx(edge)];
  const EdgeKind kind = surface_.edge_kinds[idx(from)][idx(edge)];
  if (to == none || kind == EdgeKind::boundary || kind == EdgeKind::crease) return false;
  const auto place = [&](int triangle, int corner) {
    return surface_.places[idx(surface_.triangles[idx(triangle)][idx(corner)])];
  };
  const int a = place(from, edge), b = place(from, next_corner(edge));
  for (int k = 0; k < 3; ++k) {
    const int c = place(to, k), d = place(to, next_corner(k));
    const bool same_way = c == a && d == b;
    if (!same_way && !(c == b && d == a)) continue;
    const double along = weights_of(on)[idx(same_way ? next_corner(edge) : edge)];
    std::array<double, 3> weight{0, 0, 0};
    weight[idx(next_corner(k))] = std::clamp(along, least_weight, 1 - least_weight);
    weight[idx(k)] = 1 - weight[idx(next_corner(k))];
    on = {to, weight[1], weight[2]};
    if (same_way) side = -side;
    entry_edge = k;
    return true;
  }
  return false;
}

double FieldWalker::advance(SurfacePoint& on, Vec3& tangent, double length) const {
  int entry_edge = none;
  double side = 1;
  for (Headway headway(length); headway.is_made(length);) {
    const Course step = course_along_cross(on, tangent, entry_edge, length);
    if (step.exit_edge == none) return length;
    move(on, step, std::min(step.exit, length));
    tangent = step.direction;
    if (length <= step.exit) return 0;
    length -= step.exit;
    if (!cross_edge(on, step.exit_edge, entry_edge, side)) return length;
  }
  return length;
}

bool FieldWalker::slide(SurfacePoint& on, Vec3 run) const {
  int entry_edge = none;
  double side = 1, left = 1;  // of the way
  for (Headway headway(left); headway.is_made(left);) {
    const Course step = course(on, run);
    if (step.exit_edge == none) return false;
    if (entry_edge != none && !(step.change[idx(previous_corner(entry_edge))] > 0)) return false;
    move(on, step, std::min(step.exit, 1.0));
    if (step.exit >= 1) return true;
    run *= 1 - step.exit;
    left *= 1 - step.exit;
    if (!cross_edge(on, step.exit_edge, entry_edge, side)) return false;
  }
  return false;
}

}  // namespace illustrate
