// Edges of a sound mesh: which polygon corners they join and of what kind they are.
#pragma once

#include "mesh/sanitize.h"
#include "surface/surface.h"

namespace illustrate {

// Pairs of vertices with values, found by either order of the pair.
class EdgeTable {
 public:
  // `vertex_count` bounds the vertices; `edges` in any order, repeated ones keep their first
  // number.
  EdgeTable(std::size_t vertex_count, const std::vector<Edge>& edges);

  // Number of the edge in the list it was made of, `none` where it is not in it.
  int find(int a, int b) const;

 private:
  std::vector<int> offsets_;
  std::vector<std::array<int, 2>> entries_;  // the larger vertex, the edge's number
};

// Kinds of edges known from the mesh itself, strongest first: open (boundary or seam), crease,
// mark, material.
class BaseEdgeKinds {
 public:
  explicit BaseEdgeKinds(const SoundMesh& mesh);

  // face_a, face_b: faces on both sides; face_b is `none` at an open edge.
  EdgeKind kind(int vertex_a, int vertex_b, int face_a, int face_b) const;

 private:
  const SoundMesh& mesh_;
  EdgeTable creases_, marks_, seams_;
};

// Whether some part of the mesh is on both sheets.
bool has_double_cover(const SoundMesh& mesh);

// First corner of each face, and the number of all corners at the end.
std::vector<int> face_offsets(const std::vector<int>& face_sizes);

}  // namespace illustrate
