// The way that chains take over the triangles of the surface.
#pragma once

#include <unordered_map>
#include <vector>

#include "contour/exact_silhouettes.h"

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

// All pieces of all chains. They follow one another without a gap on the triangulated surface, so
// that a closed chain crosses any other closed curve of it as often as it must.
PiecesByTriangle pieces_by_triangle(const Surface& surface, const Silhouettes& silhouettes);

}  // namespace illustrate
