// Cameras for tests.
#pragma once

#include <cmath>

#include "view/camera.h"

namespace illustrate::cameras {

inline Mat4 look_at(const Vec3& eye, const Vec3& target) {
  const Vec3 back = (eye - target).normalized();
  const Vec3 up = std::abs(back.z()) < 0.99 ? Vec3::UnitZ() : Vec3::UnitY();
  const Vec3 right = up.cross(back).normalized();
  Mat4 view = Mat4::Identity();
  view.row(0).head<3>() = right;
  view.row(1).head<3>() = back.cross(right);
  view.row(2).head<3>() = back;
  view.topRightCorner<3, 1>() = -view.topLeftCorner<3, 3>() * eye;
  return view;
}

// Half the image's height shows `half_height` world units.
inline Camera orthographic(const Vec3& direction, double half_height, int size = 1000) {
  const double far = 100 * half_height;
  Mat4 projection = Mat4::Identity();
  projection(0, 0) = projection(1, 1) = 1 / half_height;
  projection(2, 2) = -2 / far;
  projection(2, 3) = -1;
  return {projection, look_at(direction.normalized() * far / 2, Vec3::Zero()), size, size};
}

// From above; a world unit is a pixel.
inline const Camera one_px = orthographic(Vec3(0, 0, 1), 500);

inline Camera perspective(const Vec3& eye, const Vec3& target, double near = 0.1,
                          double fov_deg = 40, int size = 1000) {
  const double far = 1000, focal = 1 / std::tan(fov_deg * 3.141592653589793 / 360);
  Mat4 projection = Mat4::Zero();
  projection(0, 0) = projection(1, 1) = focal;
  projection(2, 2) = -(far + near) / (far - near);
  projection(2, 3) = -2 * far * near / (far - near);
  projection(3, 2) = -1;
  return {projection, look_at(eye, target), size, size};
}

}  // namespace illustrate::cameras
