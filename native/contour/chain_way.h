// The way that a segment of a chain takes over the triangles of the surface.
#pragma once

#include <unordered_map>
#include <vector>

#include "contour/exact_silhouettes.h"

namespace illustrate {

// A piece of a segment in one triangle: from `start` to `end`, barycentric weights of corners 1 and
// 2, which are shares `from` to `to` of the segment.
struct ChainPiece {
  int triangle;
  Vec2 start, end;
  double from, to;
};

// The pieces of the segment from one point of a chain to the next, without a gap on the
// triangulated surface, so that a closed chain crosses any other closed curve of it as often as it
// must. Most segments lie in one triangle. Beside cusps, where points were left out, a segment
// leads past several: through those that a plane across the surface meets between its two points.
// Where that leads nowhere the segment is seen in the plane of its first triangle.
std::vector<ChainPiece> chain_pieces(const Surface& surface, const ChainPoint& from,
                                     const ChainPoint& to);

// A piece of a segment of one of many curves.
struct CurvePiece : ChainPiece {
  int curve;
  int segment;
};
using PiecesByTriangle = std::unordered_map<int, std::vector<CurvePiece>>;

PiecesByTriangle pieces_by_triangle(const Surface& surface, const Silhouettes& silhouettes);

}  // namespace illustrate
