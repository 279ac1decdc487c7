#include "hatch/walk.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace illustrate {
namespace {

// Weights of corners that a walk crosses an edge with: never at a vertex exactly, where the next
// triangle is not known.
constexpr double least_weight = 1e-7;

// A step that crosses more edges than this goes nowhere.
constexpr int most_crossings = 4096;

constexpr double infinite = std::numeric_limits<double>::infinity();

std::array<double, 3> weights_of(const SurfacePoint& on) {
  return {1 - on.b1 - on.b2, on.b1, on.b2};
}

void set_weights(SurfacePoint& on, double b1, double b2) {
  on.b1 = std::clamp(b1, 0.0, 1.0);
  on.b2 = std::clamp(b2, 0.0, 1.0 - on.b1);
}

}  // namespace

// How the weights change per world length, and how far the triangle reaches.
struct Walker::Rates {
  Vec3 direction;                // of the cross
  std::array<double, 3> change;  // of the weights
  double exit = 0;               // length to the edge
  int exit_edge = none;
  double px = 0;  // image length per world length
};

Walker::Walker(const Surface& surface, const CrossField& field, const Camera& camera)
    : surface_(surface), field_(field), camera_(camera), map_(image_map(camera)) {
  front_.reserve(surface.positions.size());
  for (std::size_t i = 0; i < surface.positions.size(); ++i) {
    front_.push_back(surface.normals[i].dot(camera.to_eye(surface.positions[i])));
  }
}

Walk Walker::start(const SurfacePoint& on, const Vec3& towards) const {
  return {on, cross_direction(surface_, field_, on, towards), facing_at(on) < 0 ? -1.0 : 1.0};
}

Walk Walker::turned(Walk walk) {
  walk.tangent = -walk.tangent;
  return walk;
}

HatchPoint Walker::point(const SurfacePoint& on) const {
  const Vec3 position = position_at(surface_, on);
  return {position, on, camera_.project(position).xy};
}

Vec2 Walker::image_direction(const Vec3& p, const Vec3& direction) const {
  const Vec3 h = apply(map_, p), change = map_.leftCols<3>() * direction;
  return (change.head<2>() - h.head<2>() * (change[2] / h[2])) / h[2];
}

// The function whose zero set is the silhouette: linear on a triangle of a smooth object, constant
// on a polygon's.
double Walker::facing_at(const SurfacePoint& on) const {
  const Triangle& corner = surface_.triangles[on.triangle];
  if (surface_.object_is_smooth[surface_.triangle_objects[on.triangle]]) {
    const std::array<double, 3> weight = weights_of(on);
    double sum = 0;
    for (int k = 0; k < 3; ++k) {
      sum += weight[k] * surface_.corner_sign(on.triangle, k) * front_[corner[k]];
    }
    return sum;
  }
  const Vec3& origin = surface_.positions[corner[0]];
  const Vec3 u = surface_.positions[corner[1]] - origin, v = surface_.positions[corner[2]] - origin;
  return u.cross(v).dot(camera_.to_eye(origin));
}

Walker::Rates Walker::rates(const SurfacePoint& on, const Vec3& direction) const {
  const Triangle& corner = surface_.triangles[on.triangle];
  const Vec3& origin = surface_.positions[corner[0]];
  const Vec3 u = surface_.positions[corner[1]] - origin, v = surface_.positions[corner[2]] - origin;
  const double uu = u.dot(u), uv = u.dot(v), vv = v.dot(v), determinant = uu * vv - uv * uv;
  Rates result;
  result.direction = direction;
  if (!(determinant > 0)) return result;
  const double du = direction.dot(u), dv = direction.dot(v);
  const double c1 = (du * vv - dv * uv) / determinant, c2 = (dv * uu - du * uv) / determinant;
  result.change = {-c1 - c2, c1, c2};
  const std::array<double, 3> weight = weights_of(on);
  result.exit = infinite;
  for (int k = 0; k < 3; ++k) {
    if (!(result.change[k] < 0)) continue;
    const double length = std::max(0.0, weight[k]) / -result.change[k];
    if (length >= result.exit) continue;
    result.exit = length;
    result.exit_edge = next_corner(k);
  }
  const Vec3 p = origin + on.b1 * u + on.b2 * v;
  result.px = image_direction(p, c1 * u + c2 * v).norm();
  return result;
}

// Rates from the cross halfway to where the rates at the place itself lead. A walk that would turn
// back over the edge it came by slides along that edge.
Walker::Rates Walker::rates_along_middle(const Walk& walk, int entry_edge, double rest_px) const {
  const SurfacePoint& on = walk.on;
  Rates first = rates(on, cross_direction(surface_, field_, on, walk.tangent));
  if (first.exit_edge == none) return first;
  SurfacePoint middle = on;
  const double half = 0.5 * std::min(first.exit, rest_px / std::max(first.px, 1e-300));
  set_weights(middle, on.b1 + half * first.change[1], on.b2 + half * first.change[2]);
  Rates result = rates(on, cross_direction(surface_, field_, middle, first.direction));
  if (entry_edge == none || result.change[previous_corner(entry_edge)] > 0) return result;
  const Triangle& corner = surface_.triangles[on.triangle];
  const Vec3 edge =
      (surface_.positions[corner[next_corner(entry_edge)]] - surface_.positions[corner[entry_edge]])
          .normalized();
  const Vec3 direction = result.direction;
  result = rates(on, direction.dot(edge) < 0 ? Vec3(-edge) : edge);
  result.change[previous_corner(entry_edge)] = 0;
  result.direction = direction;
  return result;
}

// Into the triangle across an edge; false where the surface ends or creases.
bool Walker::cross_edge(Walk& walk, int edge, int& entry_edge) const {
  const int from = walk.on.triangle, to = surface_.neighbours[from][edge];
  const EdgeKind kind = surface_.edge_kinds[from][edge];
  if (to == none || kind == EdgeKind::boundary || kind == EdgeKind::crease) return false;
  const auto place = [&](int triangle, int corner) {
    return surface_.places[surface_.triangles[triangle][corner]];
  };
  const int a = place(from, edge), b = place(from, next_corner(edge));
  for (int k = 0; k < 3; ++k) {
    const int c = place(to, k), d = place(to, next_corner(k));
    const bool same_way = c == a && d == b;
    if (!same_way && !(c == b && d == a)) continue;
    const double along = weights_of(walk.on)[same_way ? next_corner(edge) : edge];
    std::array<double, 3> weight{0, 0, 0};
    weight[next_corner(k)] = std::clamp(along, least_weight, 1 - least_weight);
    weight[k] = 1 - weight[next_corner(k)];
    walk.on = {to, weight[1], weight[2]};
    if (same_way) walk.facing = -walk.facing;
    entry_edge = k;
    return true;
  }
  return false;
}

WalkEnd Walker::advance(Walk& walk, double length_px) const {
  double rest = length_px;
  int entry_edge = none;
  for (int crossing = 0; crossing < most_crossings; ++crossing) {
    const double front = walk.facing * facing_at(walk.on);
    if (!(front > 0)) return WalkEnd::silhouette;
    const Rates step = rates_along_middle(walk, entry_edge, rest);
    if (step.exit_edge == none) return WalkEnd::edge;
    const double reach = rest / std::max(step.px, 1e-300);
    double length = std::min(step.exit, reach);

    SurfacePoint next = walk.on;
    const auto move = [&](double by) {
      set_weights(next, walk.on.b1 + by * step.change[1], walk.on.b2 + by * step.change[2]);
    };
    move(length);
    const double front_after = walk.facing * facing_at(next);
    if (!(front_after > 0)) move(length * front / (front - front_after));
    walk.on = next;
    walk.tangent = step.direction;
    if (!(front_after > 0)) return WalkEnd::silhouette;
    if (reach <= step.exit) return WalkEnd::whole;
    rest -= length * step.px;
    if (!cross_edge(walk, step.exit_edge, entry_edge)) return WalkEnd::edge;
  }
  return WalkEnd::edge;
}

}  // namespace illustrate
