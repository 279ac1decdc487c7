// The ways that chains and self-intersection curves take over the triangles of the surface.
//
// Both run from triangle to triangle over the same place of their edge, never over a vertex, and
// within a triangle they keep off its edges, chains a little farther than intersection curves. So a
// closed chain crosses a closed intersection curve of its own sheet as often as it must, also where
// a mesh passes through itself exactly along its edges.
#pragma once

#include <unordered_map>
#include <vector>

#include "contour/exact/exact_silhouettes.h"
#include "contour/intersection/intersections.h"

namespace illustrate {

// A piece of a curve's segment in one triangle: from `start` to `end`, barycentric weights of
// corners 1 and 2, which are shares `from` to `to` of the segment.
struct CurvePiece {
  int curve;
  int segment;
  Vec2 start, end;
  double from, to;
};
using PiecesByTriangle = std::unordered_map<int, std::vector<CurvePiece>>;

// All pieces of all chains, those of a chain without a gap between them.
PiecesByTriangle pieces_of_chains(const Surface& surface, const Silhouettes& silhouettes);

// Where a segment of an intersection curve starts and ends on one of its two triangles: barycentric
// weights as above.
std::array<Vec2, 2> ends_on_sheet(const Surface& surface, const IntersectionCurves& intersections,
                                  int curve, int segment, int sheet);

}  // namespace illustrate
