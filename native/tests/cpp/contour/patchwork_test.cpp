#include "contour/exact/patchwork.h"

#include <gtest/gtest.h>

#include <numeric>

#include "surface/locate.h"
#include "tests/cpp/surface_checks.h"

namespace illustrate {
namespace {

using namespace surface_checks;

double weight_area(const Patchwork& patchwork, int t) {
  std::array<Vec2, 3> w;
  for (int k = 0; k < 3; ++k) {
    const SurfacePoint corner = on_edge(t, k, 0);
    const SurfacePoint on = patchwork.on_whole(corner, none).on;
    w[idx(k)] = Vec2(on.b1, on.b2);
  }
  return cross(w[1] - w[0], w[2] - w[0]);
}

// Neighbours know each other across the same two places; parts fill what they were cut from, and
// lie on the limit surface.
void check_patchwork(Patchwork& patchwork, const Surface& whole) {
  const Surface& s = patchwork.surface();
  const LimitSurface limit(whole);
  std::map<int, double> filled;
  for (int t = 0; t < static_cast<int>(s.triangles.size()); ++t) {
    for (int k = 0; k < 3; ++k) {
      const int n = s.neighbours[idx(t)][idx(k)];
      if (n != none) {
        const EdgeSide other = opposite_side(s, {t, k});
        ASSERT_EQ(other.triangle, n);
        EXPECT_EQ(s.neighbours[idx(n)][idx(other.corner)], t);
        EXPECT_EQ(s.edge_kinds[idx(n)][idx(other.corner)], s.edge_kinds[idx(t)][idx(k)]);
      }
      const PatchTriangle& patch = s.patches[idx(t)];
      const Vec3& p = s.positions[idx(s.triangles[idx(t)][idx(k)])];
      const auto q = limit.evaluate({patch.ptex_face, patch.uv(k)});
      EXPECT_LT((q->position - p).norm(), 1e-6 * whole.diagonal);
      const Vec3 own = s.corner_sign(t, k) * s.normals[idx(s.triangles[idx(t)][idx(k)])];
      EXPECT_GT(own.dot(q->du.cross(q->dv).normalized()), .9);
    }
    filled[patchwork.on_whole(on_edge(t, 0, 0), none).on.triangle] += weight_area(patchwork, t);
  }
  for (const auto& [source, area] : filled) EXPECT_NEAR(area, 1, 1e-12) << source;
}

TEST(Patchwork, CutsWithoutGaps) {
  for (const PolygonMesh& mesh :
       {shapes::torus_mesh(1, .4, 12, 8), shapes::klein_mesh(12, 8), bumpy_plane(5),
        creased(shapes::cube(), 10), shapes::icosahedron()}) {
    const Surface whole = refined(mesh, at_level(1));
    const LimitSurface limit(whole);
    Patchwork patchwork(whole, limit);
    patchwork.add({3, 4, 9, 17});
    check_patchwork(patchwork, whole);
    std::vector<int> wanted{patchwork.number_of(4), patchwork.number_of(17)};
    for (int round = 0; round < 3; ++round) {
      const std::size_t before = patchwork.surface().triangles.size();
      ASSERT_TRUE(patchwork.cut(wanted));
      EXPECT_GE(patchwork.surface().triangles.size(), before + 3 * wanted.size());
      check_patchwork(patchwork, whole);
      wanted = {0, static_cast<int>(patchwork.surface().triangles.size()) - 1};
    }
    EXPECT_FALSE(patchwork.take_added().empty());
    EXPECT_TRUE(patchwork.take_added().empty());
    patchwork.add({0, 1, 2, 5, 6, 7, 8});
    check_patchwork(patchwork, whole);
  }
}

TEST(Patchwork, WholeSurfacesStayWhole) {
  const Surface whole = refined(shapes::torus_mesh(1, .4, 12, 8), at_level(1));
  const LimitSurface limit(whole);
  Patchwork patchwork(whole, limit);
  std::vector<int> all(whole.triangles.size());
  std::iota(all.begin(), all.end(), 0);
  patchwork.add(all);
  EXPECT_EQ(patchwork.surface().neighbours, whole.neighbours);
  ASSERT_TRUE(patchwork.cut({5, 6, 100}));
  check_patchwork(patchwork, whole);
  for (const auto& neighbours : patchwork.surface().neighbours) {
    EXPECT_EQ(std::count(neighbours.begin(), neighbours.end(), none), 0);
  }
}

TEST(Patchwork, EdgesOfTheWholeAreFoundAgain) {
  const Surface whole = refined(bumpy_plane(3), at_level(1));
  const LimitSurface limit(whole);
  Patchwork patchwork(whole, limit);
  patchwork.add({7});
  ASSERT_TRUE(patchwork.cut({0}));
  int on_edges = 0;
  for (int t = 0; t < static_cast<int>(patchwork.surface().triangles.size()); ++t) {
    for (int k = 0; k < 3; ++k) {
      const Patchwork::Place place = patchwork.on_whole(on_edge(t, k, .25), k);
      if (place.on.triangle != 7 || place.edge == none) continue;
      ++on_edges;
      EXPECT_TRUE(place.fraction == .125 || place.fraction == .625);
    }
  }
  EXPECT_EQ(on_edges, 6);
}

// A tube with a lid of so many corners that the lid has no patches.
PolygonMesh lidded_tube(int n) {
  PolygonMesh tube;
  std::vector<int> lid;
  for (int i = 0; i < n; ++i) {
    const double u = 2 * pi * i / n;
    for (const double z : {0.0, .1}) tube.positions.emplace_back(std::cos(u), std::sin(u), z);
    const int next = (i + 1) % n;
    shapes::add_face(tube, {2 * i, 2 * next, 2 * next + 1, 2 * i + 1});
    lid.push_back(2 * i + 1);
    tube.edge_vertices.push_back({2 * i + 1, 2 * next + 1});
    tube.edge_sharpness.push_back(infinitely_sharp);
  }
  shapes::add_face(tube, lid);
  return tube;
}

TEST(Patchwork, FacesWithoutPatchesAreCutBesideOthersOnly) {
  const PolygonMesh tube = lidded_tube(101);
  const Surface whole = refined(tube, at_level(1, Scheme::catmull_clark));
  const LimitSurface limit(whole);
  const auto has_patches = [&](int t) {
    return limit.evaluate({whole.patches[idx(t)].ptex_face, Vec2(.5, .5)}).has_value();
  };
  int cut = 0;
  for (int t = 0; t < static_cast<int>(whole.triangles.size()); ++t) {
    Patchwork patchwork(whole, limit);
    patchwork.add({t});
    EXPECT_EQ(patchwork.cut({0}), has_patches(t));
    for (const int n : whole.neighbours[idx(t)])
      cut += has_patches(t) && n != none && !has_patches(n);
    for (const Vec3& p : patchwork.surface().positions) ASSERT_LT(p.norm(), 2);
    for (const Vec3& n : patchwork.surface().normals) ASSERT_NEAR(n.norm(), 1, 1e-9);
  }
  EXPECT_EQ(cut, 2 * 101) << "sides along the lid";
}

TEST(Patchwork, PolygonsCannotBeCut) {
  const Surface whole = refined(shapes::cube(), at_level(0, Scheme::polygons));
  const LimitSurface limit(whole);
  Patchwork patchwork(whole, limit);
  patchwork.add({0, 1});
  EXPECT_FALSE(patchwork.cut({0, 1}));
}

}  // namespace
}  // namespace illustrate
