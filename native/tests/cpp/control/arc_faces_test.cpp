// Patches on the arcs of edges.
#include "control/arc_faces.h"

#include <gtest/gtest.h>

#include "control/bent_points.h"
#include "control/split_once.h"
#include "mesh/sanitize.h"
#include "tests/cpp/shapes.h"

namespace illustrate {
namespace {

Vec3 lifted(double x, double y) { return {x, y, 1 + x - 2 * y + 3 * x * x - x * y + 2 * y * y}; }

PolygonMesh quadric(bool triangles) {
  const Points corners{lifted(0, 0), lifted(2, 0), lifted(2, 1), lifted(0, 1)};
  return triangles ? shapes::polygon_mesh(corners, {{0, 1, 2}, {0, 2, 3}})
                   : shapes::polygon_mesh(corners, {{0, 1, 2, 3}});
}

TEST(ArcFaces, AreExactOnQuadrics) {
  for (const Scheme scheme : {Scheme::loop, Scheme::catmull_clark}) {
    Counts report;
    const SoundMesh mesh = sanitize(quadric(scheme == Scheme::loop), report);
    const HalfEdges edges(mesh);
    const SoundMesh child = split_once(mesh, edges, scheme);
    Points points = bent_points(mesh, edges, find_sectors(edges, mesh.positions.size()), scheme);
    const auto in_plane = [](const Vec3& p) { return lifted(p.x(), p.y()); };
    for (std::size_t e = 0; e < edges.first.size(); ++e) {
      const Vec3& from = mesh.positions[idx(edges.faces.corners[idx(edges.first[e])])];
      const Vec3& to = mesh.positions[idx(edges.faces.head(edges.first[e]))];
      points[mesh.positions.size() + e] = in_plane((from + to) / 2);
    }
    if (scheme == Scheme::catmull_clark) points.back() = lifted(1, .5);
    const ArcFaces arcs = arc_faces(edges, points, std::vector<double>(4, .25), scheme);
    const std::size_t size = scheme == Scheme::loop ? 3 : 4;
    for (std::size_t f = 0; f < child.face_sizes.size(); ++f) {
      const Span<const int> vertices{child.corner_vertices.data() + size * f, size};
      for (const Vec2& uv : {Vec2(0, 0), Vec2(.5, 0), Vec2(.25, .25), Vec2(.125, .625)}) {
        const ArcPoint p = evaluate(arcs, vertices, static_cast<int>(size * f), uv);
        EXPECT_NEAR(p.position.z(), in_plane(p.position).z(), 1e-13);
        EXPECT_NEAR(p.weight, .25, 1e-15);
        const double h = 1e-4;
        const auto at = [&](double u, double v) {
          return evaluate(arcs, vertices, static_cast<int>(size * f), uv + Vec2(u, v)).position;
        };
        EXPECT_LT(((at(h, 0) - at(-h, 0)) / (2 * h) - p.du).norm(), 1e-9);
        EXPECT_LT(((at(0, h) - at(0, -h)) / (2 * h) - p.dv).norm(), 1e-9);
        EXPECT_LT(((at(h, 0) - 2 * at(0, 0) + at(-h, 0)) / (h * h) - p.duu).norm(), 1e-5);
        EXPECT_LT(((at(0, h) - 2 * at(0, 0) + at(0, -h)) / (h * h) - p.dvv).norm(), 1e-5);
        const Vec3 mixed = at(h, h) - at(h, -h) - at(-h, h) + at(-h, -h);
        EXPECT_LT((mixed / (4 * h * h) - p.duv).norm(), 1e-5);
      }
    }
  }
}

}  // namespace
}  // namespace illustrate
