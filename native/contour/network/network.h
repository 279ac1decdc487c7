// Stage `contour`: all curves of a view cut at the points where they meet on the surface (paper
// section 4).
//
// Silhouettes are cut at cusps and where they run into feature curves or through
// self-intersections; feature edges where either of their sides turns from front to back. Objects
// of scheme none give mesh edges between a front and a back face; their strands end at every
// vertex, since anything may change there. Strands are clipped at the near plane.
#pragma once

#include "contour/dual/dual_surface.h"
#include "contour/intersection/intersections.h"
#include "contour/network/curve_network.h"
#include "contour/shape/curvature_curves.h"
#include "contour/shape/feature_edges.h"
#include "core/progress.h"
#include "core/report.h"
#include "surface/limit/limit_surface.h"
#include "view/camera.h"

namespace illustrate {

struct NetworkOptions {
  bool marks = false;          // user-marked edges become curves
  bool materials = false;      // borders between materials
  bool flat_outlines = false;  // outlines of flat areas
  CurvatureCurveOptions curvature_curves;
  // Views of many curves are worked out as far as they are seen (unseen.h): contours that are not
  // are left out, other curves cut. Not for drawings of hidden lines.
  bool only_seen = false;
  int threads = 0;  // 0: all cores
};

// What curves are drawn of. The limit surface is that of `surface`.
struct ContourScene {
  const Surface& surface;
  const LimitSurface& limit;
  const std::vector<FeatureEdge>& features;
  const IntersectionCurves& intersections;
  const DualSurface* dual = nullptr;  // null: every triangle is scanned, with the same result
  const CurvatureDerivative* derivative = nullptr;  // null: without curvature curves
  const FreeLines* light_contours = nullptr;        // tone/light_contours.h, or none
};

// Adds "triangles_visited", "silhouette_triangles" (of smooth objects), "edges_visited",
// "silhouette_edges" (of polygon objects), "cusps", "swallowtails", "troubled_triangles",
// "evaluations", "strands", "unseen_chains" and "unseen_strands" to `counts`.
CurveNetwork build_network(const ContourScene& scene, const Camera& camera,
                           const NetworkOptions& options, Counts& counts,
                           const Progress& progress = {});

}  // namespace illustrate
