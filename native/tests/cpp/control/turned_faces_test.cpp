// Faces that their limit turns over.
#include "control/turned_faces.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "control/bent_points.h"
#include "control/split_once.h"
#include "tests/cpp/shapes.h"

namespace illustrate {
namespace {

// A sheet of length `length` and width 1 that bends a little. Three vertices lie in a row at one
// corner, so far below the upper edge; needles go from them to the corners far away.
PolygonMesh sheet_of_needles(double length, double below, double bend) {
  const double l = length, d = below;
  PolygonMesh mesh = shapes::polygon_mesh(
      {{-l, 0, 0},
       {0, 0, 0},
       {0, -1, 0},
       {-l, -1, 0},
       {-6 * d, -d, 0},
       {-2 * d, -.9 * d, 0},
       {-.5 * d, -1.2 * d, 0}},
      {{0, 4, 1}, {4, 5, 1}, {5, 6, 1}, {6, 2, 1}, {3, 4, 0}, {3, 5, 4}, {3, 6, 5}, {3, 2, 6}});
  for (Vec3& p : mesh.positions) p.z() = -bend * p.x() * p.x();
  mesh.boundary = BoundaryRule::edges;
  return mesh;
}

struct Kept {
  explicit Kept(const PolygonMesh& source, Scheme scheme = Scheme::loop)
      : mesh(sound(source)), edges(mesh) {
    const SoundMesh child = split_once(mesh, edges, scheme);
    const HalfEdges child_edges(child);
    const Points points =
        bent_points(mesh, edges, find_sectors(edges, mesh.positions.size()), scheme);
    limits = limit_places(child, child_edges, find_sectors(child_edges, child.positions.size()),
                          points, scheme);
  }

  static SoundMesh sound(const PolygonMesh& source) {
    Counts report;
    return sanitize(source, report);
  }

  std::vector<double> weights(double known = 0) const {
    return weights_of_turned_faces(mesh, edges, limits,
                                   std::vector<double>(mesh.positions.size(), known));
  }

  SoundMesh mesh;
  HalfEdges edges;
  LimitPlaces limits;
};

double most(const std::vector<double>& values) {
  return *std::max_element(values.begin(), values.end());
}

TEST(TurnedFaces, AreNoneWhereEdgesAreAlike) {
  const PolygonMesh saddle =
      shapes::height_field(8, 3, [](double x, double y) { return .1 * (x * x - y * y); });
  EXPECT_EQ(most(Kept(saddle, Scheme::catmull_clark).weights()), 0);
  EXPECT_EQ(most(Kept(sheet_of_needles(1, .3, .05)).weights()), 0);
}

TEST(TurnedFaces, AreNeedlesBesideLargeTriangles) {
  for (const double bend : {0., .002, .01})
    EXPECT_EQ(most(Kept(sheet_of_needles(4, .1, bend)).weights()), 1) << bend;
}

TEST(TurnedFaces, LeaveWhatIsBeyondACreaseAlone) {
  PolygonMesh mesh = sheet_of_needles(4, .1, 0);
  mesh.positions.insert(mesh.positions.end(), {{-4, 0, -1}, {-4, -1, -1}});
  shapes::add_face(mesh, {3, 0, 7});
  shapes::add_face(mesh, {3, 7, 8});
  mesh.edge_vertices = {{0, 3}};
  mesh.edge_sharpness = {infinitely_sharp};
  const std::vector<double> weights = Kept(mesh).weights();
  EXPECT_EQ(weights[3], 1);
  EXPECT_EQ(weights[7], 0);
  EXPECT_EQ(weights[8], 0);
}

TEST(TurnedFaces, KeepTheWeightsThatAreKnown) {
  for (const double weight : Kept(sheet_of_needles(1, .3, .05)).weights(.25))
    EXPECT_EQ(weight, .25);
}

TEST(TurnedFaces, ComeWithoutAJump) {
  double last = 0;
  for (double below = .5; below > .05; below -= .0002) {
    const double here = most(Kept(sheet_of_needles(4, below, .01)).weights());
    EXPECT_NEAR(here, last, .1) << below;
    last = here;
  }
  EXPECT_EQ(last, 1);
}

}  // namespace
}  // namespace illustrate
