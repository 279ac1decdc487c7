#include "surface/jets/local_jet.h"

#include <algorithm>
#include <cmath>

#include "mesh/polygons.h"

namespace illustrate {
namespace {

// Points that a polynomial of degree 4 and 3 needs to be well determined (it has 15 and 10
// coefficients).
constexpr std::size_t points_for_quartic = 22, points_for_cubic = 13;
// Added to the diagonal, relative to the number of points: a fit that is not determined gets the
// smallest.
constexpr double ridge = 1e-12;

constexpr int coefficient_count(int degree) { return (degree + 1) * (degree + 2) / 2; }

// Number of the monomial x^i y^j among those of degree i + j and below.
constexpr int monomial(int i, int j) { return (i + j) * (i + j + 1) / 2 + j; }

// Sums over the points of all monomials that the normal equations of a fit of this degree need.
template <int degree>
struct Moments {
  static constexpr int count = coefficient_count(2 * degree);
  std::array<double, idx(count)> powers{};
  std::array<double, idx(coefficient_count(degree))> heights{};

  void add(const Vec3& p, double weight) {
    std::array<double, idx(count)> m;
    m[0] = weight;
    int filled = 1;
    for (int d = 1, previous = 0; d <= 2 * degree; ++d) {
      for (int k = 0; k < d; ++k) m[idx(filled + k)] = p.x() * m[idx(previous + k)];
      m[idx(filled + d)] = p.y() * m[idx(previous + d - 1)];
      previous = filled;
      filled += d + 1;
    }
    for (std::size_t k = 0; k < m.size(); ++k) powers[k] += m[k];
    for (std::size_t k = 0; k < heights.size(); ++k) heights[k] += p.z() * m[k];
  }
};

// Solves a symmetric positive definite system in place by L D L^T; the right-hand side becomes the
// solution.
template <int n>
void solve(double (&a)[n][n], std::array<double, idx(n)>& b) {
  constexpr double smallest_pivot = 1e-14;  // below the ridge: only rounding gets here
  for (int j = 0; j < n; ++j) {
    for (int k = 0; k < j; ++k) {
      const double scaled = a[j][k] * a[k][k];
      for (int i = j; i < n; ++i) a[i][j] -= a[i][k] * scaled;
    }
    a[j][j] = std::max(a[j][j], smallest_pivot);
    for (int i = j + 1; i < n; ++i) a[i][j] /= a[j][j];
  }
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < i; ++k) b[idx(i)] -= a[i][k] * b[idx(k)];
  }
  for (int i = n - 1; i >= 0; --i) {
    b[idx(i)] /= a[i][i];
    for (int k = i + 1; k < n; ++k) b[idx(i)] -= a[k][i] * b[idx(k)];
  }
}

// The first six coefficients: 1, x, y, x^2, xy, y^2.
using Quadric = std::array<double, 6>;

// Normal equations: on irregular ellipsoids and saddles as exact as an orthogonal factorisation
// (.02 and .05 % off), in a twentieth of its time.
template <int degree>
Quadric fit_polynomial(const Points& points, double falloff) {
  constexpr int n = coefficient_count(degree);
  Moments<degree> moments;
  for (const Vec3& p : points) moments.add(p, 1 - falloff * p.squaredNorm());
  double matrix[n][n];
  for (int di = 0, r = 0; di <= degree; ++di) {
    for (int j = 0; j <= di; ++j, ++r) {
      for (int dk = 0, c = 0; dk <= di; ++dk) {
        for (int l = 0; l <= dk; ++l, ++c) {
          matrix[r][c] = moments.powers[idx(monomial(di - j + dk - l, j + l))];
        }
      }
    }
  }
  for (int i = 0; i < n; ++i) matrix[i][i] += ridge * static_cast<double>(points.size());
  solve<n>(matrix, moments.heights);
  Quadric result;
  std::copy_n(moments.heights.begin(), result.size(), result.begin());
  return result;
}

Quadric fit_polynomial(const Points& points, double falloff, int most_degree) {
  if (most_degree >= 4 && points.size() >= points_for_quartic)
    return fit_polynomial<4>(points, falloff);
  if (most_degree >= 3 && points.size() >= points_for_cubic)
    return fit_polynomial<3>(points, falloff);
  return fit_polynomial<2>(points, falloff);
}

}  // namespace

void LocalJet::take(const Surface& surface, const std::vector<int>& vertices) {
  const Vec3& origin = surface.positions[idx(vertices.front())];
  normal_ = surface.normals[idx(vertices.front())];
  x_ = any_tangent(normal_);
  y_ = normal_.cross(x_);
  radius_ = 0;
  for (const int v : vertices) {
    radius_ = std::max(radius_, (surface.positions[idx(v)] - origin).norm());
  }
  if (!(radius_ > 0) || !std::isfinite(radius_)) radius_ = 1;
  points_.clear();
  for (const int v : vertices) {
    const Vec3 d = (surface.positions[idx(v)] - origin) / radius_;
    points_.emplace_back(d.dot(x_), d.dot(y_), d.dot(normal_));
  }
}

PrincipalCurvature LocalJet::fit(int most_degree, bool exact_normal, double falloff) const {
  const Quadric q = fit_polynomial(points_, falloff, most_degree);
  const Vec3 du(1, 0, q[1]), dv(0, 1, q[2]), fitted = du.cross(dv).normalized();
  const Vec3 z = Vec3::UnitZ() / radius_;
  PrincipalCurvature k = principal_curvature(du, dv, 2 * q[3] * z, q[4] * z, 2 * q[5] * z, fitted);
  const Vec3 plane =
      exact_normal ? normal_ : Vec3(fitted.x() * x_ + fitted.y() * y_ + fitted.z() * normal_);
  const Vec3 direction = k.w1.x() * x_ + k.w1.y() * y_ + k.w1.z() * normal_;
  k.w1 = tangent_towards(direction, plane);
  k.w2 = plane.cross(k.w1);
  return k;
}

void thin(std::vector<int>& vertices, std::size_t most) {
  if (vertices.size() <= most) return;
  const std::size_t stride = (vertices.size() + most - 1) / most;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < vertices.size(); i += stride) vertices[kept++] = vertices[i];
  vertices.resize(kept);
}

}  // namespace illustrate
