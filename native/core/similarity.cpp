#include "core/similarity.h"

#include <cmath>

#include "core/tolerances.h"

namespace illustrate {

std::optional<Similarity> as_similarity(const Mat4& map) {
  const Mat3 linear = map.topLeftCorner<3, 3>();
  const double volume = linear.determinant();
  if (!map.allFinite() || !(volume > 0)) return {};
  const double scale = std::cbrt(volume);
  const Mat3 nearly = linear / scale;
  const double off = (nearly.transpose() * nearly - Mat3::Identity()).cwiseAbs().maxCoeff();
  if (off > tolerance::similarity) return {};
  // The nearest rotation: what single precision left of the matrix is none to the last bit.
  const Eigen::JacobiSVD<Mat3> svd(nearly, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return Similarity{svd.matrixU() * svd.matrixV().transpose(), scale, map.topRightCorner<3, 1>()};
}

}  // namespace illustrate
