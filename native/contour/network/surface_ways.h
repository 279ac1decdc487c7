// The ways that chains and self-intersection curves take over the triangles of the surface.
//
// Both run from triangle to triangle over the same place of their edge, never over a vertex, and
// within a triangle they keep off its edges, chains a little farther than intersection curves. So a
// closed chain crosses a closed intersection curve of its own sheet as often as it must, also where
// a mesh passes through itself exactly along its edges.
#pragma once

#include <vector>

#include "contour/exact/exact_silhouettes.h"
#include "contour/intersection/intersections.h"
#include "core/index_map.h"

namespace illustrate {

// A piece of a curve's segment in one triangle: from `start` to `end`, barycentric weights of
// corners 1 and 2, which are shares `from` to `to` of the segment.
struct CurvePiece {
  int curve;
  int segment;
  Vec2 start, end;
  double from, to;
};

// Of some triangles of a surface, which are all that other curves pass.
class PiecesByTriangle {
 public:
  PiecesByTriangle() = default;
  // Triangles may be named more than once, or be none.
  explicit PiecesByTriangle(const std::vector<int>& triangles);

  bool holds(int triangle) const { return lists_[triangle] != none; }
  // Forgotten where the triangle is not held.
  void add(int triangle, const CurvePiece& piece);
  // None where it is not held.
  Span<const CurvePiece> operator[](int triangle) const;

 private:
  IndexMap lists_;  // of each triangle the number of its list
  std::vector<std::vector<CurvePiece>> pieces_;
};

// The pieces of all chains in these triangles. In all triangles of the surface those of a chain
// follow each other without a gap.
PiecesByTriangle pieces_of_chains(const Surface& surface, const Silhouettes& silhouettes,
                                  const std::vector<int>& triangles);

// Where a segment of an intersection curve starts and ends on one of its two triangles: barycentric
// weights as above.
std::array<Vec2, 2> ends_on_sheet(const Surface& surface, const IntersectionCurves& intersections,
                                  int curve, int segment, int sheet);

}  // namespace illustrate
