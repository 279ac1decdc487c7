// The camera: perspective and orthographic as one homogeneous viewpoint (paper section 4.3).
#pragma once

#include "core/types.h"

namespace illustrate {

// Depth is the distance along the viewing axis, world units, larger is farther.
struct ImagePoint {
  Vec2 xy;  // px, y down
  double depth;
};

class Camera {
 public:
  // projection: clip from view, view: view from world, both in OpenGL's convention (the camera
  // looks down -z, the near plane is z = -w). Throws InvalidInput for matrices that are not finite
  // or not a camera's, and sizes below 1.
  Camera(const Mat4& projection, const Mat4& view, int width_px, int height_px);

  // Whole numbers but for `in_units_of`.
  double width_px() const { return width_; }
  double height_px() const { return height_; }
  const Mat4& projection() const { return projection_; }
  const Mat4& view() const { return view_; }

  bool is_perspective() const { return eye_[3] != 0; }
  // (eye, 1), or (unit direction to the eye, 0): p is on the contour when normal . to_eye(p) is 0.
  const Vec4& viewpoint() const { return eye_; }

  // The same view with image lengths in units of so many pixels in place of pixels.
  Camera in_units_of(double pixels) const;

  // From p towards the eye, not normalised in perspective: eye - p, or the constant direction.
  Vec3 to_eye(const Vec3& p) const {
    return is_perspective() ? Vec3(eye_.head<3>() - p) : Vec3(eye_.head<3>());
  }

  double depth(const Vec3& p) const { return -(view_.row(2) * p.homogeneous()).value(); }

  // Only for points before the near plane (`near_distance` > 0).
  ImagePoint project(const Vec3& p) const {
    const Vec4 clip = clip_ * p.homogeneous();
    return {Vec2((clip[0] / clip[3] + 1) / 2 * width_, (1 - clip[1] / clip[3]) / 2 * height_),
            depth(p)};
  }

  // How the image of p moves when p moves along d: px per unit of d.
  Vec2 project_direction(const Vec3& p, const Vec3& d) const;

  // Clip-space distance to the near plane, z + w: linear in p, positive where p can be seen.
  double near_distance(const Vec3& p) const { return near_plane().dot(p.homogeneous()); }
  Vec4 near_plane() const { return clip_.row(2) + clip_.row(3); }

  // How far along to_eye(p) (in units of its length) the near plane is: where a ray to the eye
  // ends.
  double ray_end(const Vec3& p) const;

  // World length of one pixel across the view at the depth of p.
  double pixel_size(const Vec3& p) const;
  // The same for each unit of what the map to the image (view/image_map.h) divides by.
  double pixel_per_w() const;

 private:
  Mat4 projection_, view_, clip_;  // clip_ = projection_ * view_
  Vec4 eye_;
  double width_, height_;
};

}  // namespace illustrate
