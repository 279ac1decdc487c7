// Points of a mesh split once, on curves through its vertices.
#include "control/bent_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mesh/sanitize.h"
#include "tests/cpp/shapes.h"

namespace illustrate {
namespace {

constexpr double radius = 4;

// Over -1 <= x <= 1: level up to `joint`, from there the arc of a circle, tangent to the level
// part.
PolygonMesh level_and_arc(int columns, double joint) {
  PolygonMesh mesh = shapes::height_field(columns, 2, [joint](double x, double) {
    const double along = std::max(0., x - joint);
    return std::sqrt(radius * radius - along * along) - radius;
  });
  mesh.boundary = BoundaryRule::edges;
  return mesh;
}

// An edge along x in the middle row.
struct Bent {
  Vec3 from, to, middle;
};

// In the order of x.
std::vector<Bent> bent_edges(const PolygonMesh& source) {
  Counts report;
  const SoundMesh mesh = sanitize(source, report);
  const HalfEdges edges(mesh);
  const VertexSectors sectors = find_sectors(edges, mesh.positions.size());
  const Points points = bent_points(mesh, edges, sectors, Scheme::catmull_clark);
  std::vector<Bent> result;
  for (std::size_t e = 0; e < edges.first.size(); ++e) {
    const Vec3& from = mesh.positions[idx(edges.faces.corners[idx(edges.first[e])])];
    const Vec3& to = mesh.positions[idx(edges.faces.head(edges.first[e]))];
    if (from.y() == 0 && to.y() == 0)
      result.push_back({from, to, points[mesh.positions.size() + e]});
  }
  std::sort(result.begin(), result.end(),
            [](const Bent& a, const Bent& b) { return a.middle.x() < b.middle.x(); });
  return result;
}

TEST(BentPoints, WhatIsLevelStaysLevelUpToWhereItBends) {
  for (const Bent& edge : bent_edges(level_and_arc(8, 0))) {
    const bool is_level = edge.middle.x() < 0;
    const double up = edge.middle.z() - (edge.from.z() + edge.to.z()) / 2;
    EXPECT_EQ(is_level, up == 0) << edge.middle.x();
    EXPECT_GE(up, 0);
  }
}

// Of unevenly long edges, but for those that end at the border.
TEST(BentPoints, ArcsConverge) {
  const Vec3 centre(-2, 0, -radius);
  double last = 1;
  for (const int columns : {8, 16, 32}) {
    const std::vector<Bent> edges = bent_edges(level_and_arc(columns, centre.x()));
    double off = 0;
    for (std::size_t i = 1; i + 1 < edges.size(); ++i) {
      const double sag = radius - ((edges[i].from + edges[i].to) / 2 - centre).norm();
      off = std::max(off, std::abs((edges[i].middle - centre).norm() - radius) / sag);
    }
    EXPECT_LT(off, last / 1.8) << columns;
    last = off;
  }
  EXPECT_LT(last, 0.05);
}

}  // namespace
}  // namespace illustrate
