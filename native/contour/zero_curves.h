// Curves from the segments that the zero set of a function has on single triangles, cut off where
// they are weak.
#pragma once

#include "core/ragged.h"
#include "surface/surface.h"

namespace illustrate {

// A point of a segment: on edge `edge` of `on.triangle`, at `fraction` from that edge's first
// corner, or, with edge none, inside the triangle.
struct ZeroPoint {
  Vec3 position;
  SurfacePoint on;
  int edge = none;
  double fraction = 0;
  double strength = 0;
  bool ridge = false;   // the surface bulges towards the viewer here
  bool unseen = false;  // on a back that cannot be seen
};

// At most two segments of one call meet on an edge.
using ZeroSegment = std::array<ZeroPoint, 2>;

// Segment i of a curve lies in the triangle curve[i].on.triangle.
struct ZeroCurves {
  Ragged<ZeroPoint> curves;
  std::vector<std::uint8_t> closed;  // closed ones do not repeat their first point
};

// Lines that neither hide nor bound anything and may end anywhere: of curvature
// (curvature_curves.h), of light (tone/light_contours.h).
struct FreeLines {
  ZeroCurves lines;
  std::vector<Kind> kinds;  // (lines) ridge: of ridges and valleys, as its points say

  void add(Span<const ZeroPoint> line, bool closed, Kind kind) {
    lines.curves.add(line);
    lines.closed.push_back(closed);
    kinds.push_back(kind);
  }
};

struct ZeroLimits {
  double weak;                   // what has less strength is cut off
  double strong;                 // curves that nowhere reach it are left out (hysteresis)
  std::vector<double> shortest;  // (objects) length of a curve, world units
};

// Segments linked where they meet on edges inside one smooth side.
ZeroCurves link_segments(const Surface& surface, const std::vector<ZeroSegment>& segments,
                         const ZeroLimits& limits);

// The point at `fraction` of the edge from its corner with the lower vertex; the same bits from
// both triangles of the edge.
ZeroPoint point_on_edge(const Surface& surface, int triangle, int corner, double fraction);

// The point between two points of one triangle.
ZeroPoint between(const ZeroPoint& a, const ZeroPoint& b, double fraction);

}  // namespace illustrate
