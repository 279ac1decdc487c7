// Polygons under repair, and their half-edges.
//
// A half-edge has the index of the corner it starts at and runs to the next corner of its face.
#pragma once

#include "core/ragged.h"
#include "core/types.h"

namespace illustrate {

struct Faces {
  std::vector<int> offsets{0};    // (f+1) corners of face f: offsets[f] .. offsets[f+1]
  std::vector<int> corners;       // (c) vertex of each corner
  std::vector<int> corner_faces;  // (c) face of each corner
  std::vector<int> sources;       // (f) face of the input; parts of one face stand side by side

  int size() const { return static_cast<int>(sources.size()); }
  int corner_count() const { return static_cast<int>(corners.size()); }

  Span<const int> operator[](int face) const {
    return {corners.data() + offsets[face],
            static_cast<std::size_t>(offsets[face + 1] - offsets[face])};
  }

  int next(int half_edge) const {
    const int face = corner_faces[half_edge];
    return half_edge + 1 == offsets[face + 1] ? offsets[face] : half_edge + 1;
  }
  int previous(int half_edge) const {
    const int face = corner_faces[half_edge];
    return half_edge == offsets[face] ? offsets[face + 1] - 1 : half_edge - 1;
  }
  // The vertex where a half-edge ends.
  int head(int half_edge) const { return corners[next(half_edge)]; }

  // The half-edge of the same edge when the face's corners are read backwards: the face then
  // occupies [first, first + its size).
  int reversed(int half_edge, int first) const;

  void push_corner(int vertex) { corners.push_back(vertex); }
  // Ends the face whose corners were pushed.
  void close_face(int source);
};

// Which faces are joined, and along which edges: the two half-edges of an edge name each other.
struct FaceAdjacency {
  std::vector<int> partners;         // (c) half-edge on the other side; none at open edges
  std::vector<std::uint8_t> is_cut;  // (c) 1: of an edge that was split
};

// The half-edges of each edge in ascending order; edges ordered by lower, then by higher vertex.
Ragged<int> half_edges_by_edge(const Faces& faces, std::size_t vertex_count);

// Of a face at one of its corners, between the two edges there, radians.
double corner_angle(const Faces& faces, const Points& positions, int corner);

// How far the face of a half-edge reaches from the half-edge's line.
double reach_of_face(const Faces& faces, const Points& positions, int half_edge);

// Unit normals by Newell's formula, at any scale; zero for faces without area.
Points unit_normals(const Faces& faces, const Points& positions);

}  // namespace illustrate
