// How the faces of a sound mesh are shaded: what its creases are found from.
#pragma once

#include <cmath>

#include "core/angles.h"
#include "mesh/faces.h"
#include "mesh/sanitize.h"

namespace illustrate {

struct Shading {
  // (f) unit, zero where there is none: of slivers that of the face that they lie along. A sliver
  // is so thin that the rounding of its coordinates turns its plane: its own normal says nothing.
  Points face_normals;
  Points corner_normals;                  // (c) unit, as given in the input; else the face's
  std::vector<std::uint8_t> is_flat;      // (f) 1: shaded with its own normal at all corners
  std::vector<std::uint8_t> is_reversed;  // (f) 1: wound against the input
};

// Normals within this angle of their face's own are shaded flat: far above the rounding of what
// files hold (8 bits a component: .5 degrees), far below what anyone shades smooth on purpose.
constexpr double flat_shading_deg = 1;
inline const double flat_shading_cosine = std::cos(radians(flat_shading_deg));

// Corner normals that differ by more make a crease: the angles that files hold are nearly all below
// .05 degrees, where the edge is smooth, or above 5.
constexpr double crease_normals_deg = 5;
inline const double crease_normals_cosine = std::cos(radians(crease_normals_deg));

// Whether corner normals differ at the two ends of an edge.
struct EndsDiffer {
  bool start = false, end = false;
};

// edge: its half-edges, of which the first runs from start to end. Edges between flat faces, open
// ones and those of faces without normals have none.
EndsDiffer ends_differ(const Faces& faces, Span<const int> edge, const Shading& shading);

// Of an edge with two faces.
bool are_flat(const Faces& faces, Span<const int> edge, const Shading& shading);

// faces: those of `sound`, whose positions, source_vertices, twins and kept stand. numbers:
// of the vertices as welded. edges: half_edges_by_edge's. Normals of reversed faces are turned with
// them. Of a face and its twin the normals are opposite, to the bit.
Shading read_shading(const PolygonMesh& mesh, const Faces& faces, const Ragged<int>& edges,
                     const std::vector<int>& numbers, const SoundMesh& sound);

}  // namespace illustrate
