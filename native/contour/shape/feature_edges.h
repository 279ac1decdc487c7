// Feature curves that do not depend on the view: boundaries, creases, seams, marks, material
// borders, outlines of flat areas (paper section 4).
#pragma once

#include "surface/surface.h"

namespace illustrate {

// One side of an edge: edge `corner` (corner to the next one) of `triangle`.
struct EdgeSide {
  int triangle = none;
  int corner = none;
};

// An edge that is not smooth, once. The second side is empty where there is no neighbour.
struct FeatureEdge {
  EdgeKind kind;
  std::array<EdgeSide, 2> sides;
};

// The side of the neighbour across an edge; empty where there is none.
EdgeSide opposite_side(const Surface& surface, const EdgeSide& side);

// All of them, in the order of their first sides.
std::vector<FeatureEdge> feature_edges(const Surface& surface);

}  // namespace illustrate
