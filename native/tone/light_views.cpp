#include "tone/light_views.h"

#include <cmath>

namespace illustrate {
namespace {

constexpr int width_px = 1024;
// What is nearer to a lamp than this share of the scene's diagonal casts no shadow that is drawn:
// its own bulb.
constexpr double nearest = 1e-3;

// backward: unit, away from what the camera looks at.
Mat4 view_from(const Vec3& position, const Vec3& backward) {
  const Vec3 right = backward.unitOrthogonal(), up = backward.cross(right);
  Mat4 view = Mat4::Identity();
  view.block<1, 3>(0, 0) = right.transpose();
  view.block<1, 3>(1, 0) = up.transpose();
  view.block<1, 3>(2, 0) = backward.transpose();
  view.block<3, 1>(0, 3) = -view.block<3, 3>(0, 0) * position;
  return view;
}

Camera far_view(const Vec3& towards, const Eigen::AlignedBox3d& seen) {
  const double radius = seen.diagonal().norm() / 2;
  const Vec3 backward = towards.normalized();
  Mat4 projection = Mat4::Identity();
  projection(0, 0) = projection(1, 1) = 1 / radius;
  projection(2, 2) = -1 / (2 * radius);
  return {projection, view_from(seen.center() + 2 * radius * backward, backward), width_px,
          width_px};
}

std::vector<Camera> views_all_round(const Vec3& position, const Eigen::AlignedBox3d& seen) {
  const double near = nearest * seen.diagonal().norm();
  const double far = near + seen.diagonal().norm() + (seen.center() - position).norm();
  Mat4 projection = Mat4::Zero();
  projection(0, 0) = projection(1, 1) = 1;  // 90 degrees across
  projection(2, 2) = -(far + near) / (far - near);
  projection(2, 3) = -2 * far * near / (far - near);
  projection(3, 2) = -1;
  std::vector<Camera> views;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {1., -1.}) {
      views.emplace_back(projection, view_from(position, sign * Vec3::Unit(axis)), width_px,
                         width_px);
    }
  }
  return views;
}

}  // namespace

std::vector<Camera> light_views(const Light& light, const Camera& camera,
                                const Eigen::AlignedBox3d& seen) {
  if (seen.isEmpty() || !(seen.diagonal().norm() > 0)) return {};
  switch (light.kind) {
    case LightKind::head:
    case LightKind::ambient:
      return {};
    case LightKind::sun:
      return {far_view(light.vector, seen)};
    case LightKind::side:
      return {far_view(side_direction(light, camera), seen)};
    default:
      return views_all_round(light.vector, seen);
  }
}

bool shines_at(const Light& light, const Vec3& p) {
  const Vec3 away = p - light.vector;
  if (light.kind == LightKind::area) return away.dot(light.direction) > 0;
  if (light.kind != LightKind::spot) return true;
  return away.dot(light.direction) >
         std::cos(light.angle_rad) * away.norm() * light.direction.norm();
}

}  // namespace illustrate
