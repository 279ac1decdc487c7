#include "surface/planes/folded_normals.h"

#include <gtest/gtest.h>

#include "mesh/sanitize.h"
#include "tests/cpp/shapes.h"

namespace illustrate {
namespace {

// Four faces round a vertex, and a needle across one of their edges whose corner rounding has moved
// to the wrong side of it.
RefinedMesh fan_with_needle() {
  const double off = 1e-13;
  Counts counts;
  const PolygonMesh mesh =
      shapes::polygon_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {.5, off, 0}},
                           {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5, 1}, {0, 5, 1}});
  return polygonal_mesh(sanitize(mesh, counts), 1);
}

TEST(FoldedNormals, AreTurnedToTheSideThatAllFacesShow) {
  const RefinedMesh mesh = fan_with_needle();
  ASSERT_EQ(mesh.face_count(), 5u);
  Points normals(mesh.points.size(), Vec3::UnitZ());
  normals[0] = -Vec3::UnitZ();
  normals[2] = Vec3(-.8, 0, .6);
  turn_folded_normals(mesh, mesh, mesh.corner_vertices, normals);
  EXPECT_EQ(normals[0], Vec3::UnitZ()) << "a needle has no say";
  EXPECT_EQ(normals[2], Vec3(-.8, 0, .6)) << "tilted only";
}

}  // namespace
}  // namespace illustrate
