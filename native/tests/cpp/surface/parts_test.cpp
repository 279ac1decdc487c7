// The connected parts of a surface.
#include <gtest/gtest.h>

#include "surface/parts.h"
#include "tests/cpp/shapes.h"

namespace illustrate {
namespace {

TEST(Parts, AreWhatEdgesConnect) {
  const PolygonMesh two = shapes::joined(shapes::cube(), shapes::moved(shapes::cube(), {9, 0, 0}));
  PolygonMesh sharp = two;
  sharp.crease_angle_deg = 30;  // creases connect too
  for (const PolygonMesh& mesh : {two, sharp}) {
    const Surface surface = shapes::plain_surface(mesh);
    const SurfaceParts parts = surface_parts(surface);
    ASSERT_EQ(parts.diagonals.size(), 2u);
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
      const bool is_far = surface.positions[idx(surface.triangles[t][0])].x() > 4;
      EXPECT_EQ(parts.of_triangle[t], is_far ? 1 : 0);
    }
    EXPECT_NEAR(parts.diagonals[0], parts.diagonals[1], 1e-12);
    EXPECT_NEAR(parts.diagonals[0], std::sqrt(20.0), 1e-12);
    EXPECT_NEAR(parts.areas[0], 24, 1e-12);
    EXPECT_LT((parts.middles[1] - parts.middles[0] - Vec3(9, 0, 0)).norm(), 1e-12);
  }
}

TEST(Parts, OfNothingAreNone) { EXPECT_TRUE(surface_parts({}).diagonals.empty()); }

}  // namespace
}  // namespace illustrate
