#include "view/camera.h"

#include <cmath>
#include <limits>

#include "core/errors.h"

namespace illustrate {
namespace {

// The point that three planes of homogeneous 4-space share: their generalised cross product.
Vec4 common_point(const Vec4& a, const Vec4& b, const Vec4& c) {
  Vec4 result;
  for (int i = 0; i < 4; ++i) {
    Eigen::Matrix3d minor;
    for (int j = 0, column = 0; j < 4; ++j) {
      if (j != i) minor.col(column++) = Vec3(a[j], b[j], c[j]);
    }
    result[i] = (i % 2 ? -1 : 1) * minor.determinant();
  }
  return result;
}

// Everything that projects to the image with x = y = w = 0 is the eye.
Vec4 viewpoint_of(const Mat4& clip, const Mat4& view) {
  Vec4 eye = common_point(clip.row(0), clip.row(1), clip.row(3));
  const double length = eye.head<3>().norm();
  if (!(eye.norm() > 0) || !eye.allFinite()) throw InvalidInput("camera.projection is singular");
  // What only rounding keeps from infinity is there: an orthographic camera.
  if (std::abs(eye[3]) > 1e-12 * length * view.topLeftCorner<3, 3>().norm()) return eye / eye[3];
  eye /= length;
  eye[3] = 0;
  // A direction at infinity may come with either sign: clip z grows away from the eye.
  const double towards_far = clip.row(2).head<3>().dot(eye.head<3>());
  return towards_far > 0 ? Vec4(-eye) : eye;
}

}  // namespace

Camera::Camera(const Mat4& projection, const Mat4& view, int width_px, int height_px)
    : projection_(projection),
      view_(view),
      clip_(projection * view),
      width_(width_px),
      height_(height_px) {
  if (!projection.allFinite())
    throw InvalidInput("camera.projection has values that are not finite");
  if (!view.allFinite()) throw InvalidInput("camera.view has values that are not finite");
  if (width_px < 1) throw InvalidInput("camera.width_px must be at least 1");
  if (height_px < 1) throw InvalidInput("camera.height_px must be at least 1");
  if (!(std::abs(view.topLeftCorner<3, 3>().determinant()) > 0)) {
    throw InvalidInput("camera.view is singular");
  }
  eye_ = viewpoint_of(clip_, view_);
}

Camera Camera::in_units_of(double pixels) const {
  Camera result = *this;
  result.width_ /= pixels;
  result.height_ /= pixels;
  return result;
}

Vec2 Camera::project_direction(const Vec3& p, const Vec3& d) const {
  const Vec4 clip = clip_ * p.homogeneous(), moved = clip_.leftCols<3>() * d;
  const double w = clip[3] * clip[3];
  return {(moved[0] * clip[3] - clip[0] * moved[3]) / w / 2 * width_,
          -(moved[1] * clip[3] - clip[1] * moved[3]) / w / 2 * height_};
}

double Camera::ray_end(const Vec3& p) const {
  const Eigen::RowVector4d plane = clip_.row(2) + clip_.row(3);
  const double slope = -plane.head<3>().dot(to_eye(p));
  const double end = near_distance(p) / slope;
  if (slope > 0) return end;
  // The near plane is not met: in perspective the ray ends at the eye.
  return is_perspective() ? 1 : std::numeric_limits<double>::infinity();
}

double Camera::pixel_size(const Vec3& p) const {
  const double w = (clip_.row(3) * p.homogeneous()).value();
  return 2 * std::abs(w) / (clip_.row(1).head<3>().norm() * height_);
}

double Camera::pixel_per_w() const { return 2 / (clip_.row(1).head<3>().norm() * height_); }

}  // namespace illustrate
