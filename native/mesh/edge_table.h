// Edges of a mesh found by their vertices.
#pragma once

#include "core/types.h"

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

// First corner of each face, and the number of all corners at the end.
std::vector<int> face_offsets(const std::vector<int>& face_sizes);

}  // namespace illustrate
