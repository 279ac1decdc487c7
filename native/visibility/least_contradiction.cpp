#include "visibility/least_contradiction.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace illustrate {
namespace {

constexpr double hidden_break_px = 12;  // what a break costs, in px of wrong label
constexpr double visible_break_px = 30;
constexpr double free_change_px = 5;  // at a demoted crossing, another change than the rule's
constexpr int most_layers = 64;
constexpr std::size_t most_entries = 500'000;  // of a table; of larger ones only one is made

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

  // Where the table would be large, the first start that leads anywhere has to do.
  void solve() {
    const bool is_large = arcs_.size() * idx(states_) > most_entries;
    if (is_large) try_start(std::min(evidence_.front().layers, states_ - 1));
    const bool first_will_do = is_large || !cyclic_;
    for (int start = 0; start < states_; ++start) {
      if (first_will_do && !path_.along.empty()) break;
      try_start(start);
    }
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  int state_count() const {
    int low = 0, high = 0, most = 0;
    for (std::size_t i = 0; i < arcs_.size(); ++i) {
      low = std::min(low, arcs_[i].offset);
      high = std::max(high, arcs_[i].offset);
      most = std::max(most, evidence_[i].layers + evidence_[i].unsure);
    }
    return std::min(most + high - low + 3, most_layers);
  }

  double wrong(std::size_t arc, int layers) const { return evidence_[arc].against(layers); }

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

  // What labels at the last arc's end cost where the first arc's start has `start`.
  std::vector<double> at_the_seam(int start, std::vector<double> cost) const {
    const int by_rule = start - path_.labels.change_behind(arcs_.size() - 1);
    for (int q = 0; q < states_; ++q) {
      if (q != by_rule) cost[idx(q)] += arcs_.front().starts_free ? free_change_px : infinity;
    }
    return cost;
  }

  // Cyclic paths start with exactly `start` layers and have to come back to them.
  void try_start(int start) {
    start_of_.assign(arcs_.size() * idx(states_), 0);
    along_of_.assign(arcs_.size() * idx(states_), 0);
    previous_.assign(arcs_.size() * idx(states_), 0);
    std::vector<double> cost(idx(states_), cyclic_ ? infinity : 0);
    cost[idx(start)] = 0;
    for (std::size_t arc = 0; arc < arcs_.size(); ++arc) {
      cost = through(arc, cost);
      if (arc + 1 < arcs_.size()) cost = to_next(arc, cost);
    }
    if (cyclic_) cost = at_the_seam(start, cost);
    const int last = static_cast<int>(std::min_element(cost.begin(), cost.end()) - cost.begin());
    if (!(cost[idx(last)] < least_cost_)) return;
    least_cost_ = cost[idx(last)];
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
  double least_cost_ = infinity;
  std::vector<int> start_of_;  // [arc, label along it] -> label at its start
  std::vector<int> along_of_;  // [arc, label at its end] -> label along it
  std::vector<int> previous_;  // [arc, label at its start] -> label at the end of the arc before
};

}  // namespace

void label_with_breaks(LabelledPath& path, const std::vector<Evidence>& evidence, bool cyclic,
                       double dear) {
  LeastContradiction(path, evidence, cyclic, dear).solve();
}

}  // namespace illustrate
