// How large things are, whatever the axes.
#include "core/spread.h"

#include <gtest/gtest.h>

#include "tests/cpp/shapes.h"

namespace illustrate {
namespace {

double diagonal_of(const Surface& surface, const Eigen::Affine3d& placement) {
  Spread spread;
  for (const Triangle& t : surface.triangles)
    spread.add(placement * surface.positions[idx(t[0])], placement * surface.positions[idx(t[1])],
               placement * surface.positions[idx(t[2])]);
  return spread.diagonal();
}

double diagonal_of(const Surface& surface) {
  return diagonal_of(surface, Eigen::Affine3d::Identity());
}

Eigen::Affine3d motion() {
  return Eigen::Translation3d(50, -30, 20) * Eigen::Quaterniond(.3, -.7, .5, .1).normalized();
}

// A plate's own diagonal; of a cube a quarter more, of a ball that of the box round it.
TEST(Spread, IsNearTheDiagonalOfABox) {
  const PolygonMesh plate = shapes::plane(3, 5);
  Eigen::AlignedBox3d box;
  for (const Vec3& p : plate.positions) box.extend(p);
  EXPECT_NEAR(diagonal_of(shapes::plain_surface(plate)), box.diagonal().norm(), 1e-12);
  EXPECT_NEAR(diagonal_of(shapes::plain_surface(shapes::cube())), std::sqrt(20.), 1e-12);
  EXPECT_NEAR(diagonal_of(shapes::sphere_surface(2, 5)), 4 * std::sqrt(3.), .01);
}

TEST(Spread, HasItsMiddleWhereTheAreaHas) {
  const PolygonMesh plate = shapes::moved(shapes::plane(3, 5), {7, -2, 30});
  const Surface surface = shapes::plain_surface(plate);
  for (const double scale : {1e-90, 1., 1e90}) {
    Spread scaled;
    for (const Triangle& t : surface.triangles)
      scaled.add(scale * surface.positions[idx(t[0])], scale * surface.positions[idx(t[1])],
                 scale * surface.positions[idx(t[2])]);
    EXPECT_LT((scaled.middle() / scale - Vec3(7, -2, 30)).norm(), 1e-12);
  }
}

TEST(Spread, IsTheSameWhereverAndHoweverTurned) {
  for (const PolygonMesh& mesh : {shapes::cube(), shapes::plane(3, 5), shapes::icosahedron()}) {
    const Surface surface = shapes::plain_surface(mesh);
    EXPECT_NEAR(diagonal_of(surface, motion()), diagonal_of(surface), 1e-12);
  }
}

TEST(Spread, OfAnySize) {
  const Surface cube = shapes::plain_surface(shapes::cube());
  for (const double scale : {1e-150, 1e-90, 1e90, 1e150}) {
    const Eigen::Affine3d by(Eigen::Scaling(scale));
    EXPECT_NEAR(diagonal_of(cube, by) / scale, std::sqrt(20.), 1e-12) << scale;
  }
}

TEST(Spread, RoundingGrowsWithTheDistanceFarOffAlone) {
  for (const double size : {3e-7, 1., 1.9, 5e8}) {
    for (const double sizes : {0., 1., 20., 120.})
      EXPECT_EQ(rounding_size(size, sizes * size), size) << sizes;
    double last = size;
    for (double sizes = 200; sizes < 1e9; sizes *= 2) {
      const double found = rounding_size(size, sizes * size);
      EXPECT_EQ(found, 2 * last) << sizes;
      EXPECT_EQ(rounding_size(size, 1.2 * sizes * size), found) << sizes;
      last = found;
    }
  }
}

TEST(Spread, OfNothingIsNone) {
  EXPECT_EQ(Spread().diagonal(), 0);
  Spread needle;
  needle.add(Vec3::Zero(), Vec3::UnitX(), 2 * Vec3::UnitX());
  EXPECT_EQ(needle.diagonal(), 0);
}

}  // namespace
}  // namespace illustrate
