// Surfaces that leave the limit for arcs.
#include "surface/limit/lay_on_arcs.h"

#include "surface/limit/limit_surface.h"
#include "tests/cpp/rounded_box.h"
#include "tests/cpp/surface_checks.h"

namespace illustrate {
namespace {

using namespace surface_checks;
using shapes::mesh_of;
using shapes::RoundedBox;

struct Farthest {
  double anywhere = 0, on_edges = 0;
};

// The farthest that the surface is off the box, and that it is along its edges.
Farthest farthest(const Surface& surface, const RoundedBox& box) {
  Farthest result;
  for (const Vec3& p : surface.positions) {
    const double off = std::abs(box.distance(p)) / box.radius;
    result.anywhere = std::max(result.anywhere, off);
    const Vec3 beyond = (p.cwiseAbs() - box.half).array() + box.radius;
    if (beyond.minCoeff() < 0) result.on_edges = std::max(result.on_edges, off);
  }
  return result;
}

TEST(LayOnArcs, RoundedBoxesKeepTheirShapeHoweverNarrowTheRounding) {
  for (const double radius : {.1, .01, .001}) {
    for (const int strips : {2, 4, 8}) {
      const RoundedBox box{{2, 1, .5}, radius, strips};
      const Surface surface = refined(mesh_of(box), at_level(4));
      EXPECT_EQ(count_backward(surface), 0) << radius << " " << strips;
      const Farthest off = farthest(surface, box);
      EXPECT_LT(off.anywhere, strips == 2 ? .06 : .02) << radius << " " << strips;
      EXPECT_LT(off.on_edges, strips == 2 ? .02 : .004) << radius << " " << strips;
    }
  }
}

TEST(LayOnArcs, EdgesBendAsTheirRadiusSays) {
  for (const double radius : {.1, .002}) {
    const RoundedBox box{{2, 1, .5}, radius, 4};
    const Surface surface = refined(mesh_of(box), at_level(4));
    int count = 0;
    for (std::size_t v = 0; v < surface.positions.size(); ++v) {
      const Vec3 at = surface.positions[v];
      const Vec3 beyond = (at.cwiseAbs() - box.half).array() + radius;
      const bool is_on_long_edge = std::abs(at.x()) < 1 && beyond.tail<2>().minCoeff() > 0;
      if (!is_on_long_edge || beyond.tail<2>().minCoeff() < .05 * radius) continue;
      EXPECT_NEAR(surface.curvature[v].k1 * radius, -1, .05);
      EXPECT_NEAR(surface.curvature[v].k2 * radius, 0, .01);
      EXPECT_GT(std::abs(surface.curvature[v].w2.x()), .999);
      ++count;
    }
    EXPECT_GT(count, 100);
  }
}

TEST(LayOnArcs, WallsStayLevel) {
  const RoundedBox box{{2, 1, .5}, .02, 3};
  const Surface surface = refined(mesh_of(box), at_level(3));
  ASSERT_EQ(surface.planes.size(), 6U);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    if (surface.triangle_planes[t] == none) continue;
    const Vec3& normal = surface.planes[idx(surface.triangle_planes[t])].normal;
    const double height = box.half.dot(normal.cwiseAbs());
    for (const int v : surface.triangles[t])
      EXPECT_NEAR(surface.positions[idx(v)].dot(normal), height, 1e-14);
  }
}

// The corner of a wall of seven vertices, and two narrow strips round it: the limit slides so far
// that hundreds of its triangles turned round.
TEST(LayOnArcs, AWallDoesNotFold) {
  const double b = .008;
  PolygonMesh mesh = shapes::polygon_mesh({{-3.5, 0, 0},
                                           {0, 0, 0},
                                           {.3, -1, 0},
                                           {-1, -.15, 0},
                                           {-.35, -.13, 0},
                                           {0, -.18, 0},
                                           {-3.5, -1, 0},
                                           {-3.5, .02, -b},
                                           {.01, .02, -b},
                                           {.33, -1, -b},
                                           {-3.5, .035, -3 * b},
                                           {.02, .035, -3 * b},
                                           {.345, -1, -3 * b}},
                                          {{0, 3, 1},
                                           {3, 4, 1},
                                           {4, 5, 1},
                                           {5, 2, 1},
                                           {6, 3, 0},
                                           {6, 4, 3},
                                           {6, 5, 4},
                                           {6, 2, 5},
                                           {0, 1, 8},
                                           {0, 8, 7},
                                           {1, 2, 9},
                                           {1, 9, 8},
                                           {7, 8, 11},
                                           {7, 11, 10},
                                           {8, 9, 12},
                                           {8, 12, 11}});
  mesh.cage = false;
  const Surface surface = refined(mesh, at_level(5));
  for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t) {
    const bool is_wall = surface.triangle_planes[idx(t)] != none;
    EXPECT_TRUE(!is_wall || area_vector(surface, t).z() > 0) << t;
  }
  EXPECT_LE(count_backward(surface), 1) << "at the open end of the strips";
}

// Rounding tilts slivers, however level the face is that they are part of.
TEST(LayOnArcs, SliversDoNotTurnNormals) {
  for (const double tilt : {-3., 0., 3.}) {
    const double height = 1e-5;
    PolygonMesh mesh = shapes::polygon_mesh({{-4, 0, 0},
                                             {0, 0, 0},
                                             {0, -1, 0},
                                             {-4, -1, 0},
                                             {-.6, -.1, 0},
                                             {-.2, -.09, 0},
                                             {-.05, -.12, 0},
                                             {-.4, -.095 - height, tilt * height}},
                                            {{0, 4, 1},
                                             {4, 5, 1},
                                             {4, 7, 5},
                                             {5, 6, 1},
                                             {6, 2, 1},
                                             {3, 4, 0},
                                             {3, 7, 4},
                                             {3, 5, 7},
                                             {3, 6, 5},
                                             {3, 2, 6}});
    mesh.cage = false;
    mesh.boundary = BoundaryRule::edges;
    const Surface surface = refined(mesh, at_level(1));
    for (const Vec3& normal : surface.normals) EXPECT_GT(normal.z(), .95) << tilt;
  }
}

TEST(LayOnArcs, TheLimitSaysNothingThere) {
  const Surface surface = refined(mesh_of({{2, 1, .5}, .02, 3}), at_level(2));
  const LimitSurface limit(surface);
  EXPECT_FALSE(limit.evaluate({0, {.5, .5}}));
}

}  // namespace
}  // namespace illustrate
