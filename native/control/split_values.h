// Values at the vertices of a mesh, for those of the mesh split once (control/split_once.h).
#pragma once

#include "control/half_edges.h"

namespace illustrate {

// Appends to the values (n) of the vertices the means of the edges' ends and, where the split mesh
// has more vertices than these, the means of the faces' corners.
template <class T>
void append_means(const HalfEdges& edges, std::size_t count, std::vector<T>& values) {
  const Faces& faces = edges.faces;
  for (const int h : edges.first)
    values.push_back((values[idx(faces.corners[idx(h)])] + values[idx(faces.head(h))]) / 2);
  for (int f = 0; values.size() < count; ++f) {
    T sum = values[idx(faces[f][0])];
    for (std::size_t k = 1; k < faces[f].size(); ++k) sum += values[idx(faces[f][k])];
    values.push_back(sum / static_cast<double>(faces[f].size()));
  }
}

}  // namespace illustrate
