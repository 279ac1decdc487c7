#include "surface/jet.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/parallel.h"
#include "surface/polygons.h"

namespace illustrate {
namespace {

// Enough for three rings of a regular mesh three times over; beyond it points are taken by stride.
constexpr std::size_t most_points = 100;
// Of a vertex with very many neighbours only so many are followed, by stride.
constexpr std::size_t most_neighbours = 48;
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

  void add(const Vec3& p) {
    std::array<double, idx(count)> m;
    m[0] = 1;
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

template <int degree>
Quadric fit_polynomial(const Points& points) {
  constexpr int n = coefficient_count(degree);
  Moments<degree> moments;
  for (const Vec3& p : points) moments.add(p);
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

// Takes every few of the points, the first always.
void thin(std::vector<int>& found) {
  if (found.size() <= most_points) return;
  const std::size_t stride = (found.size() + most_points - 1) / most_points;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < found.size(); i += stride) found[kept++] = found[i];
  found.resize(kept);
}

}  // namespace

JetFitter::JetFitter(const Surface& surface, int rings)
    : surface_(surface),
      rings_(rings),
      offsets_(surface.positions.size() + 1, 0),
      at_border_(surface.positions.size(), 0) {
  for (const Triangle& t : surface.triangles) {
    for (const int v : t) offsets_[idx(v) + 1] += 2;
  }
  for (std::size_t v = 1; v < offsets_.size(); ++v) offsets_[v] += offsets_[v - 1];
  std::vector<int> cursor(offsets_.begin(), offsets_.end() - 1);
  neighbours_.resize(idx(offsets_.back()));
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    const Triangle& t = surface.triangles[i];
    for (int k = 0; k < 3; ++k) {
      const int a = t[idx(k)], b = t[idx(next_corner(k))];
      neighbours_[idx(cursor[idx(a)]++)] = b;
      neighbours_[idx(cursor[idx(b)]++)] = a;
      const EdgeKind kind = surface.edge_kinds[i][idx(k)];
      if (surface.neighbours[i][idx(k)] != none && kind != EdgeKind::crease) continue;
      at_border_[idx(a)] = at_border_[idx(b)] = 1;
    }
  }
  std::size_t kept = 0;
  for (std::size_t v = 0; v + 1 < offsets_.size(); ++v) {
    const auto begin = neighbours_.begin() + offsets_[v],
               end = neighbours_.begin() + offsets_[v + 1];
    std::sort(begin, end);
    offsets_[v] = static_cast<int>(kept);
    for (auto i = begin; i != end; ++i) {
      if (i == begin || *i != *(i - 1)) neighbours_[kept++] = *i;
    }
  }
  offsets_.back() = static_cast<int>(kept);
}

void JetFitter::gather(int vertex, Workspace& work) const {
  work.visited.resize(surface_.positions.size(), none);
  work.found.assign(1, vertex);
  work.visited[idx(vertex)] = vertex;
  std::size_t from = 0;
  for (int ring = 0; ring < rings_ && work.found.size() < most_points; ++ring) {
    const std::size_t to = work.found.size();
    for (; from < to; ++from) {
      const std::size_t v = idx(work.found[from]);
      const std::size_t count = idx(offsets_[v + 1] - offsets_[v]);
      const std::size_t stride = (count + most_neighbours - 1) / most_neighbours;
      for (std::size_t k = 0; k < count; k += stride) {
        const int n = neighbours_[idx(offsets_[v]) + k];
        if (work.visited[idx(n)] == vertex) continue;
        work.visited[idx(n)] = vertex;
        work.found.push_back(n);
      }
    }
  }
  thin(work.found);
}

PrincipalCurvature JetFitter::fit(int vertex, Workspace& work) const {
  gather(vertex, work);
  const Vec3& origin = surface_.positions[idx(vertex)];
  const Vec3& normal = surface_.normals[idx(vertex)];
  const Vec3 x = any_tangent(normal), y = normal.cross(x);
  double radius = 0;
  for (const int v : work.found) {
    radius = std::max(radius, (surface_.positions[idx(v)] - origin).norm());
  }
  if (!(radius > 0) || !std::isfinite(radius)) radius = 1;
  work.local.clear();
  for (const int v : work.found) {
    const Vec3 d = (surface_.positions[idx(v)] - origin) / radius;
    work.local.emplace_back(d.dot(x), d.dot(y), d.dot(normal));
  }
  const std::size_t points = at_border_[idx(vertex)] ? 0 : work.local.size();
  const Quadric q = points >= points_for_quartic ? fit_polynomial<4>(work.local)
                    : points >= points_for_cubic ? fit_polynomial<3>(work.local)
                                                 : fit_polynomial<2>(work.local);
  const Vec3 du(1, 0, q[1]), dv(0, 1, q[2]), fitted = du.cross(dv).normalized();
  const Vec3 z = Vec3::UnitZ() / radius;
  PrincipalCurvature k = principal_curvature(du, dv, 2 * q[3] * z, q[4] * z, 2 * q[5] * z, fitted);
  // The normal of a limit surface is exact, that of a polygon mesh is worse than the fit's own.
  const bool exact_normal = surface_.object_is_smooth[idx(surface_.objects[idx(vertex)])] != 0;
  const Vec3 plane =
      exact_normal ? normal : Vec3(fitted.x() * x + fitted.y() * y + fitted.z() * normal);
  const Vec3 direction = k.w1.x() * x + k.w1.y() * y + k.w1.z() * normal;
  k.w1 = tangent_towards(direction, plane);
  k.w2 = plane.cross(k.w1);
  return k;
}

void fit_jets(const Surface& surface, const std::vector<int>& vertices, const JetOptions& options,
              const Progress& progress, Curvature& result) {
  progress.report(0);
  if (vertices.empty()) return;
  const JetFitter fitter(surface, options.rings);
  constexpr std::size_t between_reports = 20000;
  const std::size_t n = vertices.size();
  for (std::size_t from = 0; from < n; from += between_reports) {
    progress.report(static_cast<double>(from) / static_cast<double>(n));
    parallel_for(std::min(between_reports, n - from), options.threads,
                 [&](std::size_t begin, std::size_t end) {
                   JetFitter::Workspace work;
                   for (std::size_t i = from + begin; i < from + end; ++i) {
                     const std::size_t v = idx(vertices[i]);
                     const PrincipalCurvature k = fitter.fit(vertices[i], work);
                     result.k1[v] = k.k1;
                     result.k2[v] = k.k2;
                     result.w1[v] = k.w1;
                     result.w2[v] = k.w2;
                   }
                 });
  }
}

Curvature jet_curvature(const Surface& surface, const JetOptions& options,
                        const Progress& progress) {
  const std::size_t n = surface.positions.size();
  Curvature result{std::vector<double>(n), std::vector<double>(n), Points(n), Points(n)};
  std::vector<int> all(n);
  std::iota(all.begin(), all.end(), 0);
  fit_jets(surface, all, options, progress, result);
  return result;
}

}  // namespace illustrate
