#include "core/predicates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace illustrate {
namespace {

using Tetrahedron = std::array<Vec3, 4>;

int orient(const Tetrahedron& p) { return orient3d(p[0], p[1], p[2], p[3]); }

// Exact for integer coordinates below 2^40.
int integer_orient(const Tetrahedron& p) {
  std::array<std::array<__int128, 3>, 3> m;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) m[i][k] = static_cast<std::int64_t>(p[i][k] - p[3][k]);
  const __int128 det = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                       m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                       m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  return (det > 0) - (det < 0);
}

TEST(Predicates, OrientationIsPositiveBehindACounterClockwiseTriangle) {
  const Vec3 a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0};
  EXPECT_EQ(orient3d(a, b, c, {0.2, 0.2, -1}), 1);
  EXPECT_EQ(orient3d(a, b, c, {0.2, 0.2, 1}), -1);
  EXPECT_EQ(orient3d(a, b, c, {5, 7, 0}), 0);
}

TEST(Predicates, AgreesWithIntegersOnNearlyCoplanarPoints) {
  std::mt19937 random(1);
  std::uniform_int_distribution<std::int64_t> coordinate(-(1LL << 38), 1LL << 38);
  std::uniform_int_distribution<int> weight(-3, 3), nudge(-1, 1);
  int zeros = 0;
  for (int i = 0; i < 3000; ++i) {
    Tetrahedron p;
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k) p[j][k] = static_cast<double>(coordinate(random));
    p[3] = p[0] + weight(random) * (p[1] - p[0]) + weight(random) * (p[2] - p[0]);
    p[3][i % 3] += nudge(random);
    EXPECT_EQ(orient(p), integer_orient(p));
    zeros += orient(p) == 0;
  }
  EXPECT_GT(zeros, 500);
}

TEST(Predicates, SwappingTwoPointsTurnsTheSign) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> coordinate(0, 1);
  for (int i = 0; i < 500; ++i) {
    Tetrahedron p;
    for (int j = 0; j < 3; ++j) p[j] = {coordinate(random), coordinate(random), 0.1};
    p[3] = p[0] * 0.3 + p[1] * 0.3 + p[2] * 0.4;
    const int sign = orient(p);
    for (int j = 0; j < 3; ++j) {
      Tetrahedron q = p;
      std::swap(q[j], q[j + 1]);
      EXPECT_EQ(orient(q), -sign);
    }
  }
}

TEST(Predicates, SmallestDifferencesCount) {
  const double up = std::nextafter(0.5, 1.0);
  EXPECT_EQ(orient3d({0, 0, 0.5}, {1, 0, 0.5}, {0, 1, 0.5}, {0.3, 0.3, up}), -1);
  EXPECT_EQ(orient3d({0, 0, 0.5}, {1, 0, 0.5}, {0, 1, up}, {0.3, 1e-17, 0.5}), 1);
  EXPECT_EQ(sign_of_difference(1 + 0x1p-52, 1 - 0x1p-52, 1, 1), -1);
  EXPECT_EQ(sign_of_difference(0.1, 3, 0.3, 1), 1);  // 0.1 is above, 0.3 below its decimal
  EXPECT_EQ(sign_of_difference(0.5, 0.25, 0.125, 1), 0);
}

}  // namespace
}  // namespace illustrate
