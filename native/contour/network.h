// Stage `contour`: all curves of a view cut at the points where they meet on the surface (paper
// section 4).
//
// Silhouettes are cut at cusps and where they run into feature curves or through
// self-intersections; feature edges where either of their sides turns from front to back. Objects
// of scheme none give mesh edges between a front and a back face; their strands end at every
// vertex, since anything may change there. Strands are clipped at the near plane.
#pragma once

#include "contour/curve_network.h"
#include "contour/dual_surface.h"
#include "contour/feature_edges.h"
#include "contour/intersections.h"
#include "core/progress.h"
#include "core/report.h"
#include "surface/limit_surface.h"
#include "view/camera.h"

namespace illustrate {

struct NetworkOptions {
  bool marks = false;          // user-marked edges become curves
  bool materials = false;      // borders between materials
  bool flat_outlines = false;  // outlines of flat areas
};

// `limit` is the limit surface of `surface`, `dual` of the same; null: all of it is scanned, with
// the same result. Adds "triangles_visited", "silhouette_triangles" (of smooth objects),
// "edges_visited", "silhouette_edges" (of polygon objects), "cusps", "swallowtails",
// "troubled_triangles", "evaluations", "strands" to `counts`.
CurveNetwork build_network(const Surface& surface, const LimitSurface& limit,
                           const std::vector<FeatureEdge>& features,
                           const IntersectionCurves& intersections, const Camera& camera,
                           const NetworkOptions& options, Counts& counts,
                           const Progress& progress = {}, const DualSurface* dual = nullptr);

}  // namespace illustrate
