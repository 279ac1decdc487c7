#include "surface/jets/curvature_derivative.h"

#include <gtest/gtest.h>

#include "tests/cpp/shapes.h"

namespace illustrate {
namespace {

constexpr double torus_core = 1, torus_tube = 0.4;

// On a torus only C(tube, around, around) is not 0: R sin v / (r (R + r cos v)^2).
double worst_cubic(int n) {
  const Surface torus = shapes::torus_surface(torus_core, torus_tube, 2 * n, n);
  const CurvatureDerivative found = curvature_derivative(torus, torus.curvature, 1);
  double worst = 0;
  for (std::size_t i = 0; i < torus.positions.size(); ++i) {
    const double v = 2 * pi * static_cast<double>(i % idx(n)) / n;
    const double rho = torus_core + torus_tube * std::cos(v);
    const double exact = torus_core * std::sin(v) / (torus_tube * rho * rho);
    const Vec3& p = torus.positions[i];
    const Vec3 around = Vec3(-p.y(), p.x(), 0).normalized();
    const Vec3 up = torus.normals[i].cross(around);
    const Vec3 &w1 = found.curvature[i].w1, &w2 = found.curvature[i].w2;
    for (const double angle : {0.0, 0.7, 1.5, 2.6}) {
      const Vec3 t = std::cos(angle) * up + std::sin(angle) * around;
      const double expected = 3 * std::cos(angle) * std::sin(angle) * std::sin(angle) * exact;
      const double value = along(found.cubics[i], t.dot(w1), t.dot(w2));
      worst = std::max(worst, std::abs(value - expected));
    }
  }
  return worst;
}

TEST(CurvatureDerivative, OfATorusIsThatOfTheFormula) {
  const double largest = torus_core / (torus_tube * 0.36);  // a bound of the exact values
  EXPECT_LT(worst_cubic(96), 0.02 * largest);
  EXPECT_LT(worst_cubic(96), worst_cubic(24) / 2);
}

TEST(CurvatureDerivative, IsTheSameWithAnyNumberOfThreads) {
  const Surface torus = shapes::torus_surface(torus_core, torus_tube, 96, 48);
  const CurvatureDerivative one = curvature_derivative(torus, torus.curvature, 1);
  const CurvatureDerivative four = curvature_derivative(torus, torus.curvature, 4);
  EXPECT_EQ(one.cubics, four.cubics);
  EXPECT_EQ(one.second, four.second);
  EXPECT_TRUE(one.curvature == four.curvature);
}

TEST(CurvatureDerivative, NoSurfaceHasNone) {
  EXPECT_TRUE(curvature_derivative(Surface(), Curvature(), 1).cubics.empty());
}

}  // namespace
}  // namespace illustrate
