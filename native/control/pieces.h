// The triangles by which a face that is split once is seen to turn over.
#pragma once

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

// Twice the area of a triangle seen along a normal.
inline double twice_area(const Points& points, const Vec3& normal, int a, int b, int c) {
  const Vec3& p = points[idx(a)];
  return (points[idx(b)] - p).cross(points[idx(c)] - p).dot(normal);
}

}  // namespace illustrate
