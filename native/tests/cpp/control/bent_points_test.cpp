// Points of a mesh split once, on curves through its vertices.
#include "control/bent_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/pi.h"
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

struct Bent {
  Vec3 from, to, middle;
  bool is_inside;  // not on the border

  double sag() const { return (middle - (from + to) / 2).norm(); }
};

std::vector<Bent> bent_edges(const PolygonMesh& source) {
  Counts report;
  const SoundMesh mesh = sanitize(source, report);
  const HalfEdges edges(mesh);
  const VertexSectors sectors = find_sectors(edges, mesh.positions.size());
  const Points points = bent_points(mesh, edges, sectors, Scheme::catmull_clark);
  std::vector<Bent> result;
  for (std::size_t e = 0; e < edges.first.size(); ++e) {
    const int h = edges.first[e];
    result.push_back({mesh.positions[idx(edges.faces.corners[idx(h)])],
                      mesh.positions[idx(edges.faces.head(h))], points[mesh.positions.size() + e],
                      edges.mates[idx(h)] != none});
  }
  return result;
}

// Those along x in the middle row, in the order of x.
std::vector<Bent> edges_of_row(const PolygonMesh& source) {
  std::vector<Bent> row;
  for (const Bent& edge : bent_edges(source))
    if (edge.from.y() == 0 && edge.to.y() == 0) row.push_back(edge);
  std::sort(row.begin(), row.end(),
            [](const Bent& a, const Bent& b) { return a.middle.x() < b.middle.x(); });
  return row;
}

// A level face whose rounded rim of three strips turns a right corner with a mitre: strips along x
// end where those along y begin. Strips are `width` wide and of length 1.
PolygonMesh mitred_rim(double width) {
  PolygonMesh mesh;
  for (int k = 0; k < 4; ++k) {
    const double out = k * width, down = -0.15 * k * k * width;
    mesh.positions.insert(mesh.positions.end(),
                          {{0, -out, down}, {1 + out, -out, down}, {1 + out, 1, down}});
  }
  mesh.face_sizes = {3};
  mesh.corner_vertices = {0, 1, 2};
  for (int k = 0; k < 9; ++k) {
    if (k % 3 == 2) continue;
    mesh.face_sizes.push_back(4);
    for (const int v : {k + 1, k, k + 3, k + 4}) mesh.corner_vertices.push_back(v);
  }
  mesh.boundary = BoundaryRule::edges;
  return mesh;
}

// The corner turns within the rim's width: the long edges up to it have no part in it.
TEST(BentPoints, LongEdgesUpToAMitreStayStraight) {
  for (const double width : {0.01, 0.001}) {
    for (const Bent& edge : bent_edges(mitred_rim(width))) {
      const bool is_long = edge.is_inside && (edge.from - edge.to).norm() > 0.9;
      EXPECT_TRUE(!is_long || edge.sag() < width / 4) << edge.sag();
    }
  }
}

// A plate whose corners are rounded with a few short edges, as housings have them: a polygon, the
// border of which is a crease.
PolygonMesh rounded_plate(int segments) {
  PolygonMesh plate;
  plate.boundary = BoundaryRule::edges;
  std::vector<int> outline;
  const std::vector<Vec2> centres{{5, 2}, {-5, 2}, {-5, -2}, {5, -2}};
  for (int corner = 0; corner < 4; ++corner) {
    for (int i = 0; i <= segments; ++i) {
      const double angle = pi / 2 * (corner + static_cast<double>(i) / segments);
      const Vec2 p = centres[idx(corner)] + 0.3 * Vec2(std::cos(angle), std::sin(angle));
      outline.push_back(static_cast<int>(plate.positions.size()));
      plate.positions.emplace_back(p.x(), p.y(), 0);
    }
  }
  shapes::add_face(plate, outline);
  return plate;
}

TEST(BentPoints, LongEdgesOfACreaseUpToARoundedCornerStayStraight) {
  for (const int segments : {2, 3, 6}) {
    for (const Bent& edge : bent_edges(rounded_plate(segments))) {
      const bool is_long = (edge.from - edge.to).norm() > 1;
      EXPECT_EQ(is_long, edge.sag() == 0) << segments << ": " << edge.sag();
    }
  }
}

TEST(BentPoints, WhatIsLevelStaysLevelUpToWhereItBends) {
  for (const Bent& edge : edges_of_row(level_and_arc(8, 0))) {
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
    const std::vector<Bent> edges = edges_of_row(level_and_arc(columns, centre.x()));
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

// A plate with a round hole of twelve sides and radius 1. A vertex of the plate is `above` the
// first side.
PolygonMesh plate_with_hole(double above) {
  constexpr int n = 12;
  PolygonMesh mesh;
  for (const double r : {1., 3.}) {
    for (int k = 0; k < n; ++k) {
      const double angle = (k - .5) * 2 * pi / n;
      mesh.positions.emplace_back(r * std::cos(angle), r * std::sin(angle), 0);
    }
  }
  mesh.positions.emplace_back(std::cos(pi / n) + above, 0, 0);
  for (int k = 1; k < n; ++k) shapes::add_face(mesh, {k, n + k, n + (k + 1) % n, (k + 1) % n});
  for (const auto& face :
       {std::array<int, 3>{0, 2 * n, 1}, {0, n, 2 * n}, {n, n + 1, 2 * n}, {n + 1, 1, 2 * n}})
    shapes::add_face(mesh, {face[0], face[1], face[2]});
  mesh.boundary = BoundaryRule::edges;
  return mesh;
}

TEST(BentPoints, SharpEdgesLeaveRoomForTheFacesBesideThem) {
  const double sagitta = 1 - std::cos(pi / 12);
  for (const double above : {.1 * sagitta, .5 * sagitta, sagitta, 10 * sagitta}) {
    for (const Bent& edge : bent_edges(plate_with_hole(above))) {
      const bool is_on_hole = edge.from.norm() < 1.01 && edge.to.norm() < 1.01 &&
                              std::abs(edge.middle.norm() - 1) < 2 * sagitta && !edge.is_inside;
      if (!is_on_hole) continue;
      const bool is_first = std::abs(edge.middle.y()) < .1 && edge.middle.x() > 0;
      const bool is_crowded = is_first && above < 2 * sagitta;
      EXPECT_NEAR(edge.sag(), is_crowded ? above / 4 : sagitta, 1e-12) << above;
    }
  }
}

// Both of its borders bend alike.
TEST(BentPoints, ANarrowRingStaysRound) {
  constexpr int n = 12;
  PolygonMesh mesh;
  for (const double r : {1., 1.01}) {
    for (int k = 0; k < n; ++k) {
      const double angle = k * 2 * pi / n;
      mesh.positions.emplace_back(r * std::cos(angle), r * std::sin(angle), 0);
    }
  }
  for (int k = 0; k < n; ++k) shapes::add_face(mesh, {k, n + k, n + (k + 1) % n, (k + 1) % n});
  mesh.boundary = BoundaryRule::edges;
  for (const Bent& edge : bent_edges(mesh))
    EXPECT_TRUE(edge.is_inside || std::abs(edge.middle.norm() - edge.from.norm()) < 1e-12);
}

}  // namespace
}  // namespace illustrate
