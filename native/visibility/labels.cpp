#include "visibility/labels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

namespace illustrate {
namespace {

constexpr std::size_t most_arcs_asked = 1000;  // of one path, the longest ones
constexpr double asked_thrice_px = 30;         // longer arcs are asked at three places
constexpr double outline_weight = 1e9;     // the outside of the drawing is certain: px of length
constexpr double beside_nothing_px = 100;  // an arc next to the empty background is nearly certain
constexpr double hidden_break_px = 12;     // what a break costs, in px of wrong label
constexpr double visible_break_px = 30;
constexpr double balanced_factor = 1e5;  // a path whose changes sum to zero hardly needs a break
constexpr double free_change_px = 1;     // a change at a demoted crossing
constexpr int most_layers = 64;
constexpr double least_weight = 1e-6;  // an arc without length still prefers its ray

// The labels along a path as the cheapest way through (arc, layers): from one arc to the next the
// label changes as the rules say, within an arc it may jump at the price of a break.
class LeastContradiction {
 public:
  LeastContradiction(LabelledPath& path, const std::vector<Evidence>& evidence, bool cyclic)
      : path_(path),
        arcs_(path.labels.arcs),
        evidence_(evidence),
        cyclic_(cyclic),
        dear_(cyclic && path.labels.residual == 0 ? balanced_factor : 1),
        states_(state_count()) {}

  void solve() {
    double best = infinity;
    for (int start = 0; start < (cyclic_ ? states_ : 1); ++start) try_start(start, best);
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

  LabelledPath label(const Path& path) {
    LabelledPath result;
    result.labels = relative_labels(arrangement_, path);
    const std::vector<Evidence> evidence = gather(result.labels.arcs);
    LeastContradiction(result, evidence, path.cyclic).solve();
    return result;
  }

 private:
  // Evidence for the longest arcs, by rays; weight 0 for the others.
  std::vector<Evidence> gather(const std::vector<PathArc>& arcs) {
    std::vector<std::size_t> order(arcs.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
      return arcs[i].length_px != arcs[j].length_px ? arcs[i].length_px > arcs[j].length_px : i < j;
    });
    std::vector<Evidence> evidence(arcs.size(), {0, 0});
    for (std::size_t k = 0; k < std::min(most_arcs_asked, order.size()); ++k) {
      const PathArc& arc = arcs[order[k]];
      evidence[order[k]] = remember(arc);
    }
    for (std::size_t i = 0; i < arcs.size(); ++i) {
      if (is_outline(arcs[i])) evidence[i] = {0, outline_weight};
    }
    return evidence;
  }

  Evidence remember(const PathArc& arc) {
    const std::vector<Visit>& visits = arrangement_.visits[idx(arc.strand)];
    const auto crossing = [&](int visit) {
      return visit == none ? none : visits[idx(visit)].crossing;
    };
    const std::array<int, 3> key{arc.strand, crossing(arc.begin), crossing(arc.end)};
    const auto found = known_.find(key);
    return found != known_.end() ? found->second : known_[key] = ask(arc);
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
    const double extra = counts[1].beside_nothing ? beside_nothing_px : least_weight;
    return {counts[1].layers, arc.length_px + extra};
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

}  // namespace

LabelledPath label_path(const Arrangement& arrangement, const Path& path, LayerRays& rays,
                        KnownEvidence& known) {
  return Labeller(arrangement, rays, known).label(path);
}

std::vector<int> contradictions(const Arrangement& arrangement,
                                const std::vector<LabelledPath>& paths) {
  std::vector<int> front(arrangement.crossings.size(), 0), back(arrangement.crossings.size(), 0);
  for (const LabelledPath& path : paths) {
    for (std::size_t i = 0; i < path.labels.arcs.size(); ++i) {
      const PathArc& arc = path.labels.arcs[i];
      if (arc.begin == none) continue;
      const Visit& visit = arrangement.visits[idx(arc.strand)][idx(arc.begin)];
      const int layers = path.at_start[i];
      const int change = back_change(arrangement, arrangement.crossings[idx(visit.crossing)]);
      if (visit.front) {
        front[idx(visit.crossing)] = layers;
      } else {
        back[idx(visit.crossing)] = std::min(layers, layers - change);
      }
    }
  }
  std::vector<int> result;
  for (std::size_t c = 0; c < front.size(); ++c) {
    if (arrangement.is_live(static_cast<int>(c)) && back[c] < front[c])
      result.push_back(static_cast<int>(c));
  }
  return result;
}

}  // namespace illustrate
