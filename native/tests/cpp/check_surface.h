// What holds for every Surface.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "surface/surface.h"

namespace illustrate {
namespace check {

inline std::size_t index(int i) { return static_cast<std::size_t>(i); }

inline void sizes(const Surface& s) {
  const std::size_t n = s.positions.size(), t = s.triangles.size();
  for (const std::size_t size : {s.normals.size(), s.objects.size(), s.places.size(),
                                 s.base_faces.size(), s.base_uv.size(), s.curvature.size()}) {
    ASSERT_EQ(size, n);
  }
  for (const std::size_t size :
       {s.flips.size(), s.neighbours.size(), s.edge_kinds.size(), s.triangle_objects.size()}) {
    ASSERT_EQ(size, t);
  }
  ASSERT_EQ(s.feature_edges.size(), s.feature_kinds.size());
}

inline void vertices(const Surface& s) {
  for (std::size_t v = 0; v < s.positions.size(); ++v) {
    ASSERT_TRUE(s.positions[v].allFinite()) << v;
    ASSERT_NEAR(s.normals[v].norm(), 1, 1e-12) << v;
    ASSERT_GE(s.objects[v], 0);
    ASSERT_LT(index(s.objects[v]), s.object_is_smooth.size());
    const std::size_t place = index(s.places[v]);
    ASSERT_LT(place, s.positions.size());
    ASSERT_EQ(s.places[place], s.places[v]) << "a place is the number of its first vertex";
    ASSERT_TRUE((s.positions[place].array() == s.positions[v].array()).all()) << v;
    ASSERT_EQ(s.objects[place], s.objects[v]);
    const bool smooth = s.object_is_smooth[index(s.objects[v])];
    const auto& off_limit = s.controls[index(s.objects[v])].mesh->off_limit;
    const bool is_off = s.base_faces[v] == none && !off_limit.empty();
    ASSERT_EQ(s.base_faces[v] != none || is_off, smooth) << v;
    ASSERT_TRUE((s.base_uv[v].array() >= 0).all() && (s.base_uv[v].array() <= 1).all()) << v;
  }
}

inline void curvature(const Surface& s, const Curvature& c) {
  for (std::size_t v = 0; v < s.positions.size(); ++v) {
    ASSERT_TRUE(std::isfinite(c[v].k1) && std::isfinite(c[v].k2)) << v;
    ASSERT_GE(std::abs(c[v].k1), std::abs(c[v].k2)) << v;
    ASSERT_NEAR(c[v].w1.norm(), 1, 1e-9) << v;
    ASSERT_NEAR(c[v].w2.norm(), 1, 1e-9) << v;
    ASSERT_NEAR(c[v].w1.dot(c[v].w2), 0, 1e-9) << v;
    if (!s.object_is_smooth[index(s.objects[v])]) continue;  // tangent to the jet
    ASSERT_NEAR(c[v].w1.dot(s.normals[v]), 0, 1e-8) << v;
    ASSERT_NEAR(c[v].w2.dot(s.normals[v]), 0, 1e-8) << v;
  }
}

// The edge of `other` that is edge k of triangle t; the same by places where sides or copies
// differ.
inline int same_edge(const Surface& s, int t, int k, int other) {
  const auto place = [&](int triangle, int corner) {
    return s.places[index(s.triangles[index(triangle)][index(corner)])];
  };
  for (int j = 0; j < 3; ++j) {
    if (s.neighbours[index(other)][index(j)] != t) continue;
    const Edge a{place(t, k), place(t, next_corner(k))};
    const Edge b{place(other, j), place(other, next_corner(j))};
    if (a == b || a == Edge{b[1], b[0]}) return j;
  }
  return none;
}

inline void edges(const Surface& s) {
  std::size_t features = 0;
  for (int t = 0; t < static_cast<int>(s.triangles.size()); ++t) {
    for (int k = 0; k < 3; ++k) {
      const int v = s.triangles[index(t)][index(k)];
      ASSERT_GE(v, 0);
      ASSERT_LT(index(v), s.positions.size());
      ASSERT_EQ(s.objects[index(v)], s.triangle_objects[index(t)]);
      const int n = s.neighbours[index(t)][index(k)];
      const EdgeKind kind = s.edge_kinds[index(t)][index(k)];
      const bool open = kind == EdgeKind::boundary || kind == EdgeKind::seam;
      ASSERT_EQ(n == none, open) << "triangle " << t << " edge " << k;
      if (n != none) {
        const int j = same_edge(s, t, k, n);
        ASSERT_NE(j, none) << "triangle " << t << " edge " << k;
        ASSERT_EQ(s.edge_kinds[index(n)][index(j)], kind);
      }
      if (kind == EdgeKind::smooth) continue;
      features += kind == EdgeKind::crease || n == none || t < n;
    }
  }
  ASSERT_EQ(s.feature_edges.size(), features);
  for (const EdgeKind kind : s.feature_kinds) ASSERT_NE(kind, EdgeKind::smooth);
}

// Across an edge that is not sharp, both triangles use the same vertices: one that runs along the
// edge the other way round is of the same sheet and has the same flips there, else the other flips.
inline void sheets(const Surface& s) {
  for (int t = 0; t < static_cast<int>(s.triangles.size()); ++t) {
    for (int k = 0; k < 3; ++k) {
      const int n = s.neighbours[index(t)][index(k)];
      if (n == none || s.edge_kinds[index(t)][index(k)] == EdgeKind::crease) continue;
      const int j = same_edge(s, t, k, n);
      const int a = s.triangles[index(t)][index(k)],
                b = s.triangles[index(t)][index(next_corner(k))];
      const bool turned = s.triangles[index(n)][index(j)] == b;
      ASSERT_EQ(s.triangles[index(n)][index(turned ? next_corner(j) : j)], a);
      const double sign = turned ? 1 : -1;
      ASSERT_EQ(s.corner_sign(t, k), sign * s.corner_sign(n, turned ? next_corner(j) : j));
      ASSERT_EQ(s.corner_sign(t, next_corner(k)),
                sign * s.corner_sign(n, turned ? j : next_corner(j)));
    }
  }
}

}  // namespace check

inline void check_surface(const Surface& surface) {
  check::sizes(surface);
  if (::testing::Test::HasFatalFailure()) return;
  check::vertices(surface);
  if (::testing::Test::HasFatalFailure()) return;
  check::curvature(surface, surface.curvature);
  check::edges(surface);
  if (::testing::Test::HasFatalFailure()) return;
  check::sheets(surface);
}

}  // namespace illustrate
