#include "contour/network/network.h"

#include <algorithm>
#include <optional>

#include "contour/exact/exact_silhouettes.h"
#include "contour/network/feature_strands.h"
#include "contour/network/joints.h"
#include "contour/network/near_clip.h"
#include "contour/network/polyline_strands.h"
#include "contour/network/unseen.h"
#include "contour/polygon_silhouettes.h"

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

// Triangles, edges and points that carry curves: views of fewer take less time than it would take
// to tell what is seen of them.
constexpr std::size_t crowd = 30'000;

std::optional<Unseen> tell_unseen(const ContourScene& scene, const Camera& camera,
                                  const NetworkOptions& options, std::size_t carriers) {
  if (!options.only_seen || carriers < crowd) return {};
  return Unseen(scene.surface, camera, Unseen::Evidence::certain, options.threads);
}

void append(FreeLines& lines, const FreeLines& more) {
  for (std::size_t i = 0; i < more.kinds.size(); ++i) {
    lines.add(more.lines.curves[i], more.lines.closed[i] != 0, more.kinds[i]);
  }
}

}  // namespace

CurveNetwork build_network(const ContourScene& scene, const Camera& camera,
                           const NetworkOptions& options, Counts& counts,
                           const Progress& progress) {
  const Surface& surface = scene.surface;
  const std::vector<FeatureEdge> features = wanted_features(scene.features, options);
  const ContourFunctions functions(surface, camera);
  LinearSilhouettes linear = linear_silhouettes(surface, functions, scene.dual);
  const std::optional<Unseen> unseen = tell_unseen(
      scene, camera, options,
      linear.triangles.size() + features.size() + scene.intersections.curves.values.size());
  if (unseen) {
    counts["unseen_chains"] += leave_out_unseen_chains(*unseen, linear);
    mark_unseen_segments(*unseen, linear);
  }
  const Silhouettes found =
      exact_silhouettes(surface, scene.limit, functions, camera, linear, Exactness::where_needed,
                        counts, progress.part(0, 0.5), options.threads);
  const PolygonSilhouettes folds = polygon_silhouettes(surface, camera, scene.dual);
  progress.report(0.5);
  FreeLines lines = scene.light_contours ? *scene.light_contours : FreeLines{};
  if (scene.derivative) {
    append(lines, curvature_curves(surface, *scene.derivative, scene.intersections, camera,
                                   options.curvature_curves));
  }
  const Joints joints = find_joints(surface, features, found, scene.intersections, lines, camera);
  CurveNetwork network;
  network.nodes = joints.nodes;
  add_silhouette_strands(surface, found, joints, network);
  add_intersection_strands(surface, scene.intersections, joints, network);
  add_feature_strands(surface, features, folds.edges, functions, camera, joints, network);
  add_free_strands(surface, lines, options.curvature_curves, joints, network);
  CurveNetwork clipped = clip_near(surface, network, camera);
  if (unseen) clipped = cut_at_unseen(*unseen, clipped);
  clipped.is_incomplete = !scene.intersections.left_out.empty();
  counts["triangles_visited"] += linear.triangles_visited;
  counts["silhouette_triangles"] += static_cast<std::int64_t>(linear.triangles.size());
  counts["edges_visited"] += folds.edges_visited;
  counts["silhouette_edges"] += static_cast<std::int64_t>(folds.edges.size());
  counts["cusps"] += found.cusps;
  counts["strands"] += static_cast<std::int64_t>(clipped.strands.size());
  counts["unseen_strands"] +=
      std::count_if(clipped.strands.begin(), clipped.strands.end(),
                    [](const Strand& s) { return !takes_part_in_crossings(s.sight); });
  progress.report(1);
  return clipped;
}

}  // namespace illustrate
