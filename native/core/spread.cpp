#include "core/spread.h"

#include <algorithm>
#include <cmath>

namespace illustrate {

void Spread::add(const Vec3& a, const Vec3& b, const Vec3& c) {
  if (area_ == 0) measure_from(a, b, c);
  const Vec3 p = per_unit_ * (a - origin_), q = per_unit_ * (b - origin_),
             r = per_unit_ * (c - origin_), sum = p + q + r;
  const double area = (q - p).cross(r - p).norm() / 2;
  area_ += area;
  sum_ += area / 3 * sum;
  squares_ += area / 12 * (p.squaredNorm() + q.squaredNorm() + r.squaredNorm() + sum.squaredNorm());
}

void Spread::measure_from(const Vec3& a, const Vec3& b, const Vec3& c) {
  origin_ = a;
  const double size = std::max((b - a).cwiseAbs().maxCoeff(), (c - a).cwiseAbs().maxCoeff());
  per_unit_ = size > 0 ? std::ldexp(1., -std::ilogb(size)) : 1;
}

// Along a side of length l points spread evenly have the variance l^2 / 12.
double Spread::diagonal() const {
  if (!(area_ > 0)) return 0;
  const double variance = squares_ / area_ - (sum_ / area_).squaredNorm();
  return std::sqrt(12 * std::max(variance, 0.0)) / per_unit_;
}

Vec3 Spread::middle() const {
  if (!(area_ > 0)) return origin_;
  return origin_ + sum_ / (area_ * per_unit_);
}

double rounding_size(double size, double distance) {
  constexpr double far_off = 128;
  const double octaves = distance / (far_off * size);
  return octaves > 1 ? std::ldexp(size, std::ilogb(octaves) + 1) : size;
}

}  // namespace illustrate
