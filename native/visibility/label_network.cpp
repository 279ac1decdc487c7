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

// Crossings beyond which the problem takes over half a minute and 2.5 GB: machines of a hundred
// parts have a tenth of it, a temple district seen whole has half, a pile of needles has more.
constexpr std::size_t most_settled = 1'000'000;

// Labels that no rule contradicts, but for what had to give way: a repair each.
std::vector<LabelledPath> label_paths(Arrangement& arrangement, LayerRays& rays,
                                      std::int64_t& repairs, int threads,
                                      const Progress& progress) {
  const std::vector<std::vector<PathArc>> arcs = arcs_of_paths(arrangement);
  auto evidence = gather_evidence(arrangement, arcs, rays, threads, progress.part(0, 0.6));
  ViewProblem view = state_labels(arrangement, arcs, evidence);
  std::vector<int> labels = least_labels(view.problem, view.start, progress.part(0.6, 0.8));
  const std::vector<int> doubtful = contradicted_paths(arrangement, arcs, view, labels);
  if (!doubtful.empty()) {
    ask_all_arcs(doubtful, arrangement, arcs, rays, threads, progress.part(0.8, 0.9), evidence);
    view = state_labels(arrangement, arcs, evidence);
    labels = least_labels(view.problem, std::move(labels), progress.part(0.9, 1));
  }
  return settle_labels(arrangement, arcs, view, labels, repairs);
}

struct CrossingRepairs {
  std::vector<int> touches;  // crossings that were dropped
  std::int64_t count = 0;    // of the others
  double moved_px = 0;
};

// In this order. A touch is a crossing that is none for certain, whatever else is near; twists and
// lenses are told by what balances their paths, which touches would spoil; swallowtails are looked
// for only where a path does still not balance.
CrossingRepairs repair_crossings(Arrangement& arrangement, Counts& counts) {
  CrossingRepairs repairs;
  counts["dropped_touches"] += drop_touches(arrangement, repairs.moved_px);
  repairs.touches = dropped_crossings(arrangement);
  const int twists = drop_twists_and_lenses(arrangement, repairs.moved_px);
  counts["repaired_twists"] += twists;
  counts["unbalanced_loops"] += count_unbalanced(arrangement);
  const int swallowtails = collapse_swallowtails(arrangement, repairs.moved_px);
  counts["repaired_swallowtails"] += swallowtails;
  repairs.count = twists + swallowtails;
  return repairs;
}

LabelledGraph label_arrangement(Arrangement& arrangement, const Surface& surface, LayerRays& rays,
                                Counts& counts, int threads, const Progress& progress) {
  const CrossingRepairs repairs = repair_crossings(arrangement, counts);
  std::int64_t label_repairs = 0;
  const std::vector<LabelledPath> labels =
      label_paths(arrangement, rays, label_repairs, threads, progress);
  pull_touches_together(arrangement, repairs.touches);
  LabelledGraph graph = build_graph(arrangement, labels, surface);
  graph.repair_max_px = repairs.moved_px;
  counts["crossings"] += arrangement.live_crossings();
  counts["rays"] += rays.rays();
  counts["loops"] += arrangement.loops();
  counts["repaired_labels"] += label_repairs;
  counts["repairs"] += repairs.count + label_repairs;
  return graph;
}

}  // namespace

LabelledGraph label_network(const CurveNetwork& network, const Surface& surface, const Bvh& bvh,
                            const Camera& camera, Counts& counts, const Progress& progress,
                            int threads, const Insets& insets) {
  std::optional<Arrangement> arrangement;
  if (!network.is_incomplete) {
    arrangement =
        arrange(network, camera, most_settled, inset_points(network, surface, insets.moves),
                near_cuts(surface, bvh, camera));
  }
  counts["sampled_views"] += !arrangement;
  if (!arrangement) return label_pile(network, surface, camera, threads);
  progress.report(0.3);
  LayerRays rays(surface, bvh, camera, insets);
  return label_arrangement(*arrangement, surface, rays, counts, threads, progress.part(0.3, 1));
}

}  // namespace illustrate
