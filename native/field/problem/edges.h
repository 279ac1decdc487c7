// The edges of the triangles: the sum of the paper's energy runs over them.
#pragma once

#include "core/ragged.h"
#include "field/problem/frames.h"
#include "surface/surface.h"

namespace illustrate {

struct TriangleEdges {
  std::vector<Edge> vertices;                   // (m) lower index first, sorted
  std::vector<std::array<int, 3>> of_triangle;  // (t) corner k to k + 1; or none
  std::vector<int> faces;                       // (m) triangles at each edge
  std::vector<std::uint8_t> mirrored;           // (m) 1: ends on different sheets

  std::size_t size() const { return vertices.size(); }
};

TriangleEdges triangle_edges(const Surface& surface, const Progress& progress = {});

// How a cross is carried along an edge: the cross at `from` agrees with the one at `to` when z_from
// = transport z_to / |transport|, z_to mirrored where asked for. |transport| is the edge's weight.
struct FieldEdge {
  int from = 0;
  int to = 0;
  bool mirrored = false;
  CrossNumber transport = 1;
};

// The edge along `direction` (world) between two vertices: transport = weight exp(i c), c = 4
// (phi_ij -+ phi_ji).
FieldEdge field_edge(const TangentFrames& frames, int from, int to, bool mirrored,
                     const Vec3& direction, double weight);

// All edges of the triangles with their weights (m), each 1 where there are none.
std::vector<FieldEdge> field_edges(const Surface& surface, const TriangleEdges& edges,
                                   const TangentFrames& frames, const std::vector<double>& weights,
                                   int threads, const Progress& progress = {});

}  // namespace illustrate
