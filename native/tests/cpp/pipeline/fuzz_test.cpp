// What nasty meshes have found, each as small as it could be made, and the first of their seeds.
#include "tests/cpp/check_sound.h"
#include "tests/cpp/surface_checks.h"
#include "tests/fuzz/run_case.h"

namespace illustrate {
namespace {

using namespace surface_checks;

TEST(Fuzz, FirstSeeds) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    fuzz::run_case(seed);
    if (HasFailure()) FAIL() << "illustrate_fuzz --seed " << seed << " --cases 1";
  }
}

// Two of the faces lie on each other at vertex 4; the patches round it have creases and boundaries.
TEST(Fuzz, CreasesWhereFacesOverlap) {
  PolygonMesh mesh = shapes::polygon_mesh(
      {{1, 1, 0}, {3, 3, 0}, {2, 3, 2}, {2, 3, 1}, {2, 2, 1}, {0, 3, 2}, {0, 3, 1}, {0, 0, 1}},
      {{2, 1, 4}, {3, 5, 0, 6, 7}, {6, 1, 7}, {1, 6, 0, 2, 4}});
  mesh.edge_vertices = {{0, 6}, {2, 1}, {4, 2}};
  for (const double sharpness : {0.5, 4.25, 10.0}) {
    mesh.edge_sharpness = {sharpness, sharpness, sharpness};
    for (const BoundaryRule rule : {BoundaryRule::corners, BoundaryRule::edges}) {
      mesh.boundary = rule;
      for (const int level : {0, 1, 2}) refined(mesh, at_level(level, Scheme::catmull_clark));
    }
  }
}

// The normal of a face that folds upon itself is rounding, another on each sheet.
TEST(Fuzz, CreaseAngleIsTheSameOnBothSheets) {
  for (int m = 5; m < 12; ++m)
    for (int n = 4; n < 9; ++n) {
      PolygonMesh klein = shapes::klein_mesh(m, n);
      for (Vec3& p : klein.positions) p = p.array().round();
      klein.crease_angle_deg = 37;
      EXPECT_EQ(mend(klein).report.at("angle_creases") % 2, 0);
    }
}

// Vertices of two faces, with one edge that stays sharp and one that does not.
TEST(Fuzz, DartsOfTwoFaces) {
  PolygonMesh mesh = shapes::polygon_mesh(
      {{-1, -1, -1},
       {1, -1, -1},
       {-1, 1, -1},
       {1, 1, -1},
       {-1, -1, 1},
       {1, -1, 1},
       {-1, 1, 1},
       {1, 1, 1}},
      {{4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2, 3, 1}, {1, 3, 7, 5}});
  mesh.edge_vertices = {{0, 1}, {4, 0}, {3, 1}, {1, 5}, {3, 2}, {2, 6},
                        {7, 3}, {4, 5}, {6, 4}, {5, 7}, {7, 6}};
  mesh.edge_sharpness = {3.6, 10, 7.6, 6.3, 10, 10, 6.3, 10, 10, 10, 10};
  for (const int level : {0, 1, 2}) refined(mesh, at_level(level, Scheme::catmull_clark));
}

// A patch at a corner of very many faces has more points than fit where most are kept.
TEST(Fuzz, PatchesAtALargeOpenFan) {
  PolygonMesh mesh = shapes::cube();
  for (int i = 0; i < 400; ++i)
    mesh.positions.emplace_back(3 + std::cos(0.01 * i), std::sin(0.01 * i), 0.1 * (i % 2));
  for (int i = 0; i + 1 < 400; ++i) shapes::add_face(mesh, {7, 8 + i, 9 + i});
  mesh.face_sizes.erase(mesh.face_sizes.begin() + 1);
  mesh.corner_vertices.erase(mesh.corner_vertices.begin() + 4, mesh.corner_vertices.begin() + 8);
  mesh.edge_vertices = {{7, 8 + 200}, {7, 3}, {0, 1}};
  mesh.edge_sharpness = {2.5, 1.5, 0.5};
  for (const int level : {0, 1}) refined(mesh, at_level(level, Scheme::catmull_clark));
}

// Semi-sharp edges are evaluated on each sheet for itself.
TEST(Fuzz, SemiSharpEdgesOnADoubleCover) {
  PolygonMesh klein = shapes::klein_mesh(9, 7);
  for (std::size_t c = 0; c + 1 < klein.corner_vertices.size(); c += 3) {
    klein.edge_vertices.push_back({klein.corner_vertices[c], klein.corner_vertices[c + 1]});
    klein.edge_sharpness.push_back(c % 2 == 0 ? 1.3 : 10);
  }
  for (const Scheme scheme : {Scheme::catmull_clark, Scheme::loop})
    for (const int level : {0, 1, 2}) refined(klein, at_level(level, scheme));
}

// Where the limit has no plane, the directions of curvature lie in the one that is put there.
TEST(Fuzz, DirectionsWithoutATangentPlane) {
  PolygonMesh triangle =
      shapes::polygon_mesh({{-2.4, -1.2, 0}, {-2.4, 0, 0}, {-2.1, -1, 0.35}}, {{1, 0, 2}});
  triangle.boundary = BoundaryRule::edges;
  for (const double sharpness : {0.3, 2.3, 10.0}) {
    triangle.vertex_sharpness = {0, 0, sharpness};
    for (const Scheme scheme : {Scheme::catmull_clark, Scheme::loop})
      for (const int level : {0, 1, 2}) refined(triangle, at_level(level, scheme));
  }
}

// Directions that run nearly along the normal leave little but rounding in its plane.
TEST(Fuzz, DirectionsOnAVastTriangle) {
  PolygonMesh triangle = shapes::polygon_mesh({{1.0000000139188558, 1.0000000075218813, 1},
                                               {-1e20, -0.99999999416829122, -1.0000000130943019},
                                               {-1, 0.99999998745536889, -0.99999999367842485}},
                                              {{2, 1, 0}});
  triangle.edge_vertices = {{2, 1}};
  triangle.edge_sharpness = {10};
  for (const double length : {1.0, 1e3, 1e8, 1e20}) {
    triangle.positions[1].x() = -length;
    for (const int level : {0, 1, 2}) refined(triangle, at_level(level, Scheme::catmull_clark));
  }
}

}  // namespace
}  // namespace illustrate
