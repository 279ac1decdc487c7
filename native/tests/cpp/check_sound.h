// What every result of `sanitize` promises, whatever went in.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "mesh/sanitize.h"

namespace illustrate {

// Half-edges of a sound mesh: (from, to) -> face. Fails where two faces run along an edge in the
// same direction, which also covers edges with more than two faces.
inline std::map<Edge, int> check_half_edges(const SoundMesh& mesh) {
  std::map<Edge, int> half_edges;
  const int* corner = mesh.corner_vertices.data();
  for (int f = 0; f < static_cast<int>(mesh.face_sizes.size()); ++f) {
    const int size = mesh.face_sizes[f];
    EXPECT_GE(size, 3);
    EXPECT_EQ(std::set<int>(corner, corner + size).size(), static_cast<std::size_t>(size));
    for (int k = 0; k < size; ++k) {
      const bool is_new = half_edges.insert({{corner[k], corner[(k + 1) % size]}, f}).second;
      EXPECT_TRUE(is_new) << "face " << f;
    }
    corner += size;
  }
  return half_edges;
}

// One fan at each vertex: at each vertex, the faces' wedges (from the edge in to the edge out) form
// one path or one cycle.
inline void check_fans(const SoundMesh& mesh) {
  std::vector<std::map<int, int>> successors(mesh.positions.size());  // neighbour out -> in
  const int* corner = mesh.corner_vertices.data();
  for (const int size : mesh.face_sizes) {
    for (int k = 0; k < size; ++k)
      successors[corner[k]][corner[(k + 1) % size]] = corner[(k + size - 1) % size];
    corner += size;
  }
  for (const auto& wedges : successors) {
    ASSERT_FALSE(wedges.empty());
    std::set<int> inner;
    for (const auto& wedge : wedges) inner.insert(wedge.second);
    int start = wedges.begin()->first;
    for (const auto& wedge : wedges)
      if (inner.count(wedge.first) == 0) start = wedge.first;
    std::size_t steps = 0;
    int at = start;
    while (steps < wedges.size() && wedges.count(at) != 0) {
      at = wedges.at(at);
      ++steps;
      if (at == start) break;
    }
    ASSERT_EQ(steps, wedges.size());
  }
}

inline void check_edge_lists(const SoundMesh& mesh, const std::map<Edge, int>& half_edges) {
  const auto has = [&](int a, int b) { return half_edges.count({a, b}) != 0; };
  ASSERT_EQ(mesh.edge_sharpness.size(), mesh.edge_vertices.size());
  std::set<Edge> unique;
  for (std::size_t e = 0; e < mesh.edge_vertices.size(); ++e) {
    const auto [a, b] = mesh.edge_vertices[e];
    EXPECT_TRUE(has(a, b) || has(b, a));
    EXPECT_GT(mesh.edge_sharpness[e], 0);
    EXPECT_LE(mesh.edge_sharpness[e], infinitely_sharp);
    EXPECT_TRUE(unique.insert({std::min(a, b), std::max(a, b)}).second);
  }
  for (const auto& [a, b] : mesh.marked_edges) EXPECT_TRUE(has(a, b) || has(b, a));
  for (const auto& [a, b] : mesh.seams) EXPECT_TRUE(has(a, b) && !has(b, a));
}

// The two sheets mirror each other, and one of them is kept.
inline void check_twins(const SoundMesh& mesh, const std::map<Edge, int>& half_edges) {
  for (std::size_t f = 0; f < mesh.face_sizes.size(); ++f) {
    const int twin = mesh.twin_faces[f];
    if (twin == none) {
      EXPECT_EQ(mesh.kept[f], 1);
      continue;
    }
    EXPECT_EQ(mesh.twin_faces[twin], static_cast<int>(f));
    EXPECT_NE(mesh.kept[f], mesh.kept[twin]);
    EXPECT_EQ(mesh.source_faces[f], mesh.source_faces[twin]);
  }
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const int twin = mesh.twin_vertices[v];
    if (twin == none) continue;
    EXPECT_NE(twin, static_cast<int>(v));
    EXPECT_EQ(mesh.twin_vertices[twin], static_cast<int>(v));
    EXPECT_EQ(mesh.source_vertices[v], mesh.source_vertices[twin]);
  }
  for (const auto& [edge, face] : half_edges) {
    if (mesh.twin_faces[face] == none) continue;
    const Edge twin{mesh.twin_vertices[edge[1]], mesh.twin_vertices[edge[0]]};
    const auto found = half_edges.find(twin);
    ASSERT_NE(found, half_edges.end());
    EXPECT_EQ(found->second, mesh.twin_faces[face]);
  }
}

inline void check_sound(const SoundMesh& mesh) {
  const std::size_t n = mesh.positions.size(), f = mesh.face_sizes.size();
  ASSERT_EQ(mesh.source_vertices.size(), n);
  ASSERT_EQ(mesh.vertex_sharpness.size(), n);
  ASSERT_EQ(mesh.twin_vertices.size(), n);
  ASSERT_EQ(mesh.source_faces.size(), f);
  ASSERT_EQ(mesh.face_materials.size(), f);
  ASSERT_EQ(mesh.holes.size(), f);
  ASSERT_EQ(mesh.twin_faces.size(), f);
  ASSERT_EQ(mesh.kept.size(), f);
  for (const Vec3& position : mesh.positions) EXPECT_TRUE(position.allFinite());
  for (const double sharpness : mesh.vertex_sharpness)
    EXPECT_TRUE(sharpness >= 0 && sharpness <= infinitely_sharp);
  const std::map<Edge, int> half_edges = check_half_edges(mesh);
  check_fans(mesh);
  check_edge_lists(mesh, half_edges);
  check_twins(mesh, half_edges);
}

// Every face of the input is kept, once or with its twin, or counted as dropped.
inline void check_faces_accounted(const PolygonMesh& input, const SoundMesh& mesh, Counts report) {
  const auto kept = std::count(mesh.kept.begin(), mesh.kept.end(), 1);
  EXPECT_EQ(kept + report["nan_faces"] + report["degenerate_faces"] + report["huge_faces"] +
                report["duplicate_faces"],
            static_cast<std::int64_t>(input.face_sizes.size()));
}

struct Mended {
  SoundMesh mesh;
  Counts report;
};

inline Mended mend(const PolygonMesh& input) {
  Mended mended;
  mended.mesh = sanitize(input, mended.report);
  check_sound(mended.mesh);
  check_faces_accounted(input, mended.mesh, mended.report);
  return mended;
}

}  // namespace illustrate
