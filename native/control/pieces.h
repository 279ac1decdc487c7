// The triangles by which a face that is split once is seen to turn over.
#pragma once

#include <algorithm>

#include "control/half_edges.h"

namespace illustrate {

// Calls visit(a, b, c) for each piece of a face, with its corners among the vertices of the mesh
// split once (control/split_once.h): of triangles the four, of other faces and where the split mesh
// has the middles of faces the halves of its quads at the face's corners and at its middle.
template <class Visit>
void for_each_piece(const HalfEdges& edges, int vertex_count, bool has_middles, int face,
                    const Visit& visit) {
  const Faces& faces = edges.faces;
  const int first = faces.offsets[idx(face)], end = faces.offsets[idx(face) + 1];
  const auto in_edge = [&](int h) { return vertex_count + edges.edges[idx(h)]; };
  const int in_face = vertex_count + edges.edge_count() + face;
  for (int h = first; h < end; ++h) {
    const int after = in_edge(h), before = in_edge(faces.previous(h));
    visit(faces.corners[idx(h)], after, before);
    if (has_middles) visit(in_face, before, after);
  }
  if (!has_middles) visit(in_edge(first), in_edge(first + 1), in_edge(first + 2));
}

// What a piece keeps of its area, seen along a unit normal, when its corners move from `places`:
// below 0 it turns over. An area of less than a millionth of its longest edge squared is rounding,
// as that of a straight corner, and counts as so much; what is turned over from the start keeps
// all.
inline double share_kept(const Points& places, const Points& moved, const Vec3& normal, int a,
                         int b, int c) {
  constexpr double least_area = 1e-6;
  const auto twice_area = [&](const Points& p) {
    return (p[idx(b)] - p[idx(a)]).cross(p[idx(c)] - p[idx(a)]).dot(normal);
  };
  const auto squared = [&](int from, int to) {
    return (places[idx(to)] - places[idx(from)]).squaredNorm();
  };
  const double least = least_area * std::max({squared(a, b), squared(b, c), squared(c, a)});
  const double area = twice_area(places);
  if (!(area >= -least && least > 0)) return 1;
  return 1 - (area - twice_area(moved)) / std::max(area, least);
}

}  // namespace illustrate
