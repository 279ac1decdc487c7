#include "visibility/label_network.h"

#include <algorithm>

#include "visibility/build_graph.h"
#include "visibility/labels.h"
#include "visibility/repairs.h"

namespace illustrate {
namespace {

std::int64_t count_unbalanced(const Arrangement& arrangement) {
  return std::count_if(arrangement.paths.begin(), arrangement.paths.end(), [&](const Path& path) {
    return path.cyclic && relative_labels(arrangement, path).residual != 0;
  });
}

std::int64_t count_breaks(const std::vector<LabelledPath>& labels) {
  std::int64_t count = 0;
  for (const LabelledPath& path : labels) {
    for (std::size_t i = 0; i < path.labels.arcs.size(); ++i) count += path.breaks(i);
  }
  return count;
}

// The last resort: the label jumps at a joint, and the front strand runs on.
int demote(Arrangement& arrangement, const std::vector<int>& crossings) {
  for (const int c : crossings) arrangement.states[idx(c)] = CrossingState::demoted;
  arrangement.sort_visits();
  return static_cast<int>(crossings.size());
}

// Repairs until no crossing contradicts its labels. Ends, since every round takes at least one
// crossing away.
std::vector<LabelledPath> label_without_contradiction(Arrangement& arrangement, LayerRays& rays,
                                                      int& repairs, double& moved_px,
                                                      const Progress& progress) {
  std::vector<LabelledPath> labels = label_paths(arrangement, rays, progress);
  for (;;) {
    const std::vector<int> wrong = contradictions(arrangement, labels);
    if (wrong.empty()) return labels;
    const std::vector<CrossingState> before = arrangement.states;
    int repaired = drop_lenses(arrangement, wrong, moved_px);
    if (repaired == 0) repaired = demote(arrangement, wrong);
    repairs += repaired;
    progress.report(1);
    relabel_paths(arrangement, before, rays, labels);
  }
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
  const std::vector<LabelledPath> labels =
      label_without_contradiction(arrangement, rays, repairs, moved_px, progress.part(0.3, 1));
  LabelledGraph graph = build_graph(arrangement, labels, surface);
  graph.repair_max_px = moved_px;
  counts["crossings"] +=
      std::count(arrangement.states.begin(), arrangement.states.end(), CrossingState::live);
  counts["rays"] += rays.rays();
  counts["loops"] += std::count_if(arrangement.paths.begin(), arrangement.paths.end(),
                                   [](const Path& path) { return path.cyclic; });
  counts["unbalanced_loops"] += unbalanced;
  counts["repairs"] += repairs + count_breaks(labels);
  return graph;
}

}  // namespace illustrate
