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

// A determinant in plain arithmetic and the sum of its terms' magnitudes, to which its error is
// relative.
struct PlainDeterminant {
  double value = 0;
  double permanent = 0;
};

PlainDeterminant plain_determinant(const Vec3& u, const Vec3& v, const Vec3& w) {
  const double vxwy = v.x() * w.y(), wxvy = w.x() * v.y();
  const double wxuy = w.x() * u.y(), uxwy = u.x() * w.y();
  const double uxvy = u.x() * v.y(), vxuy = v.x() * u.y();
  return {u.z() * (vxwy - wxvy) + v.z() * (wxuy - uxwy) + w.z() * (uxvy - vxuy),
          (std::abs(vxwy) + std::abs(wxvy)) * std::abs(u.z()) +
              (std::abs(wxuy) + std::abs(uxwy)) * std::abs(v.z()) +
              (std::abs(uxvy) + std::abs(vxuy)) * std::abs(w.z())};
}

int exact_orient3d(const std::array<Vec3, 4>& p) {
  return sign_of(determinant(exact_difference(p[0], p[3]), exact_difference(p[1], p[3]),
                             exact_difference(p[2], p[3])));
}

bool any_equal(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return a == b || a == c || a == d || b == c || b == d || c == d;
}

}  // namespace

int sign_of_difference(double a, double b, double c, double d) {
  // Rounding keeps order, so unequal rounded products decide; equal ones leave it to their errors.
  const double ab = a * b, cd = c * d;
  if (ab != cd) return ab > cd ? 1 : -1;
  const double ab_error = std::fma(a, b, -ab), cd_error = std::fma(c, d, -cd);
  return (ab_error > cd_error) - (ab_error < cd_error);
}

int filtered_orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const PlainDeterminant det = plain_determinant(a - d, b - d, c - d);
  return std::abs(det.value) > orient3d_error * det.permanent ? sign_of(det.value) : 0;
}

int orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const PlainDeterminant det = plain_determinant(a - d, b - d, c - d);
  if (std::abs(det.value) > orient3d_error * det.permanent) return sign_of(det.value);
  if (det.permanent == 0 || any_equal(a, b, c, d)) return 0;
  return exact_orient3d({a, b, c, d});
}

}  // namespace illustrate
