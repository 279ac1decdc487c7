#include "core/similarity.h"

#include <algorithm>
#include <cmath>

#include "core/tolerances.h"

namespace illustrate {
namespace {

Vec3 middle(const Points& points) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& p : points) sum += p;
  return sum / static_cast<double>(points.size());
}

double size(const Points& points) {
  Eigen::AlignedBox3d box;
  for (const Vec3& p : points) box.extend(p);
  return box.diagonal().norm();
}

// Whether a few distances are what they were: few motions that bend anything get past it.
bool may_be_rigid(const Points& from, const Points& to, double tolerance) {
  constexpr std::size_t asked = 16;
  const std::size_t stride = std::max<std::size_t>(1, from.size() / asked);
  for (std::size_t i = 0, j = from.size() / 2; i < from.size(); i += stride, j = i) {
    const double before = (from[i] - from[j]).norm(), now = (to[i] - to[j]).norm();
    if (!(std::abs(now - before) <= 2 * tolerance)) return false;
  }
  return true;
}

// Without a mirror.
Mat3 nearest_rotation(const Mat3& map) {
  const Eigen::JacobiSVD<Mat3> svd(map, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Mat3 u = svd.matrixU();
  if ((u * svd.matrixV().transpose()).determinant() < 0) u.col(2) *= -1;
  return u * svd.matrixV().transpose();
}

Similarity nearest_motion(const Points& from, const Points& to) {
  const Vec3 start = middle(from), end = middle(to);
  Mat3 products = Mat3::Zero();
  for (std::size_t i = 0; i < from.size(); ++i) {
    products += (to[i] - end) * (from[i] - start).transpose();
  }
  const Mat3 rotation = nearest_rotation(products);
  return {rotation, 1, end - rotation * start};
}

}  // namespace

std::optional<Similarity> as_similarity(const Mat4& map) {
  const Mat3 linear = map.topLeftCorner<3, 3>();
  const double volume = linear.determinant();
  if (!map.allFinite() || !(volume > 0)) return {};
  const double scale = std::cbrt(volume);
  const Mat3 nearly = linear / scale;
  const double off = (nearly.transpose() * nearly - Mat3::Identity()).cwiseAbs().maxCoeff();
  if (off > tolerance::similarity) return {};
  // What single precision left of the matrix is no rotation to the last bit.
  return Similarity{nearest_rotation(nearly), scale, map.topRightCorner<3, 1>()};
}

std::optional<Similarity> rigid_motion(const Points& from, const Points& to) {
  if (from == to) return Similarity();
  if (from.size() != to.size()) return {};
  const double tolerance = tolerance::similarity * size(from);
  if (!may_be_rigid(from, to, tolerance)) return {};
  const Similarity motion = nearest_motion(from, to);
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (!((motion.point(from[i]) - to[i]).norm() <= tolerance)) return {};
  }
  return motion;
}

}  // namespace illustrate
