#include "tone/area_light.h"

#include <algorithm>
#include <cmath>

#include "core/pi.h"

namespace illustrate {
namespace {

constexpr int ellipse_sides = 24;
constexpr int spread_samples = 6;  // along each side of an area

// A convex polygon, seen from the point that is lit; clipping adds at most one corner.
struct Polygon {
  std::array<Vec3, ellipse_sides + 1> corners;
  int count = 0;

  void add(const Vec3& corner) { corners[idx(count++)] = corner; }
};

Polygon outline(const Light& light, const Vec3& seen_from) {
  const Vec3 centre = light.vector - seen_from;
  Polygon polygon;
  if (!light.ellipse) {
    for (const auto& [u, v] : {std::pair{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}) {
      polygon.add(centre + u * light.edge_u + v * light.edge_v);
    }
    return polygon;
  }
  constexpr double step = 2 * pi / ellipse_sides;
  const double radius = 0.5 * std::sqrt(step / std::sin(step));  // the ellipse's own area
  for (int k = 0; k < ellipse_sides; ++k) {
    polygon.add(centre +
                radius * (std::cos(k * step) * light.edge_u + std::sin(k * step) * light.edge_v));
  }
  return polygon;
}

Polygon above_horizon(const Polygon& polygon, const Vec3& normal) {
  Polygon part;
  for (int k = 0; k < polygon.count; ++k) {
    const Vec3& a = polygon.corners[idx(k)];
    const Vec3& b = polygon.corners[idx(k + 1 == polygon.count ? 0 : k + 1)];
    const double at_a = a.dot(normal), at_b = b.dot(normal);
    if (at_a >= 0) part.add(a);
    if ((at_a < 0) != (at_b < 0)) part.add(a + at_a / (at_a - at_b) * (b - a));
  }
  return part;
}

// Lambert's sum over the sides: the angle each is seen under, times the cosine between the normal
// and the plane through the side and the point.
double lambert_sum(const Polygon& polygon, const Vec3& normal) {
  double sum = 0;
  for (int k = 0; k < polygon.count; ++k) {
    const Vec3& a = polygon.corners[idx(k)];
    const Vec3& b = polygon.corners[idx(k + 1 == polygon.count ? 0 : k + 1)];
    const Vec3 across = a.cross(b);
    const double sine = across.norm();
    if (sine > 0) sum += std::atan2(sine, a.dot(b)) * across.dot(normal) / sine;
  }
  return std::abs(sum) / 2;
}

double area_of(const Light& light) {
  const double rectangle = light.edge_u.cross(light.edge_v).norm();
  return light.ellipse ? rectangle * pi / 4 : rectangle;
}

// From [-1, 1]^2 to the unit disk, squares about the centre to circles about it (Shirley and Chiu).
Vec2 on_disk(double x, double y) {
  const bool is_wide = std::abs(x) > std::abs(y);
  const double radius = is_wide ? x : y;
  if (radius == 0) return Vec2::Zero();
  const double angle = is_wide ? pi / 4 * (y / x) : pi / 2 - pi / 4 * (x / y);
  return radius * Vec2(std::cos(angle), std::sin(angle));
}

}  // namespace

double mean_form_factor(const Light& light, const Vec3& position, const Vec3& normal) {
  if (light.direction.dot(position - light.vector) <= 0) return 0;
  return lambert_sum(above_horizon(outline(light, position), normal), normal) / area_of(light);
}

double spread_share(const Light& light, double cosine) {
  const double half = light.spread_rad / 2, slats = std::tan(half);
  if (half >= pi / 2 || slats <= 0) return 1;
  const double tangent = std::sqrt(std::max(0.0, 1 - cosine * cosine)) / std::max(cosine, 1e-12);
  // Where tan x - x would lose all digits, its series.
  const double left = half < 1e-3 ? half * half * half / 3 : slats - half;
  return std::max(0.0, slats - tangent) / left;
}

double mean_spread_share(const Light& light, const Vec3& position, const Vec3& normal) {
  if (light.spread_rad >= pi) return 1;
  const Vec3 axis = light.direction.normalized();
  double sent = 0, all = 0;
  for (int i = 0; i < spread_samples; ++i) {
    for (int j = 0; j < spread_samples; ++j) {
      const Vec3 ray =
          position - point_on(light, (i + 0.5) / spread_samples, (j + 0.5) / spread_samples);
      const double square = ray.squaredNorm(), cosine = ray.dot(axis) / std::sqrt(square);
      const double weight =
          std::max(0.0, -ray.dot(normal)) * std::max(0.0, cosine) / (square * std::sqrt(square));
      if (!(weight > 0)) continue;
      all += weight;
      sent += weight * spread_share(light, cosine);
    }
  }
  return all > 0 ? sent / all : 0;
}

Vec3 point_on(const Light& light, double u, double v) {
  const Vec2 place = light.ellipse ? on_disk(2 * u - 1, 2 * v - 1) : Vec2(2 * u - 1, 2 * v - 1);
  return light.vector + 0.5 * (place.x() * light.edge_u + place.y() * light.edge_v);
}

}  // namespace illustrate
