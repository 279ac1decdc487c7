// Silhouettes drawn as the contour of the limit surface round their cusps and at their ends.
//
// The zero set of an interpolated g is the contour of no surface: most of its closed curves have no
// consistent visibility. That of the limit surface has one, and it is enough to follow it where it
// matters: round cusps, and where chains end on feature curves. Elsewhere linear points stay.
#pragma once

#include "contour/exact/exactness.h"
#include "contour/silhouettes.h"
#include "core/progress.h"
#include "surface/limit/limit_surface.h"

namespace illustrate {

// Where a segment of a chain passes over an edge of the surface; the point is not one of the chain.
struct PassedEdge {
  int chain;
  int segment;
  ChainPoint point;
};

// Chains run with the front on their left. Segment i of a chain lies in the triangle
// points[i].on.triangle, and behind each edge that it passes in the triangle of that point.
struct Silhouettes {
  Ragged<ChainPoint> chains;
  std::vector<std::uint8_t> closed;
  std::vector<PassedEdge> passed;  // by chain, segment and way
  std::int64_t cusps = 0;
};

// The linear chains, but: points near cusps and ends lie on the limit surface; linear cusps give
// way to exact ones; points are added within triangles (edge none) where the curve turns, and taken
// away nearer to a cusp than the image can show. Pairs of cusps less than a quarter pixel apart
// that undo each other's turn (a swallowtail) become one plain point. With
// Exactness::everywhere all points become exact. Adds "evaluations", "swallowtails",
// "troubled_triangles" to `counts`. Throws Cancelled through `progress`. threads (0: all cores)
// take chains in turn.
Silhouettes exact_silhouettes(const Surface& surface, const LimitSurface& limit,
                              const ContourFunctions& functions, const Camera& camera,
                              const LinearSilhouettes& linear, Exactness exactness, Counts& counts,
                              const Progress& progress = {}, int threads = 1);

}  // namespace illustrate
