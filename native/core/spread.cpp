#include "core/spread.h"

#include <algorithm>
#include <cmath>

namespace illustrate {

void Spread::add(const Vec3& a, const Vec3& b, const Vec3& c) {
  if (area_ == 0) origin_ = a.cast<long double>();
  const Wide p = a.cast<long double>() - origin_, q = b.cast<long double>() - origin_,
             r = c.cast<long double>() - origin_, sum = p + q + r;
  const long double area = (q - p).cross(r - p).norm() / 2;
  area_ += area;
  sum_ += area / 3 * sum;
  squares_ += area / 12 * (p.squaredNorm() + q.squaredNorm() + r.squaredNorm() + sum.squaredNorm());
}

// Along a side of length l points spread evenly have the variance l^2 / 12.
double Spread::diagonal() const {
  if (!(area_ > 0)) return 0;
  const long double variance = squares_ / area_ - (sum_ / area_).squaredNorm();
  return static_cast<double>(std::sqrt(12 * std::max(variance, 0.0L)));
}

double rounding_size(double size, double distance) {
  constexpr double far_off = 128;
  const double octaves = distance / (far_off * size);
  return octaves > 1 ? std::ldexp(size, std::ilogb(octaves) + 1) : size;
}

}  // namespace illustrate
