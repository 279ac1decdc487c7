#include "core/predicates.h"

#include <cmath>
#include <limits>

namespace illustrate {
namespace {

// A sum of doubles that do not overlap, smallest first, none zero: the last one has the sum's sign.
using Expansion = std::vector<double>;
using ExactRow = std::array<Expansion, 3>;

constexpr double unit_roundoff = std::numeric_limits<double>::epsilon() / 2;

// Shewchuk's bound on the error of the plain determinant, relative to its permanent.
constexpr double orient3d_error = (7 + 56 * unit_roundoff) * unit_roundoff;

int sign_of(double value) { return (value > 0) - (value < 0); }

int sign_of(const Expansion& e) { return e.empty() ? 0 : sign_of(e.back()); }

// a + b = sum + error, exactly.
void two_sum(double a, double b, double& sum, double& error) {
  sum = a + b;
  const double b_virtual = sum - a;
  error = (a - (sum - b_virtual)) + (b - b_virtual);
}

void add(Expansion& e, double value) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < e.size(); ++i) {
    double error;
    two_sum(value, e[i], value, error);
    if (error != 0) e[kept++] = error;
  }
  e.resize(kept);
  if (value != 0) e.push_back(value);
}

Expansion difference(double a, double b) {
  Expansion e;
  add(e, a);
  add(e, -b);
  return e;
}

// sum += sign * e * f
void add_product(Expansion& sum, const Expansion& e, const Expansion& f, double sign) {
  for (const double a : e)
    for (const double b : f) {
      const double product = a * b;
      add(sum, sign * std::fma(a, b, -product));
      add(sum, sign * product);
    }
}

Expansion determinant(const ExactRow& a, const ExactRow& b, const ExactRow& c) {
  Expansion sum;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    Expansion minor;
    add_product(minor, b[j], c[k], 1);
    add_product(minor, b[k], c[j], -1);
    add_product(sum, a[i], minor, 1);
  }
  return sum;
}

ExactRow exact_difference(const Vec3& a, const Vec3& b) {
  return {difference(a.x(), b.x()), difference(a.y(), b.y()), difference(a.z(), b.z())};
}

// The sign that plain arithmetic is sure of, else 0.
int filtered_orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 u = a - d, v = b - d, w = c - d;
  const double vxwy = v.x() * w.y(), wxvy = w.x() * v.y();
  const double wxuy = w.x() * u.y(), uxwy = u.x() * w.y();
  const double uxvy = u.x() * v.y(), vxuy = v.x() * u.y();
  const double det = u.z() * (vxwy - wxvy) + v.z() * (wxuy - uxwy) + w.z() * (uxvy - vxuy);
  const double permanent = (std::abs(vxwy) + std::abs(wxvy)) * std::abs(u.z()) +
                           (std::abs(wxuy) + std::abs(uxwy)) * std::abs(v.z()) +
                           (std::abs(uxvy) + std::abs(vxuy)) * std::abs(w.z());
  return std::abs(det) > orient3d_error * permanent ? sign_of(det) : 0;
}

int exact_orient3d(const std::array<Vec3, 4>& p) {
  return sign_of(determinant(exact_difference(p[0], p[3]), exact_difference(p[1], p[3]),
                             exact_difference(p[2], p[3])));
}

Expansion& operator+=(Expansion& sum, const Expansion& e) {
  for (const double value : e) add(sum, value);
  return sum;
}

}  // namespace

int sign_of_difference(double a, double b, double c, double d) {
  // Rounding keeps order, so unequal rounded products decide; equal ones leave it to their errors.
  const double ab = a * b, cd = c * d;
  if (ab != cd) return ab > cd ? 1 : -1;
  const double ab_error = std::fma(a, b, -ab), cd_error = std::fma(c, d, -cd);
  return (ab_error > cd_error) - (ab_error < cd_error);
}

int orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const int sign = filtered_orient3d(a, b, c, d);
  return sign != 0 ? sign : exact_orient3d({a, b, c, d});
}

int orient3d(const std::array<Vec3, 4>& points, const std::array<Vec3, 4>& motions) {
  if (const int sign = orient3d(points[0], points[1], points[2], points[3])) return sign;
  // det(p + s m) is a cubic in s: the sum over all choices of p or m in each row. Its lowest
  // coefficient that is not zero decides.
  std::array<ExactRow, 3> p, m;
  for (std::size_t i = 0; i < 3; ++i) {
    p[i] = exact_difference(points[i], points[3]);
    m[i] = exact_difference(motions[i], motions[3]);
  }
  Expansion linear = determinant(m[0], p[1], p[2]);
  linear += determinant(p[0], m[1], p[2]);
  linear += determinant(p[0], p[1], m[2]);
  if (!linear.empty()) return sign_of(linear);
  Expansion square = determinant(p[0], m[1], m[2]);
  square += determinant(m[0], p[1], m[2]);
  square += determinant(m[0], m[1], p[2]);
  if (!square.empty()) return sign_of(square);
  return sign_of(determinant(m[0], m[1], m[2]));
}

}  // namespace illustrate
