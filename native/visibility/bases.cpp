#include "visibility/bases.h"

#include <algorithm>
#include <cmath>

namespace illustrate {
namespace {

constexpr double contradiction_px = 40;  // a layer missing behind a crossing
constexpr double lens_factor = 40;   // of the length of a lens that is dropped with two of them, px
constexpr double broken_px = 10;     // with a path that has breaks: its labels follow rays alone
constexpr double impossible = 1e12;  // the price of a negative label
constexpr int highest_move = 3;      // above the highest base that a ray speaks for
constexpr double cut_px = 120;       // what a path costs that is cut where its labels are negative

// What the paths say at a crossing; `back` is the smaller of the labels before and behind it.
struct CrossingLabels {
  std::size_t front_path = 0, back_path = 0;
  int front = 0, back = 0;

  std::size_t other_path(std::size_t path) const {
    return front_path == path ? back_path : front_path;
  }
};

std::vector<CrossingLabels> labels_at_crossings(const Arrangement& arrangement,
                                                const std::vector<LabelledPath>& paths) {
  std::vector<CrossingLabels> result(arrangement.crossings.size());
  for (std::size_t p = 0; p < paths.size(); ++p) {
    for (std::size_t i = 0; i < paths[p].labels.arcs.size(); ++i) {
      const PathArc& arc = paths[p].labels.arcs[i];
      if (arc.begin == none) continue;
      const Visit& visit = arrangement.visits[idx(arc.strand)][idx(arc.begin)];
      CrossingLabels& labels = result[idx(visit.crossing)];
      const int label = paths[p].at_start[i];
      if (visit.front) {
        labels.front_path = p;
        labels.front = label;
      } else {
        const int change = back_change(arrangement, arrangement.crossings[idx(visit.crossing)]);
        labels.back_path = p;
        labels.back = std::min(label, label - change);
      }
    }
  }
  return result;
}

// Moves bases to where the rays and the crossings with other paths mind it least, the one that
// gains most first: a path that rays say little of yields to one that they are sure of. Every move
// makes the sum of all that is minded smaller, so it ends.
class BaseSettler {
 public:
  BaseSettler(const Arrangement& arrangement, std::vector<LabelledPath>& paths)
      : arrangement_(arrangement),
        paths_(paths),
        labels_(labels_at_crossings(arrangement, paths)),
        prices_(labels_.size(), contradiction_px),
        crossings_of_(paths.size()),
        moved_(paths.size(), 0) {
    for (const LabelledPath& path : paths) {
      for (const PathArc& arc : path.labels.arcs) cheapen_lens(arc);
    }
    for (std::size_t c = 0; c < labels_.size(); ++c) {
      const CrossingLabels& labels = labels_[c];
      if (!arrangement.is_live(static_cast<int>(c)) || labels.front_path == labels.back_path)
        continue;
      crossings_of_[labels.front_path].push_back(c);
      crossings_of_[labels.back_path].push_back(c);
    }
  }

  // Returns the crossings that contradict the labels even so.
  std::vector<int> run() {
    std::vector<Move> moves;
    for (std::size_t p = 0; p < paths_.size(); ++p) moves.push_back(best_move(p));
    const auto gains_less = [](const Move& a, const Move& b) { return a.gain < b.gain; };
    for (std::size_t count = 0; count < most_moves * moves.size(); ++count) {
      const auto best = std::max_element(moves.begin(), moves.end(), gains_less);
      if (!(best->gain > least_gain)) break;
      const auto p = static_cast<std::size_t>(best - moves.begin());
      moved_[p] += best->base - paths_[p].base;
      paths_[p].move_base(best->base - paths_[p].base);
      moves[p] = best_move(p);
      for (const std::size_t neighbour : neighbours_of(p)) moves[neighbour] = best_move(neighbour);
    }
    return contradictions();
  }

 private:
  static constexpr std::size_t most_moves = 20;  // of a path, on average
  static constexpr double least_gain = 1e-9;

  struct Move {
    int base;
    double gain;  // px
  };

  // An arc between two crossings of the same strands.
  void cheapen_lens(const PathArc& arc) {
    if (arc.begin == none || arc.end == none) return;
    const std::vector<Visit>& visits = arrangement_.visits[idx(arc.strand)];
    const int a = visits[idx(arc.begin)].crossing, b = visits[idx(arc.end)].crossing;
    const Crossing &x = arrangement_.crossings[idx(a)], &y = arrangement_.crossings[idx(b)];
    if (x.front.strand != y.front.strand || x.back.strand != y.back.strand) return;
    for (const int c : {a, b}) {
      prices_[idx(c)] = std::min(prices_[idx(c)], lens_factor * arc.length_px);
    }
  }

  Move best_move(std::size_t p) const {
    const LabelledPath& path = paths_[p];
    Move best{path.base, 0};
    if (!path.is_balanced() || crossings_of_[p].empty()) return best;
    const double now = price(p, path.base);
    if (now == 0) return best;
    for (int base = 0; base < static_cast<int>(path.costs.size()); ++base) {
      const double gain = now - price(p, base);
      if (gain > best.gain) best = {base, gain};
    }
    return best;
  }

  std::vector<std::size_t> neighbours_of(std::size_t p) const {
    std::vector<std::size_t> result;
    for (const std::size_t c : crossings_of_[p]) result.push_back(labels_[c].other_path(p));
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  double price(std::size_t p, int base) const {
    const LabelledPath& path = paths_[p];
    double sum = path.costs[idx(base)];
    for (const std::size_t c : crossings_of_[p]) {
      const CrossingLabels& labels = labels_[c];
      const int by = base - path.base;
      const int missing = missing_layers(labels) + (labels.front_path == p ? by : -by);
      const bool is_sure = paths_[labels.other_path(p)].is_balanced();
      sum += (is_sure ? prices_[c] : std::min(prices_[c], broken_px)) * std::max(missing, 0);
    }
    return sum;
  }

  // Of the back strand's, as its path and the front strand's have moved; none where not positive.
  int missing_layers(const CrossingLabels& labels) const {
    return labels.front + moved_[labels.front_path] - labels.back - moved_[labels.back_path];
  }

  std::vector<int> contradictions() const {
    std::vector<int> result;
    for (std::size_t c = 0; c < labels_.size(); ++c) {
      const int crossing = static_cast<int>(c);
      if (arrangement_.is_live(crossing) && missing_layers(labels_[c]) > 0)
        result.push_back(crossing);
    }
    return result;
  }

  const Arrangement& arrangement_;
  std::vector<LabelledPath>& paths_;
  std::vector<CrossingLabels> labels_;  // before any move
  std::vector<double> prices_;          // (crossings) of a layer missing there, px
  std::vector<std::vector<std::size_t>> crossings_of_;
  std::vector<int> moved_;  // (paths)
};

double contradiction(const std::vector<PathArc>& arcs, const std::vector<Evidence>& evidence,
                     int base) {
  double sum = 0;
  for (std::size_t i = 0; i < arcs.size(); ++i) sum += evidence[i].against(base + arcs[i].offset);
  return sum;
}

// The base below `lowest` that contradicts the rays least and less than `limit`; `lowest` if none
// does.
int base_below(const std::vector<PathArc>& arcs, const std::vector<Evidence>& evidence, int lowest,
               double limit) {
  int least = lowest, result = lowest;
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    least = std::min(least, evidence[i].layers - arcs[i].offset);
  }
  for (int base = lowest - 1; base >= least; --base) {
    const double cost = contradiction(arcs, evidence, base);
    if (!(cost < limit)) continue;
    limit = cost;
    result = base;
  }
  return result;
}

void set_labels(int base, LabelledPath& path) {
  path.base = base;
  for (const PathArc& arc : path.labels.arcs) path.along.push_back(std::max(base + arc.offset, 0));
  path.at_start = path.at_end = path.along;
}

// Where labels are 0 instead of negative those next to them jump: a crossing or a cusp that nobody
// would see has the wrong change.
void break_beside_negatives(bool cyclic, LabelledPath& path) {
  const std::size_t count = path.along.size();
  for (std::size_t i = 0; i < (cyclic ? count : count - 1); ++i) {
    const std::size_t next = (i + 1) % count;
    const int change = path.labels.change_behind(i);
    if (path.along[next] == path.along[i] + change) continue;
    if (change > 0) {
      path.at_start[next] = path.along[i] + change;
    } else {
      path.at_end[i] = path.along[next] - change;
    }
  }
}

}  // namespace

void LabelledPath::move_base(int by) {
  base += by;
  for (std::vector<int>* values : {&at_start, &along, &at_end}) {
    for (int& label : *values) label += by;
  }
}

bool choose_base(const std::vector<Evidence>& evidence, bool cyclic, LabelledPath& path) {
  const std::vector<PathArc>& arcs = path.labels.arcs;
  int lowest = 0, most = 0;
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    lowest = std::min(lowest, arcs[i].offset);
    most = std::max(most, evidence[i].layers + evidence[i].unsure - arcs[i].offset);
  }
  path.costs.assign(idx(std::max(-lowest, most) + highest_move + 1), impossible);
  for (std::size_t base = idx(-lowest); base < path.costs.size(); ++base) {
    path.costs[base] = contradiction(arcs, evidence, static_cast<int>(base));
  }
  const auto best = std::min_element(path.costs.begin(), path.costs.end());
  if (!(*best < outline_weight)) {
    path.costs.clear();
    return false;
  }
  const int below = base_below(arcs, evidence, -lowest, *best - cut_px);
  const bool is_cut = below < -lowest;
  set_labels(is_cut ? below : static_cast<int>(best - path.costs.begin()), path);
  if (is_cut) {
    path.costs.clear();
    break_beside_negatives(cyclic, path);
  }
  return true;
}

std::vector<int> settle_bases(const Arrangement& arrangement, std::vector<LabelledPath>& paths) {
  return BaseSettler(arrangement, paths).run();
}

}  // namespace illustrate
