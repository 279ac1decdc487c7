// World points to homogeneous image points: linear, so that triangles can be worked on before the
// division.
#pragma once

#include "view/camera.h"

namespace illustrate {

// (x w, y w, w) in pixels = image_map(camera) * (p, 1); w > 0 before the eye.
using ImageMap = Eigen::Matrix<double, 3, 4>;

inline ImageMap image_map(const Camera& camera) {
  const Mat4 clip = camera.projection() * camera.view();
  ImageMap map;
  map.row(0) = (clip.row(0) + clip.row(3)) * (camera.width_px() / 2.0);
  map.row(1) = (clip.row(3) - clip.row(1)) * (camera.height_px() / 2.0);
  map.row(2) = clip.row(3);
  return map;
}

inline Vec3 apply(const ImageMap& map, const Vec3& p) { return map.leftCols<3>() * p + map.col(3); }

}  // namespace illustrate
