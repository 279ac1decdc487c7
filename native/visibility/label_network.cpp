#include "visibility/label_network.h"

#include <algorithm>

#include "visibility/arrangement/touch_images.h"
#include "visibility/build_graph.h"
#include "visibility/evidence/outline.h"
#include "visibility/labels/label_pile.h"
#include "visibility/labels/repairs.h"
#include "visibility/labels/swallowtails.h"
#include "visibility/labels/view_labels.h"

namespace illustrate {
namespace {

std::int64_t count_unbalanced(const Arrangement& arrangement) {
  return std::count_if(arrangement.paths().begin(), arrangement.paths().end(),
                       [&](const Path& path) { return imbalance(arrangement, path) != 0; });
}

// Crossings beyond which the problem takes minutes: machines of a hundred parts have half as many,
// a pile of needles has more.
constexpr std::size_t most_settled = 200'000;

// Labels that no rule contradicts, but for what had to give way: a repair each.
std::vector<LabelledPath> label_paths(Arrangement& arrangement, LayerRays& rays,
                                      std::int64_t& repairs, int threads,
                                      const Progress& progress) {
  std::vector<std::vector<PathArc>> arcs = arcs_of_paths(arrangement);
  auto evidence = gather_evidence(arrangement, arcs, rays, threads, progress.part(0, 0.6));
  ViewProblem view = state_labels(arrangement, arcs, evidence);
  std::vector<int> labels = least_labels(view.problem, view.start, progress.part(0.6, 0.8));
  const std::vector<int> doubtful = contradicted_paths(arrangement, arcs, view, labels);
  if (!doubtful.empty()) {
    ask_all_arcs(doubtful, arrangement, arcs, rays, threads, progress.part(0.8, 0.9), evidence);
    view = state_labels(arrangement, arcs, evidence);
    labels = least_labels(view.problem, std::move(labels), progress.part(0.9, 1));
  }
  return settle_labels(arrangement, std::move(arcs), view, labels, repairs);
}

}  // namespace

LabelledGraph label_network(const CurveNetwork& network, const Surface& surface, const Bvh& bvh,
                            const Camera& camera, Counts& counts, const Progress& progress,
                            int threads, const Insets& insets) {
  std::optional<Arrangement> settled;
  if (!network.is_incomplete) {
    settled = arrange(network, camera, most_settled, inset_points(network, surface, insets.moves),
                      near_cuts(surface, bvh, camera));
  }
  counts["sampled_views"] += !settled;
  if (!settled) return label_pile(network, surface, camera, threads);
  Arrangement& arrangement = *settled;
  progress.report(0.3);
  double moved_px = 0;
  // In this order. A touch is a crossing that is none for certain, whatever else is near; twists
  // and lenses are told by what balances their paths, which touches would spoil; swallowtails are
  // looked for only where a path does still not balance.
  const int touches = drop_touches(arrangement, moved_px);
  counts["dropped_touches"] += touches;
  const std::vector<int> touching = dropped_crossings(arrangement);
  int repairs = drop_twists_and_lenses(arrangement, moved_px);
  counts["repaired_twists"] += repairs;
  const std::int64_t unbalanced = count_unbalanced(arrangement);
  const int swallowtails = collapse_swallowtails(arrangement, moved_px);
  repairs += swallowtails;
  counts["repaired_swallowtails"] += swallowtails;
  LayerRays rays(surface, bvh, camera, insets);
  std::int64_t label_repairs = 0;
  const std::vector<LabelledPath> labels =
      label_paths(arrangement, rays, label_repairs, threads, progress.part(0.3, 1));
  pull_touches_together(arrangement, touching);
  LabelledGraph graph = build_graph(arrangement, labels, surface);
  graph.repair_max_px = moved_px;
  counts["crossings"] += arrangement.live_crossings();
  counts["rays"] += rays.rays();
  counts["loops"] += arrangement.loops();
  counts["unbalanced_loops"] += unbalanced;
  counts["repaired_labels"] += label_repairs;
  counts["repairs"] += repairs + label_repairs;
  return graph;
}

}  // namespace illustrate
