// The smooth sides of a surface at its vertices: the faces round a vertex between two sharp or open
// edges.
//
// A vertex without sharp edges has one closed sector, and so has the end of a single sharp edge (a
// dart): the surface is smooth there.
#pragma once

#include "surface/subdivision/refined_mesh.h"

namespace illustrate {

struct Sectors {
  std::vector<int> corner_sectors;   // (c) none: of a vertex that was not asked for
  std::vector<int> first_corners;    // (s) the others follow counter-clockwise
  std::vector<int> sizes;            // (s) number of corners
  std::vector<std::uint8_t> closed;  // (s) 1: goes all the way round
  std::vector<int> sharp_edges;      // (n) sharp and open edges at each vertex

  std::size_t count() const { return sizes.size(); }
};

// Numbered by their lowest corners. `wanted` (n): 0 leaves a vertex out; empty: all are wanted.
Sectors smooth_sectors(const RefinedMesh& mesh, const std::vector<std::uint8_t>& wanted = {});

// The corner after this one counter-clockwise round their vertex, `none` beyond an open edge.
inline int next_round_vertex(const RefinedMesh& mesh, int corner) {
  return mesh.mate(mesh.previous(corner));
}

}  // namespace illustrate
