#include "contour/network.h"

#include "contour/exact_silhouettes.h"
#include "contour/joints.h"
#include "contour/strands.h"

namespace illustrate {
namespace {

bool is_wanted(EdgeKind kind, const NetworkOptions& options) {
  switch (kind) {
    case EdgeKind::mark:
      return options.marks;
    case EdgeKind::material:
      return options.materials;
    case EdgeKind::flat_outline:
      return options.flat_outlines;
    default:
      return true;
  }
}

std::vector<FeatureEdge> wanted_features(const std::vector<FeatureEdge>& features,
                                         const NetworkOptions& options) {
  std::vector<FeatureEdge> result;
  for (const FeatureEdge& f : features) {
    if (is_wanted(f.kind, options)) result.push_back(f);
  }
  return result;
}

}  // namespace

CurveNetwork build_network(const Surface& surface, const LimitSurface& limit,
                           const std::vector<FeatureEdge>& all_features,
                           const IntersectionCurves& intersections, const Camera& camera,
                           const NetworkOptions& options, Counts& counts, const Progress& progress,
                           const CurvatureDerivative* derivative) {
  const std::vector<FeatureEdge> features = wanted_features(all_features, options);
  const ContourFunctions functions(surface, camera);
  const Silhouettes linear = silhouettes(surface, functions, camera);
  const Silhouettes found =
      exact_silhouettes(surface, limit, functions, camera, linear, false, counts);
  progress.report(0.5);
  CurvatureCurves lines;
  if (derivative)
    lines = curvature_curves(surface, *derivative, intersections, camera, options.curvature_curves);
  const Joints joints = find_joints(surface, features, found, intersections, lines);
  CurveNetwork network;
  network.nodes = joints.nodes;
  add_silhouette_strands(surface, found, joints, network);
  add_intersection_strands(surface, intersections, joints, network);
  add_feature_strands(surface, features, functions, camera, joints, network);
  add_curvature_strands(surface, lines, options.curvature_curves, joints, network);
  CurveNetwork clipped = clip_near(surface, network, camera);
  counts["triangles_visited"] += found.triangles_visited;
  counts["silhouette_triangles"] += static_cast<std::int64_t>(found.triangles.size());
  counts["cusps"] += found.cusps;
  counts["strands"] += static_cast<std::int64_t>(clipped.strands.size());
  progress.report(1);
  return clipped;
}

}  // namespace illustrate
