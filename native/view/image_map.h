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

// How a world direction shows in the image, px per world unit, where it is seen at `image`; `w`:
// the last of what the map gives there.
inline Vec2 image_direction(const ImageMap& map, const Vec2& image, double w,
                            const Vec3& direction) {
  const Vec3 change = map.leftCols<3>() * direction;
  return (change.head<2>() - image * change[2]) / w;
}

}  // namespace illustrate
