#include <gtest/gtest.h>

#include "tests/cpp/surface_checks.h"

namespace illustrate {
namespace {

using namespace surface_checks;

TEST(Topology, HoleShapesTheLimitAndIsNotThere) {
  PolygonMesh cube = shapes::cube();
  const Surface whole = refined(cube, at_level(3));
  cube.hole_faces = {1};
  const Surface open = refined(cube, at_level(3));
  EXPECT_EQ(open.triangles.size(), whole.triangles.size() / 6 * 5);
  EXPECT_EQ(count_kind(open, EdgeKind::boundary), 4 * 8);
  EXPECT_EQ(open.positions.size(), whole.positions.size() - 49U);
  double worst = 0;
  for (const Vec3& p : open.positions) {
    double nearest = 1;
    for (const Vec3& q : whole.positions) nearest = std::min(nearest, (p - q).norm());
    worst = std::max(worst, nearest);
  }
  EXPECT_LT(worst, 1e-12);
}

TEST(Topology, SheetsOfADoubleCoverShareTheirVertices) {
  for (const auto& mesh : {shapes::klein_mesh(24, 12), shapes::moebius_mesh(20, 4)}) {
    for (const Scheme scheme : {Scheme::catmull_clark, Scheme::loop, Scheme::polygons}) {
      const Surface coarse = refined(mesh, at_level(0, scheme));
      EXPECT_EQ(coarse.positions.size(), mesh.positions.size());
      EXPECT_EQ(coarse.triangles.size(), 2 * mesh.face_sizes.size());
      const Surface fine = refined(mesh, at_level(2, scheme));
      EXPECT_EQ(count_backward(fine), 0);
      EXPECT_GT(std::count_if(fine.flips.begin(), fine.flips.end(), [](int f) { return f != 0; }),
                0);
      EXPECT_EQ(count_kind(fine, EdgeKind::crease), 0);
      EXPECT_EQ(count_kind(fine, EdgeKind::flat_outline), 0);
    }
  }
  EXPECT_EQ(count_kind(refined(shapes::klein_mesh(24, 12), at_level(2)), EdgeKind::boundary), 0);
  EXPECT_EQ(count_kind(refined(shapes::moebius_mesh(20, 4), at_level(2)), EdgeKind::boundary), 160);
}

TEST(Topology, CreaseOnADoubleCover) {
  PolygonMesh klein = shapes::klein_mesh(24, 12);
  for (int i = 0; i < 24; ++i) {  // along v = 0, which comes back to itself
    klein.edge_vertices.push_back({12 * i, i == 23 ? 0 : 12 * (i + 1)});
    klein.edge_sharpness.push_back(10);
  }
  const Surface surface = refined(klein, at_level(1));
  EXPECT_EQ(count_kind(surface, EdgeKind::crease), 2 * 48);
  EXPECT_EQ(surface.positions.size(), 48U * 24U + 48U);
  EXPECT_EQ(count_backward(surface), 0);
}

// Three rectangles that share the edge x = z = 0: a floor of two and a wall.
PolygonMesh floor_and_wall() {
  return shapes::polygon_mesh(
      {{0, -1, 0},
       {0, 0, 0.2},
       {0, 1, 0},
       {-1, -1, 0},
       {-1, 0, .2},
       {-1, 1, 0},
       {1, -1, 0},
       {1, 0, .2},
       {1, 1, 0},
       {0, -1, 1},
       {0, 0, 1},
       {0, 1, 1}},
      {{3, 0, 1, 4}, {4, 1, 2, 5}, {0, 6, 7, 1}, {1, 7, 8, 2}, {0, 1, 10, 9}, {1, 2, 11, 10}});
}

TEST(Topology, FinStaysOnItsSheet) {
  for (const Scheme scheme : {Scheme::catmull_clark, Scheme::loop, Scheme::polygons}) {
    for (const int level : {0, 2}) {
      const Surface surface = refined(floor_and_wall(), at_level(level, scheme));
      const int edges = scheme == Scheme::polygons ? 2 : 2 << level;
      EXPECT_EQ(count_kind(surface, EdgeKind::seam), edges);
      EXPECT_EQ(count_kind(surface, EdgeKind::crease), 2 * edges) << "held (mesh/held_places.h)";
      std::vector<int> copies(surface.positions.size(), 0), walls = copies;
      for (std::size_t v = 0; v < surface.positions.size(); ++v) {
        const std::size_t place = index(surface.places[v]);
        ++copies[place];
        walls[place] += std::abs(surface.normals[v].x()) > .9;
      }
      // Two sides of the floor and the wall; check_surface has seen that they lie on each other.
      EXPECT_EQ(std::count(copies.begin(), copies.end(), 3), edges + 1);
      for (std::size_t v = 0; v < copies.size(); ++v) {
        if (copies[v] != 3) continue;
        EXPECT_EQ(walls[v], 1);
      }
    }
  }
}

TEST(Topology, SidesOfASeamAreSmoothAcross) {
  // A bumpy plane cut in two along x = 0 by hand.
  const int n = 4;
  SoundMesh mesh = sound(bumpy_plane(n));
  for (int j = 0; j <= n; ++j) {
    mesh.positions.push_back(mesh.positions[index(2 * (n + 1) + j)]);
    mesh.source_vertices.push_back(2 * (n + 1) + j);
    mesh.vertex_sharpness.push_back(0);
    mesh.twin_vertices.push_back(none);
  }
  for (std::size_t c = 32; c < mesh.corner_vertices.size(); ++c) {
    int& v = mesh.corner_vertices[c];
    if (v / (n + 1) == 2) v = 25 + v % (n + 1);
  }
  for (int j = 0; j < n; ++j) {
    mesh.seams.push_back({10 + j, 11 + j});
    mesh.seams.push_back({26 + j, 25 + j});
  }
  for (const int level : {0, 2}) {
    for (const Scheme scheme : {Scheme::catmull_clark, Scheme::loop}) {
      Counts report;
      const Surface surface = refine({mesh}, at_level(level, scheme), report);
      check_surface(surface);
      EXPECT_EQ(count_kind(surface, EdgeKind::seam), 2 * (n << level));
      EXPECT_EQ(count_kind(surface, EdgeKind::boundary), 4 * (n << level));
      int on_seam = 0;
      for (std::size_t v = 0; v < surface.positions.size(); ++v) {
        const std::size_t first = index(surface.places[v]);
        if (first == v) continue;
        ++on_seam;
        EXPECT_LT((surface.normals[v] - surface.normals[first]).norm(), 1e-12);
      }
      EXPECT_EQ(on_seam, (n << level) + 1);
    }
  }
}

TEST(Topology, MarksAndMaterials) {
  PolygonMesh plane =
      shapes::height_field(4, 4, [](double x, double y) { return x * x + y * y * .5; });
  plane.marked_edges = {{6, 7}};
  plane.face_materials.assign(16, 0);
  for (std::size_t f = 8; f < 16; ++f) plane.face_materials[f] = 3;
  const Surface surface = refined(plane, at_level(2));
  EXPECT_EQ(count_kind(surface, EdgeKind::mark), 4);
  EXPECT_EQ(count_kind(surface, EdgeKind::material), 16);
  EXPECT_EQ(count_kind(surface, EdgeKind::boundary), 64);
}

TEST(Topology, FlatAreaIsOutlined) {
  PolygonMesh mesh =
      shapes::height_field(8, 8, [](double x, double) { return x > .01 ? x * x : 0; });
  const Surface surface = refined(mesh, at_level(1, Scheme::catmull_clark));
  EXPECT_EQ(count_kind(surface, EdgeKind::flat_outline), 16);
  for (std::size_t i = 0; i < surface.feature_edges.size(); ++i) {
    if (surface.feature_kinds[i] != EdgeKind::flat_outline) continue;
    EXPECT_NEAR(surface.positions[index(surface.feature_edges[i][0])].z(), 0, 1e-12);
  }
  const Surface cylinder =
      refined(shapes::height_field(8, 8, [](double x, double) { return std::sqrt(4 - x * x); }),
              at_level(2));
  EXPECT_EQ(count_kind(cylinder, EdgeKind::flat_outline), 0);
}

TEST(Polygons, ConcavePolygonKeepsItsArea) {
  // An L, a comb, and a dart whose shorter diagonal lies outside.
  const PolygonMesh l = shapes::polygon_mesh(
      {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}}, {{0, 1, 2, 3, 4, 5}});
  EXPECT_NEAR(area(refined(l, at_level(0, Scheme::polygons))), 3, 1e-12);
  EXPECT_NEAR(area(refined(creased(l, 10), at_level(0, Scheme::polygons))), 3, 1e-12);
  const PolygonMesh dart =
      shapes::polygon_mesh({{0, 0, 0}, {2, 1, 0}, {0, 2, 0}, {1.8, 1, 0}}, {{0, 1, 2, 3}});
  EXPECT_NEAR(area(refined(dart, at_level(0, Scheme::polygons))), .2, 1e-12);
  PolygonMesh comb;
  std::vector<int> face;
  for (int i = 0; i < 20; ++i) {
    comb.positions.emplace_back(i, i % 2 ? 1 : 5, 0);
    face.push_back(19 - i);
  }
  comb.positions.emplace_back(0, 0, 0);
  comb.positions.emplace_back(19, 0, 0);
  face.push_back(20);
  face.push_back(21);
  shapes::add_face(comb, face);
  double exact = 0;
  for (int i = 0; i < 19; ++i) exact += 3;
  EXPECT_NEAR(area(refined(comb, at_level(0, Scheme::polygons))), exact, 1e-12);
  EXPECT_EQ(count_backward(refined(comb, at_level(0, Scheme::polygons))), 0);
}

TEST(Polygons, DiagonalThatExistsAlreadyIsAvoided) {
  // A quad and the two triangles of its back: one diagonal of the quad is an edge of theirs.
  const PolygonMesh mesh = shapes::polygon_mesh({{0, 0, 0}, {1, 0, .5}, {1, 1, 0}, {0, 1, 0}},
                                                {{0, 1, 2, 3}, {2, 1, 0}, {3, 2, 0}});
  for (const int level : {0, 2}) {
    const Surface surface = refined(mesh, at_level(level, Scheme::loop));
    EXPECT_EQ(surface.triangles.size(), 6U << 2 * level);
    EXPECT_EQ(count_kind(surface, EdgeKind::boundary), 0);
  }
}

TEST(Polygons, AreDrawnAsTheyAre) {
  const PolygonMesh sphere = shapes::icosphere_mesh(1, 3);
  const Surface surface = refined(sphere, at_level(4, Scheme::polygons));
  ASSERT_EQ(surface.positions.size(), sphere.positions.size());
  EXPECT_FALSE(surface.object_is_smooth[0]);
  for (std::size_t v = 0; v < surface.positions.size(); ++v) {
    EXPECT_GT(surface.normals[v].dot(surface.positions[v]), 1 - 1e-3);
    EXPECT_NEAR(surface.curvature[v].k1, -1, .01);
  }
}

}  // namespace
}  // namespace illustrate
