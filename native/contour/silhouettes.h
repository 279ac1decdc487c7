// Silhouettes as the zero set of g(p) = n(p) . (c - p) (paper sections 4.1, 4.2; the sign turned so
// that front is positive).
//
// g is linear on each triangle; g = 0 counts as front, so each triangle carries at most one segment
// and chains are closed or end on edges without a smooth neighbour. Their cusps are found by
// `exact_silhouettes`, from what the cusp function C = k1 (v.w1)^2 + k2 (v.w2)^2 suggests. Objects
// of scheme none have no g: their silhouettes are mesh edges between a front and a back face, found
// by `polygon_silhouettes`.
#pragma once

#include "contour/contour_functions.h"
#include "contour/dual/dual_surface.h"
#include "core/ragged.h"

namespace illustrate {

// A point of a chain: on edge `edge` of its triangle, at `fraction` from that edge's first corner,
// or, when edge is none, inside the triangle.
struct ChainPoint {
  Vec3 position;
  SurfacePoint
      on;  // in the triangle of the segment that starts here (of the last segment, at an open end)
  double fraction = 0;
  int edge = none;
  int cusp_jump = 0;  // cusps: +1 where the chain recedes from the viewer, -1 elsewhere; 0: no cusp
};

// A point where a chain enters a triangle over one of its edges (or leaves the last one).
struct EdgePoint : ChainPoint {
  double cusp_function = 0;     // of the triangle's sheet, interpolated
  bool has_both_signs = false;  // C at the triangle's corners
  int out = none;               // edge over which the chain leaves the triangle
  bool is_unseen = false;       // the segment that starts here (unseen.h)
};

// Chains of edge points, which run with the front on their left; segment i of a chain lies in the
// triangle points[i].on.triangle.
struct LinearSilhouettes {
  Ragged<EdgePoint> chains;
  std::vector<std::uint8_t> closed;
  std::vector<std::uint8_t> left_out;  // chains that need not be drawn (unseen.h); empty: none
  std::vector<int> triangles;          // that carry a segment, ascending
  std::int64_t triangles_visited = 0;

  bool is_left_out(std::size_t chain) const { return !left_out.empty() && left_out[chain] != 0; }
};

// What a view looked at to find the triangles that carry a segment.
struct SilhouetteSearch {
  std::vector<int> triangles;            // ascending
  std::vector<std::array<double, 3>> g;  // at their corners, each on its vertex's own sheet
  std::vector<std::uint8_t> fronts;      // bit k: corner k is front, on the triangle's sheet
  std::int64_t visited = 0;              // triangles whose corners were looked at
};

// `dual`: of the same surface; time in proportion to what is found. Null: all triangles of smooth
// objects are scanned, and the same ones found.
SilhouetteSearch find_silhouette_triangles(const Surface& surface,
                                           const ContourFunctions& functions,
                                           const DualSurface* dual);

// Finds the triangles likewise, and follows the chains.
LinearSilhouettes linear_silhouettes(const Surface& surface, const ContourFunctions& functions,
                                     const DualSurface* dual = nullptr);

}  // namespace illustrate
