// Creases that bound a fold: what is hidden along them.
#include <gtest/gtest.h>

#include "tests/cpp/blocks.h"
#include "tests/cpp/cameras.h"
#include "tests/cpp/shapes.h"
#include "tests/cpp/stroke_distance.h"

namespace illustrate {
namespace {

// A sheet over a square, of which a strip that narrows to a point at the origin is folded under:
// from above its two creases run from there to (1, .3) and, beneath the sheet, to (1, -.3).
PolygonMesh dart() {
  PolygonMesh mesh = shapes::polygon_mesh(
      {{0, 0, 0},
       {1, 0.3, 0.2},
       {1, -1, 0},
       {-1, -1, 0},
       {-1, 0, 0},
       {-1, 1, 0},
       {1, 1, 0},
       {1, -0.3, -0.2}},
      {{0, 2, 1}, {0, 3, 2}, {0, 4, 3}, {0, 5, 4}, {0, 6, 5}, {0, 7, 6}, {0, 1, 7}});
  mesh.edge_vertices = {{0, 1}, {0, 7}};
  mesh.edge_sharpness = {infinitely_sharp, infinitely_sharp};
  mesh.vertex_sharpness = {infinitely_sharp, 0, 0, 0, 0, 0, 0, 0};
  return mesh;
}

TEST(FoldedCreases, TheSecondOneOfADartIsHidden) {
  for (const bool cage : {true, false}) {
    for (const Vec3& from : {Vec3(0, 0, 1), Vec3(0.1, 0.2, 1), Vec3(-0.3, 0.1, 1)}) {
      PolygonMesh mesh = dart();
      mesh.cage = cage;
      const Camera camera = cameras::orthographic(from, 1.2);
      const Drawing drawing = blocks::drawn({mesh}, camera);
      EXPECT_LT(distance_px(drawing, camera.project(Vec3(0.5, 0.15, 0.1)).xy), 2);
      EXPECT_GT(distance_px(drawing, camera.project(Vec3(0.5, -0.15, -0.1)).xy), 20);
    }
  }
}

// A leaf with three tips, of two sheets: its outline is one line all the same.
TEST(FoldedCreases, TheOutlineOfALeafIsOneLine) {
  PolygonMesh mesh =
      shapes::polygon_mesh({{0, 0, 0}, {1, 0.36, 0}, {1, -0.36, 0}, {0.6, 0, 0.2}, {0.6, 0, -0.2}},
                           {{0, 2, 3}, {2, 1, 3}, {1, 0, 3}, {2, 0, 4}, {1, 2, 4}, {0, 1, 4}});
  mesh.edge_vertices = {{0, 1}, {1, 2}, {2, 0}};
  mesh.edge_sharpness = {infinitely_sharp, infinitely_sharp, infinitely_sharp};
  mesh.vertex_sharpness = {infinitely_sharp, infinitely_sharp, infinitely_sharp, 0, 0};
  const Drawing drawing = blocks::drawn({mesh}, cameras::orthographic(Vec3(0.3, 0.5, 1), 2));
  ASSERT_EQ(drawing.kinds.size(), 1U);
  EXPECT_EQ(drawing.kinds[0], Kind::crease);
  EXPECT_TRUE(drawing.closed[0]);
}

}  // namespace
}  // namespace illustrate
