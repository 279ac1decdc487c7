// What every result of `sanitize` promises, whatever went in.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>

#include <limits>
#include <map>
#include <set>
#include <utility>

#include "core/tolerances.h"
#include "mesh/clean.h"
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

// What lies on edges of one sheet lies on those of the other.
inline void check_twin_edges(const SoundMesh& mesh) {
  const auto ordered = [](int a, int b) { return Edge{std::min(a, b), std::max(a, b)}; };
  const auto expect_twin = [&](const std::map<Edge, double>& found) {
    for (const auto& [edge, value] : found) {
      const int a = mesh.twin_vertices[edge[0]], b = mesh.twin_vertices[edge[1]];
      if (a == none || b == none) continue;
      const auto twin = found.find(ordered(a, b));
      EXPECT_TRUE(twin != found.end() && twin->second == value) << edge[0] << " " << edge[1];
    }
  };
  std::map<Edge, double> creases, marks, seams;
  for (std::size_t e = 0; e < mesh.edge_vertices.size(); ++e)
    creases[ordered(mesh.edge_vertices[e][0], mesh.edge_vertices[e][1])] = mesh.edge_sharpness[e];
  for (const auto& [a, b] : mesh.marked_edges) marks[ordered(a, b)] = 1;
  for (const auto& [a, b] : mesh.seams) seams[ordered(a, b)] = 1;
  for (const auto* found : {&creases, &marks, &seams}) expect_twin(*found);
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
  check_twin_edges(mesh);
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

// Where the faces of the input start in corner_vertices.
inline std::vector<int> face_starts(const PolygonMesh& input) {
  std::vector<int> starts{0};
  for (const int size : input.face_sizes) starts.push_back(starts.back() + size);
  return starts;
}

inline double largest_size(const PolygonMesh& input) {
  Eigen::AlignedBox3d box;
  for (const Vec3& p : input.positions)
    if ((p.array().abs() <= max_coordinate).all()) box.extend(p);
  return box.isEmpty() ? 0 : box.sizes().maxCoeff();
}

// How far `p` is off the corners of an input's face, or off its edges.
inline double off_face(const PolygonMesh& input, int first, int size, const Vec3& p, bool edges) {
  const auto corner = [&](int k) {
    return input.positions[input.corner_vertices[first + k % size]];
  };
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < size; ++k) {
    const Vec3 edge = corner(k + 1) - corner(k), off = p - corner(k);
    const double share = edges ? std::clamp(off.dot(edge) / edge.squaredNorm(), 0., 1.) : 0;
    const Vec3 rest = share > 0 ? Vec3(off - share * edge) : off;
    least = std::min(least, rest.cwiseAbs().maxCoeff());
  }
  return least;
}

// Every corner of a face lies where a corner of the input's face lies, to within rounding, or on an
// edge of it that was divided; where gaps were closed and edges divided to within the widest gap, a
// few in a row.
inline void check_sources(const PolygonMesh& input, const SoundMesh& mesh, Counts report) {
  const bool is_divided = report["junctions"] > 0;
  const bool is_moved = is_divided || report["closed_gaps"] > 0;
  const double rounding = (is_moved ? 5e-4 : tolerance::same_place) * largest_size(input);
  const std::vector<int> starts = face_starts(input);
  const int* corner = mesh.corner_vertices.data();
  for (std::size_t f = 0; f < mesh.face_sizes.size(); ++f) {
    const int source = mesh.source_faces[f];
    ASSERT_GE(source, 0);
    ASSERT_LT(source, static_cast<int>(input.face_sizes.size()));
    for (int k = 0; k < mesh.face_sizes[f]; ++k, ++corner) {
      const double off = off_face(input, starts[source], input.face_sizes[source],
                                  mesh.positions[*corner], is_divided);
      EXPECT_LE(off, rounding) << "face " << f << " of " << source;
    }
  }
}

// Every face of the input is kept, whole or in parts, once or with its twin, or counted as dropped.
inline void check_faces_accounted(const PolygonMesh& input, const SoundMesh& mesh, Counts report) {
  const std::set<int> kept(mesh.source_faces.begin(), mesh.source_faces.end());
  EXPECT_EQ(report["kept_faces"], static_cast<std::int64_t>(kept.size()));
  EXPECT_EQ(report["input_faces"], static_cast<std::int64_t>(input.face_sizes.size()));
  EXPECT_EQ(report["input_faces"], report["kept_faces"] + report["nan_faces"] +
                                       report["degenerate_faces"] + report["huge_faces"] +
                                       report["duplicate_faces"]);
  for (const auto& [name, count] : report) EXPECT_GE(count, 0) << name;
  check_sources(input, mesh, report);
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
