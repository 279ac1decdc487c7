#include "visibility/labels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

namespace illustrate {
namespace {

constexpr int most_rays = 60'000;              // of a view; a dense scan needs some thousands
constexpr std::size_t most_arcs_asked = 1000;  // of one path, the longest ones
constexpr double asked_thrice_px = 30;         // longer arcs are asked at three places
constexpr double outline_weight = 1e9;      // the outside of the drawing is certain: px of length
constexpr double beside_nothing_px = 100;   // an arc next to the empty background is nearly certain
constexpr double beside_nothing_share = 3;  // of its length: a sliver may hide a short one
constexpr double hidden_break_px = 12;      // what a break costs, in px of wrong label
constexpr double visible_break_px = 30;
constexpr double balanced_factor = 1e5;  // a cycle whose changes sum to zero hardly needs a break
constexpr double cyclic_factor = 10;     // any other cycle needs one, not many
constexpr double free_change_px = 1;     // a change at a demoted crossing
constexpr int most_layers = 64;
constexpr std::size_t most_entries = 500'000;  // of a table; of larger ones only one is made
constexpr double contradiction_px = 40;        // a layer missing behind a crossing
constexpr double impossible = 1e12;            // the price of a negative label
constexpr double least_weight = 1e-6;          // an arc without length still prefers its ray

// The labels along a path as the cheapest way through (arc, layers): from one arc to the next the
// label changes as the rules say, within an arc it may jump at the price of a break.
class LeastContradiction {
 public:
  LeastContradiction(LabelledPath& path, const std::vector<Evidence>& evidence, bool cyclic,
                     double dear)
      : path_(path),
        arcs_(path.labels.arcs),
        evidence_(evidence),
        cyclic_(cyclic),
        dear_(dear),
        states_(state_count()) {}

  void solve() {
    double best = infinity;
    const bool is_large = arcs_.size() * idx(states_) > most_entries;
    const int likely = evidence_.empty() ? 0 : std::min(evidence_.front().layers, states_ - 1);
    const int first = is_large ? likely : 0, last = is_large ? likely : states_ - 1;
    for (int start = first; start <= (cyclic_ ? last : first); ++start) try_start(start, best);
    if (path_.along.empty()) {
      for (int start = 0; start < states_ && path_.along.empty(); ++start) try_start(start, best);
    }
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  int state_count() const {
    int low = 0, high = 0, most = 0;
    for (std::size_t i = 0; i < arcs_.size(); ++i) {
      low = std::min(low, arcs_[i].offset);
      high = std::max(high, arcs_[i].offset);
      most = std::max(most, evidence_[i].layers);
    }
    return std::min(most + high - low + 3, most_layers);
  }

  double wrong(std::size_t arc, int layers) const {
    return evidence_[arc].weight * std::abs(layers - evidence_[arc].layers);
  }

  // Past a possible break; `origin` remembers where each label came from. Only the cheapest hidden
  // label and 0 can be worth leaving.
  std::vector<double> past_break(const std::vector<double>& in, int* origin) const {
    const auto hidden = std::min_element(in.begin() + 1, in.end());
    const int cheapest = static_cast<int>(hidden - in.begin());
    std::vector<double> out(in);
    const auto offer = [&](int from, int to, double price) {
      if (from == to || in[idx(from)] + price >= out[idx(to)]) return;
      out[idx(to)] = in[idx(from)] + price;
      origin[to] = from;
    };
    for (int to = 0; to < states_; ++to) {
      origin[to] = to;
      offer(0, to, dear_ * visible_break_px);
      offer(cheapest, to, dear_ * (to == 0 ? visible_break_px : hidden_break_px));
    }
    return out;
  }

  // The labels at an arc's end from the costs of those at its start.
  std::vector<double> through(std::size_t arc, const std::vector<double>& in) {
    std::vector<double> along = past_break(in, &start_of_[arc * idx(states_)]);
    for (int q = 0; q < states_; ++q) along[idx(q)] += wrong(arc, q);
    return past_break(along, &along_of_[arc * idx(states_)]);
  }

  // At the start of the next arc, remembering the label at this one's end.
  std::vector<double> to_next(std::size_t arc, const std::vector<double>& out) {
    std::vector<double> in(out.size(), infinity);
    const int change = path_.labels.change_behind(arc);
    const bool is_free = arcs_[arc + 1].starts_free;
    for (int q = 0; q < states_; ++q) {
      const bool possible = q - change >= 0 && q - change < states_;
      int from = possible ? q - change : 0;
      double best = possible ? out[idx(from)] : infinity;
      for (int other = 0; is_free && other < states_; ++other) {
        if (out[idx(other)] + free_change_px >= best) continue;
        best = out[idx(other)] + free_change_px;
        from = other;
      }
      in[idx(q)] = best;
      previous_[(arc + 1) * idx(states_) + idx(q)] = from;
    }
    return in;
  }

  // Cyclic paths start with exactly `start` layers and have to come back to them.
  void try_start(int start, double& best) {
    start_of_.assign(arcs_.size() * idx(states_), 0);
    along_of_.assign(arcs_.size() * idx(states_), 0);
    previous_.assign(arcs_.size() * idx(states_), 0);
    std::vector<double> cost(idx(states_), cyclic_ ? infinity : 0);
    cost[idx(start)] = 0;
    for (std::size_t arc = 0; arc < arcs_.size(); ++arc) {
      cost = through(arc, cost);
      if (arc + 1 < arcs_.size()) cost = to_next(arc, cost);
    }
    int last = static_cast<int>(std::min_element(cost.begin(), cost.end()) - cost.begin());
    if (cyclic_ && !arcs_.front().starts_free) {
      last = start - path_.labels.change_behind(arcs_.size() - 1);
    }
    if (last < 0 || last >= states_ || !(cost[idx(last)] < best)) return;
    best = cost[idx(last)];
    trace_back(last);
  }

  void trace_back(int last) {
    path_.at_start.assign(arcs_.size(), 0);
    path_.along.assign(arcs_.size(), 0);
    path_.at_end.assign(arcs_.size(), 0);
    for (std::size_t arc = arcs_.size(); arc-- > 0;) {
      const std::size_t row = arc * idx(states_);
      path_.at_end[arc] = last;
      path_.along[arc] = along_of_[row + idx(last)];
      path_.at_start[arc] = start_of_[row + idx(path_.along[arc])];
      last = previous_[row + idx(path_.at_start[arc])];
    }
  }

  LabelledPath& path_;
  const std::vector<PathArc>& arcs_;
  const std::vector<Evidence>& evidence_;
  bool cyclic_;
  double dear_;  // factor of the price of a break
  int states_;
  std::vector<int> start_of_;  // [arc, label along it] -> label at its start
  std::vector<int> along_of_;  // [arc, label at its end] -> label along it
  std::vector<int> previous_;  // [arc, label at its start] -> label at the end of the arc before
};

class Labeller {
 public:
  Labeller(const Arrangement& arrangement, LayerRays& rays, KnownEvidence& known)
      : arrangement_(arrangement), rays_(rays), known_(known) {}

  LabelledPath label(const Path& path, bool trusts_rules) {
    LabelledPath result;
    result.labels = relative_labels(arrangement_, path);
    const bool balanced = trusts_rules && path.cyclic && result.labels.residual == 0;
    const bool has_base = balanced && !any_free(result.labels);
    std::vector<Evidence> evidence(result.labels.arcs.size(), {0, 0});
    const bool is_outer = mark_outline(result.labels.arcs, evidence);
    if (has_base && is_outer && choose_base(evidence, result)) return result;
    gather(result.labels.arcs, evidence);
    if (has_base && choose_base(evidence, result)) return result;
    const double dear = balanced ? balanced_factor : path.cyclic ? cyclic_factor : 1;
    LeastContradiction(result, evidence, path.cyclic, dear).solve();
    return result;
  }

 private:
  static bool any_free(const PathLabels& labels) {
    return std::any_of(labels.arcs.begin(), labels.arcs.end(),
                       [](const PathArc& arc) { return arc.starts_free; });
  }

  // The base that contradicts the rays least. False where the outside of the drawing has no one
  // label.
  static bool choose_base(const std::vector<Evidence>& evidence, LabelledPath& path) {
    const std::vector<PathArc>& arcs = path.labels.arcs;
    int lowest = 0, most = 0;
    for (std::size_t i = 0; i < arcs.size(); ++i) {
      lowest = std::min(lowest, arcs[i].offset);
      most = std::max(most, evidence[i].layers - arcs[i].offset);
    }
    path.costs.assign(idx(std::max(-lowest, most) + 2), impossible);
    for (std::size_t base = idx(-lowest); base < path.costs.size(); ++base) {
      path.costs[base] = 0;
      for (std::size_t i = 0; i < arcs.size(); ++i) {
        const int label = static_cast<int>(base) + arcs[i].offset;
        path.costs[base] += evidence[i].weight * std::abs(label - evidence[i].layers);
      }
    }
    const auto best = std::min_element(path.costs.begin(), path.costs.end());
    if (!(*best < outline_weight)) {
      path.costs.clear();
      return false;
    }
    for (const PathArc& arc : arcs) path.along.push_back(arc.offset);
    path.at_start = path.at_end = path.along;
    path.move_base(static_cast<int>(best - path.costs.begin()));
    return true;
  }

  // Arcs at the outside need no rays. Whether there are any.
  bool mark_outline(const std::vector<PathArc>& arcs, std::vector<Evidence>& evidence) const {
    bool any = false;
    for (std::size_t i = 0; i < arcs.size(); ++i) {
      if (!is_outline(arcs[i])) continue;
      evidence[i] = {0, outline_weight};
      any = true;
    }
    return any;
  }

  // Evidence for the longest of the other arcs, by rays; weight 0 for what is left.
  void gather(const std::vector<PathArc>& arcs, std::vector<Evidence>& evidence) {
    std::vector<std::size_t> order(arcs.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
      return arcs[i].length_px != arcs[j].length_px ? arcs[i].length_px > arcs[j].length_px : i < j;
    });
    order.resize(std::min(most_arcs_asked, order.size()));
    for (const std::size_t i : order) {
      if (evidence[i].weight == 0) evidence[i] = remember(arcs[i]);
    }
  }

  Evidence remember(const PathArc& arc) {
    const std::vector<Visit>& visits = arrangement_.visits[idx(arc.strand)];
    const auto crossing = [&](int visit) {
      return visit == none ? none : visits[idx(visit)].crossing;
    };
    const std::array<int, 3> key{arc.strand, crossing(arc.begin), crossing(arc.end)};
    const auto found = known_.find(key);
    if (found != known_.end()) return found->second;
    return rays_.rays() < most_rays ? known_[key] = ask(arc) : Evidence{0, 0};
  }

  // The middle one of three counts; one on the outline counts for more than its length.
  Evidence ask(const PathArc& arc) {
    std::array<LayerCount, 3> counts{rays_.count(arrangement_, arc.samples[2])};
    counts[1] = counts[2] = counts[0];
    if (arc.length_px >= asked_thrice_px) counts[1] = rays_.count(arrangement_, arc.samples[1]);
    if (counts[1].layers != counts[0].layers) counts[2] = rays_.count(arrangement_, arc.samples[3]);
    std::sort(counts.begin(), counts.end(), [](const LayerCount& a, const LayerCount& b) {
      return std::tie(a.layers, b.beside_nothing) < std::tie(b.layers, a.beside_nothing);
    });
    const double sure = std::min(beside_nothing_px, beside_nothing_share * arc.length_px);
    return {counts[1].layers, arc.length_px + least_weight + counts[1].beside_nothing * sure};
  }

  bool is_outline(const PathArc& arc) const {
    const std::vector<Visit>& visits = arrangement_.visits[idx(arc.strand)];
    const bool closed = arrangement_.network->strands[idx(arc.strand)].closed();
    const bool wraps = closed && arc.begin != none && arc.end <= arc.begin;
    const auto contains = [&](const StrandPlace& place) {
      const bool behind = arc.begin == none || is_before(visits[idx(arc.begin)].place, place);
      const bool before = arc.end == none || is_before(place, visits[idx(arc.end)].place);
      return wraps ? behind || before : behind && before;
    };
    const std::vector<StrandPlace>& places = arrangement_.outline[idx(arc.strand)];
    return std::any_of(places.begin(), places.end(), contains);
  }

  static bool is_before(const StrandPlace& a, const StrandPlace& b) {
    return std::tie(a.segment, a.fraction) < std::tie(b.segment, b.fraction);
  }

  const Arrangement& arrangement_;
  LayerRays& rays_;
  KnownEvidence& known_;
};

// What the paths say at a crossing; `back` is the smaller of the labels before and behind it.
struct CrossingLabels {
  std::size_t front_path = 0, back_path = 0;
  int front = 0, back = 0;
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

// Moves one base after another to where the rays and the crossings with other paths mind it least.
// Every move makes the sum of all that is minded smaller, so it ends.
class BaseSettler {
 public:
  BaseSettler(const Arrangement& arrangement, std::vector<LabelledPath>& paths)
      : paths_(paths),
        labels_(labels_at_crossings(arrangement, paths)),
        crossings_of_(paths.size()),
        moved_(paths.size(), 0) {
    for (std::size_t c = 0; c < labels_.size(); ++c) {
      const CrossingLabels& labels = labels_[c];
      if (!arrangement.is_live(static_cast<int>(c)) || labels.front_path == labels.back_path)
        continue;
      crossings_of_[labels.front_path].push_back(c);
      crossings_of_[labels.back_path].push_back(c);
    }
  }

  void run() {
    constexpr int most_rounds = 20;
    bool changed = true;
    for (int round = 0; changed && round < most_rounds; ++round) {
      changed = false;
      for (std::size_t p = 0; p < paths_.size(); ++p) changed |= settle(p);
    }
  }

 private:
  bool settle(std::size_t p) {
    LabelledPath& path = paths_[p];
    if (!path.is_balanced() || crossings_of_[p].empty()) return false;
    const int highest = static_cast<int>(path.costs.size()) + 2;
    int best = path.base;
    double least = price(p, best);
    for (int base = 0; base <= highest; ++base) {
      const double other = price(p, base);
      if (other < least - 1e-9) {
        best = base;
        least = other;
      }
    }
    if (best == path.base) return false;
    moved_[p] += best - path.base;
    path.move_base(best - path.base);
    return true;
  }

  double price(std::size_t p, int base) const {
    const LabelledPath& path = paths_[p];
    const int known = static_cast<int>(path.costs.size()) - 1;
    double length = 0;
    if (base > known) {
      for (const PathArc& arc : path.labels.arcs) length += arc.length_px;
    }
    double sum = path.costs[idx(std::min(base, known))] + length * (base - known);
    for (const std::size_t c : crossings_of_[p]) {
      const CrossingLabels& labels = labels_[c];
      int front = labels.front + moved_[labels.front_path];
      int back = labels.back + moved_[labels.back_path];
      (labels.front_path == p ? front : back) += base - path.base;
      sum += contradiction_px * std::max(front - back, 0);
    }
    return sum;
  }

  std::vector<LabelledPath>& paths_;
  std::vector<CrossingLabels> labels_;  // before any move
  std::vector<std::vector<std::size_t>> crossings_of_;
  std::vector<int> moved_;  // (paths)
};

}  // namespace

void LabelledPath::move_base(int by) {
  base += by;
  for (std::vector<int>* values : {&at_start, &along, &at_end}) {
    for (int& label : *values) label += by;
  }
}

LabelledPath label_path(const Arrangement& arrangement, const Path& path, bool trusts_rules,
                        LayerRays& rays, KnownEvidence& known) {
  return Labeller(arrangement, rays, known).label(path, trusts_rules);
}

std::vector<int> contradictions(const Arrangement& arrangement,
                                const std::vector<LabelledPath>& paths) {
  const std::vector<CrossingLabels> labels = labels_at_crossings(arrangement, paths);
  std::vector<int> result;
  for (std::size_t c = 0; c < labels.size(); ++c) {
    if (arrangement.is_live(static_cast<int>(c)) && labels[c].back < labels[c].front)
      result.push_back(static_cast<int>(c));
  }
  return result;
}

void settle_bases(const Arrangement& arrangement, std::vector<LabelledPath>& paths) {
  BaseSettler(arrangement, paths).run();
}

}  // namespace illustrate
