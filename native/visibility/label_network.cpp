#include "visibility/label_network.h"

#include <algorithm>

#include "visibility/build_graph.h"
#include "visibility/labels.h"
#include "visibility/repairs.h"

namespace illustrate {
namespace {

constexpr int most_rounds = 4;

std::int64_t count_unbalanced(const Arrangement& arrangement) {
  return std::count_if(arrangement.paths.begin(), arrangement.paths.end(), [&](const Path& path) {
    return path.cyclic && relative_labels(arrangement, path).residual != 0;
  });
}

std::int64_t count_breaks(const std::vector<LabelledPath>& labels) {
  std::int64_t count = 0;
  for (const LabelledPath& path : labels) {
    for (std::size_t i = 0; i < path.labels.arcs.size(); ++i) count += path.is_broken(i);
  }
  return count;
}

}  // namespace

LabelledGraph label_network(const CurveNetwork& network, const Surface& surface, const Bvh& bvh,
                            const Camera& camera, Counts& counts, const Progress& progress) {
  Arrangement arrangement = arrange(network, camera);
  progress.report(0.3);
  double moved_px = 0;
  int repairs = drop_twists_and_lenses(arrangement, moved_px);
  const std::int64_t unbalanced = count_unbalanced(arrangement);
  repairs += collapse_swallowtails(arrangement, moved_px);
  LayerRays rays(surface, bvh, camera);
  std::vector<LabelledPath> labels;
  for (int round = 0;; ++round) {
    labels = label_paths(arrangement, rays, progress.part(0.3, 1));
    if (round == most_rounds) break;
    const int dropped = drop_lenses(arrangement, contradictions(arrangement, labels), moved_px);
    if (dropped == 0) break;
    repairs += dropped;
  }
  LabelledGraph graph = build_graph(arrangement, labels, surface);
  graph.repair_max_px = moved_px;
  counts["crossings"] += std::count(arrangement.dropped.begin(), arrangement.dropped.end(), 0);
  counts["rays"] += rays.rays();
  counts["loops"] += std::count_if(arrangement.paths.begin(), arrangement.paths.end(),
                                   [](const Path& path) { return path.cyclic; });
  counts["unbalanced_loops"] += unbalanced;
  counts["repairs"] += repairs + count_breaks(labels);
  return graph;
}

}  // namespace illustrate
