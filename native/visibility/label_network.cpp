#include "visibility/label_network.h"

#include <algorithm>

#include "visibility/bases.h"
#include "visibility/build_graph.h"
#include "visibility/labels.h"
#include "visibility/repairs.h"
#include "visibility/touch_images.h"

namespace illustrate {
namespace {

std::int64_t count_unbalanced(const Arrangement& arrangement) {
  return std::count_if(arrangement.paths.begin(), arrangement.paths.end(),
                       [&](const Path& path) { return imbalance(arrangement, path) != 0; });
}

std::int64_t count_breaks(const std::vector<LabelledPath>& labels) {
  std::int64_t count = 0;
  for (const LabelledPath& path : labels) {
    for (std::size_t i = 0; i < path.labels.arcs.size(); ++i) count += path.breaks(i);
  }
  return count;
}

// Rounds after which balanced paths are no longer held for right. Smooth surfaces need two or
// three.
constexpr int patience = 12, most_rounds = 20;
constexpr std::size_t crowd = 50'000;  // crossings of a pile of needles: rays alone decide

// Labels all paths, and repairs until none of them has to contradict anything at a crossing or a
// cusp.
class ConsistentLabels {
 public:
  ConsistentLabels(Arrangement& arrangement, LayerRays& rays, double& moved_px)
      : arrangement_(arrangement),
        rays_(rays),
        moved_px_(moved_px),
        path_of_(arrangement.visits.size()) {
    for (std::size_t p = 0; p < arrangement.paths.size(); ++p) {
      for (const int s : arrangement.paths[p].strands) path_of_[idx(s)] = p;
    }
  }

  // Ends, since every round takes at least one crossing or cusp away.
  std::vector<LabelledPath> run(const Progress& progress) {
    labels_.resize(arrangement_.paths.size());
    changed_.assign(labels_.size(), 1);
    if (arrangement_.crossings.size() > crowd) demote_all();
    for (;; ++round_) {
      label_changed(progress);
      if (!repair_crossings() && !free_broken_places()) return std::move(labels_);
    }
  }

  std::int64_t repairs() const { return repairs_; }

 private:
  void label_changed(const Progress& progress) {
    for (std::size_t p = 0; p < labels_.size(); ++p) {
      if (changed_[p])
        labels_[p] =
            label_path(arrangement_, arrangement_.paths[p], round_ < patience, rays_, known_);
      if (p % 16 == 0)
        progress.report(static_cast<double>(p) / static_cast<double>(labels_.size()));
    }
    changed_.assign(labels_.size(), 0);
  }

  // Where other bases help, paths get them; crossings that contradict each other still go with
  // their lens, or else become joints of their back strand: the front strand runs on.
  bool repair_crossings() {
    const std::vector<int> wrong = settle_bases(arrangement_, labels_);
    if (wrong.empty()) return false;
    const std::vector<CrossingState> before = arrangement_.states;
    if (drop_lenses(arrangement_, wrong, moved_px_) == 0) {
      for (const int c : wrong) give_up(c);
    }
    note_changes(before);
    return true;
  }

  void demote_all() {
    const std::vector<CrossingState> before = arrangement_.states;
    std::replace(arrangement_.states.begin(), arrangement_.states.end(), CrossingState::live,
                 CrossingState::demoted);
    note_changes(before);
  }

  // In the end, with all that its back path passes behind.
  void give_up(int crossing) {
    arrangement_.states[idx(crossing)] = CrossingState::demoted;
    if (round_ < most_rounds) return;
    const std::size_t path = path_of_[idx(arrangement_.crossings[idx(crossing)].back.strand)];
    for (const int s : arrangement_.paths[path].strands) {
      for (const Visit& visit : arrangement_.visits[idx(s)]) {
        if (!visit.front) arrangement_.states[idx(visit.crossing)] = CrossingState::demoted;
      }
    }
  }

  // A break right behind or before a crossing or a cusp takes its place: the last resort.
  bool free_broken_places() {
    const std::int64_t repairs_before = repairs_;
    const std::vector<CrossingState> before = arrangement_.states;
    for (std::size_t p = 0; p < labels_.size(); ++p) {
      const LabelledPath& path = labels_[p];
      for (std::size_t i = 0; i < path.labels.arcs.size(); ++i) {
        const PathArc& arc = path.labels.arcs[i];
        if (path.at_start[i] != path.along[i]) free_place(p, arc, arc.begin, 0);
        if (path.along[i] != path.at_end[i]) free_place(p, arc, arc.end, 1);
      }
    }
    note_changes(before);
    return repairs_ != repairs_before;
  }

  // side 0: where the arc starts, 1: where it ends.
  void free_place(std::size_t p, const PathArc& arc, int visit_index, std::size_t side) {
    if (visit_index == none) return free_cusp(p, arc.strand, side);
    const Visit& visit = arrangement_.visits[idx(arc.strand)][idx(visit_index)];
    if (!visit.front) arrangement_.states[idx(visit.crossing)] = CrossingState::demoted;
  }

  void free_cusp(std::size_t p, int strand, std::size_t side) {
    Path& path = arrangement_.paths[p];
    const auto found = std::find(path.strands.begin(), path.strands.end(), strand);
    std::size_t step = static_cast<std::size_t>(found - path.strands.begin()) + side;
    if (path.cyclic) step %= path.strands.size();
    const bool is_cusp = step < path.jumps.size() && path.jumps[step] != 0;
    if (!is_cusp || path.freed[step] || (step == 0 && !path.cyclic)) return;
    path.freed[step] = 1;
    changed_[p] = 1;
    ++repairs_;
  }

  void note_changes(const std::vector<CrossingState>& before) {
    for (std::size_t c = 0; c < before.size(); ++c) {
      if (before[c] == arrangement_.states[c]) continue;
      changed_[path_of_[idx(arrangement_.crossings[c].front.strand)]] = 1;
      changed_[path_of_[idx(arrangement_.crossings[c].back.strand)]] = 1;
      ++repairs_;
    }
    arrangement_.forget_visits();
  }

  Arrangement& arrangement_;
  LayerRays& rays_;
  double& moved_px_;
  std::vector<std::size_t> path_of_;
  std::vector<std::uint8_t> changed_;
  std::vector<LabelledPath> labels_;
  KnownEvidence known_;
  std::int64_t repairs_ = 0;
  int round_ = 0;
};

}  // namespace

LabelledGraph label_network(const CurveNetwork& network, const Surface& surface, const Bvh& bvh,
                            const Camera& camera, Counts& counts, const Progress& progress) {
  Arrangement arrangement = arrange(network, camera);
  progress.report(0.3);
  double moved_px = 0;
  const int touches = drop_touches(arrangement, moved_px);
  counts["dropped_touches"] += touches;
  const std::vector<int> touching = dropped_crossings(arrangement);
  int repairs = drop_twists_and_lenses(arrangement, moved_px);
  counts["repaired_twists"] += repairs;
  const std::int64_t unbalanced = count_unbalanced(arrangement);
  const int swallowtails = collapse_swallowtails(arrangement, moved_px);
  repairs += swallowtails;
  counts["repaired_swallowtails"] += swallowtails;
  LayerRays rays(surface, bvh, camera);
  ConsistentLabels consistent(arrangement, rays, moved_px);
  const std::vector<LabelledPath> labels = consistent.run(progress.part(0.3, 1));
  pull_touches_together(arrangement, touching);
  LabelledGraph graph = build_graph(arrangement, labels, surface);
  graph.repair_max_px = moved_px;
  counts["crossings"] += arrangement.live_crossings();
  counts["rays"] += rays.rays();
  counts["loops"] += arrangement.loops();
  counts["unbalanced_loops"] += unbalanced;
  counts["repaired_crossings"] += consistent.repairs();
  const std::int64_t breaks = count_breaks(labels);
  counts["repaired_breaks"] += breaks;
  counts["repairs"] += repairs + consistent.repairs() + breaks;
  return graph;
}

}  // namespace illustrate
