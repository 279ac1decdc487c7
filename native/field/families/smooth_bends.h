// How much the surface bends along both directions of a cross, without its roughness.
#pragma once

#include "field/cross_field.h"
#include "field/problem/edges.h"

namespace illustrate {

// The cells round the vertices, bounded by lines from the middles of edges to those of triangles.
struct DualCells {
  std::vector<double> areas;    // (n) of vertices
  std::vector<double> lengths;  // (m) of what parts the cells of an edge's ends
};
DualCells dual_cells(const Surface& surface, const TriangleEdges& edges);

// An edge as one of its ends sees it.
struct DualLink {
  int vertex;
  double length;  // of what parts the two cells
  double weight;  // the same over the edge's length
  bool mirrored;  // the ends lie on different sheets
};
Ragged<DualLink> dual_links(const Surface& surface, const TriangleEdges& edges,
                            const DualCells& cells);

// (n) |normal curvature| along `directions` and across: of the curvature tensor after a while of
// heat flow, as far as .02 diagonals of the vertex's piece, so that dents much smaller than
// that cancel. Nothing bends more than 100 in a diagonal. pieces: vertices of each; what happens in
// one depends on no other.
std::vector<Vec2> smooth_bends(const Surface& surface, const Curvature& curvature,
                               const CrossField& field, const Ragged<DualLink>& links,
                               const DualCells& cells, const Ragged<int>& pieces,
                               const std::vector<double>& diagonals, const Progress& progress = {});

}  // namespace illustrate
