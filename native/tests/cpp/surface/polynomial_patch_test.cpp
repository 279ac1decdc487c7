#include "surface/limit/polynomial_patch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace illustrate {
namespace {

// The control points of Loop's regular triangle in OpenSubdiv's order: steps along u and v from the
// triangle's first corner.
constexpr std::array<std::array<int, 2>, 12> lattice{{{0, -1},
                                                      {1, -1},
                                                      {2, -1},
                                                      {-1, 0},
                                                      {0, 0},
                                                      {1, 0},
                                                      {2, 0},
                                                      {-1, 1},
                                                      {0, 1},
                                                      {1, 1},
                                                      {-1, 2},
                                                      {0, 2}}};

// Twelve points of which no two lie alike.
std::array<Vec3, 12> uneven_controls() {
  std::array<Vec3, 12> controls;
  for (std::size_t i = 0; i < controls.size(); ++i) {
    const double u = lattice[i][0], v = lattice[i][1], k = static_cast<double>(i);
    controls[i] = {u + 0.1 * std::sin(3 * k), v + 0.1 * std::cos(5 * k), std::sin(7 * k)};
  }
  return controls;
}

const Vec3& at(const std::array<Vec3, 12>& controls, int u, int v) {
  const auto found = std::find(lattice.begin(), lattice.end(), std::array<int, 2>{u, v});
  return controls[static_cast<std::size_t>(found - lattice.begin())];
}

TEST(PolynomialPatch, ABoxSplineOfALatticeIsFlatAndEven) {
  std::array<Vec3, 12> controls;
  for (std::size_t i = 0; i < controls.size(); ++i) {
    controls[i] = {double(lattice[i][0]), double(lattice[i][1]), 0};
  }
  const LimitPoint p = PolynomialPatch::box_spline(controls).evaluate({0.3, 0.45});
  EXPECT_LT((p.position - Vec3(0.3, 0.45, 0)).norm(), 1e-14);
  EXPECT_LT((p.du - Vec3::UnitX()).norm(), 1e-14);
  EXPECT_LT((p.dv - Vec3::UnitY()).norm(), 1e-14);
  EXPECT_LT(p.duu.norm() + p.duv.norm() + p.dvv.norm(), 1e-13);
}

// Loop's limit of a regular vertex: half of it and a twelfth of each of the six around.
TEST(PolynomialPatch, CornersOfABoxSplineAreLoopsLimit) {
  const std::array<Vec3, 12> controls = uneven_controls();
  const PolynomialPatch patch = PolynomialPatch::box_spline(controls);
  for (const std::array<int, 2>& c : {std::array<int, 2>{0, 0}, {1, 0}, {0, 1}}) {
    Vec3 limit = at(controls, c[0], c[1]) / 2;
    for (const std::array<int, 2>& step :
         {std::array<int, 2>{1, 0}, {0, 1}, {-1, 1}, {-1, 0}, {0, -1}, {1, -1}}) {
      limit += at(controls, c[0] + step[0], c[1] + step[1]) / 12;
    }
    EXPECT_LT((patch.evaluate({double(c[0]), double(c[1])}).position - limit).norm(), 1e-14);
  }
}

TEST(PolynomialPatch, ABoxSplinesDerivativesAreItsOwn) {
  const PolynomialPatch patch = PolynomialPatch::box_spline(uneven_controls());
  const Vec2 uv(0.2, 0.3);
  const double h = 1e-5;
  const LimitPoint p = patch.evaluate(uv);
  const Vec3 du =
      (patch.evaluate(uv + Vec2(h, 0)).position - patch.evaluate(uv - Vec2(h, 0)).position) /
      (2 * h);
  const Vec3 duv =
      (patch.evaluate(uv + Vec2(0, h)).du - patch.evaluate(uv - Vec2(0, h)).du) / (2 * h);
  EXPECT_LT((p.du - du).norm(), 1e-8);
  EXPECT_LT((p.duv - duv).norm(), 1e-8);
}

// The same quartic as from its values.
TEST(PolynomialPatch, ABoxSplineIsAQuartic) {
  const PolynomialPatch patch = PolynomialPatch::box_spline(uneven_controls());
  const PolynomialPatch fitted =
      PolynomialPatch::quartic([&](const Vec2& uv) { return patch.evaluate(uv).position; });
  for (const Vec2& uv : {Vec2(0.1, 0.1), Vec2(0.7, 0.2), Vec2(0.05, 0.9)}) {
    EXPECT_LT((patch.evaluate(uv).position - fitted.evaluate(uv).position).norm(), 1e-13);
    EXPECT_LT((patch.evaluate(uv).dvv - fitted.evaluate(uv).dvv).norm(), 1e-11);
  }
}

}  // namespace
}  // namespace illustrate
