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
using Label = std::uint8_t;
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
        states_(state_count()),
        next_cost_(idx(states_)),
        start_of_(arcs_.size() * idx(states_)),
        along_of_(start_of_.size()),
        previous_(start_of_.size()) {}

  // Where the table would be large, the first start that leads anywhere has to do.
  void solve() {
    const bool is_large = arcs_.size() * idx(states_) > most_entries;
    if (cyclic_ && !is_large) return solve_cycle();
    if (is_large) try_start(std::min(evidence_.front().layers, states_ - 1));
    for (int start = 0; start < states_ && path_.along.empty(); ++start) try_start(start);
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  // The best of all starts, the lowest of them where several are; most cost too much wherever the
  // way ends.
  void solve_cycle() {
    find_least_costs();
    const std::vector<double> least = cost_;
    const int most_promising = cheapest_from(0);
    try_start(most_promising);
    for (int start = 0; start < states_; ++start) {
      const bool may_win =
          start < best_start_ ? least[idx(start)] <= least_cost_ : least[idx(start)] < least_cost_;
      if (may_win && start != most_promising) try_start(start);
    }
  }

  // From each label at the path's start to whichever is cheapest at its end: prices are the same
  // both ways.
  void find_least_costs() {
    cost_.assign(idx(states_), 0);
    for (std::size_t arc = arcs_.size(); arc-- > 0;) {
      if (arc + 1 < arcs_.size()) pass_node(arc, -path_.labels.change_behind(arc));
      through(arc);
    }
  }

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

  // The label of least cost from `first` on.
  int cheapest_from(int first) const {
    return static_cast<int>(std::min_element(cost_.begin() + first, cost_.end()) - cost_.begin());
  }

  // Past a possible break; `origin` remembers where each label came from. Only the cheapest hidden
  // label and 0 can be worth leaving.
  void past_break(Label* origin) {
    const int cheapest = cheapest_from(1);
    const double visible = cost_[0], hidden = cost_[idx(cheapest)];
    const auto offer = [&](double cost, int from, int to) {
      if (from == to || cost >= cost_[idx(to)]) return;
      cost_[idx(to)] = cost;
      origin[to] = static_cast<Label>(from);
    };
    for (int to = 0; to < states_; ++to) {
      origin[to] = static_cast<Label>(to);
      offer(visible + dear_ * visible_break_px, 0, to);
      offer(hidden + dear_ * (to == 0 ? visible_break_px : hidden_break_px), cheapest, to);
    }
  }

  // From the costs of the labels at an arc's start to those at its end.
  void through(std::size_t arc) {
    past_break(&start_of_[arc * idx(states_)]);
    for (int q = 0; q < states_; ++q) cost_[idx(q)] += wrong(arc, q);
    past_break(&along_of_[arc * idx(states_)]);
  }

  // Between an arc and the next one, remembering the label that this one ends with.
  void pass_node(std::size_t arc, int change) {
    const int cheapest = cheapest_from(0);
    const bool is_free = arcs_[arc + 1].starts_free;
    const double by_free_change = is_free ? cost_[idx(cheapest)] + free_change_px : infinity;
    Label* previous = &previous_[(arc + 1) * idx(states_)];
    for (int q = 0; q < states_; ++q) {
      const bool possible = q - change >= 0 && q - change < states_;
      const double by_rule = possible ? cost_[idx(q - change)] : infinity;
      next_cost_[idx(q)] = std::min(by_free_change, by_rule);
      previous[q] = static_cast<Label>(by_free_change < by_rule ? cheapest
                                       : possible               ? q - change
                                                                : 0);
    }
    std::swap(cost_, next_cost_);
  }

  // What labels at the last arc's end cost where the first arc's start has `start`.
  void add_seam(int start) {
    const int by_rule = start - path_.labels.change_behind(arcs_.size() - 1);
    for (int q = 0; q < states_; ++q) {
      if (q != by_rule) cost_[idx(q)] += arcs_.front().starts_free ? free_change_px : infinity;
    }
  }

  // Cyclic paths start with exactly `start` layers and have to come back to them.
  void try_start(int start) {
    cost_.assign(idx(states_), cyclic_ ? infinity : 0);
    cost_[idx(start)] = 0;
    for (std::size_t arc = 0; arc < arcs_.size(); ++arc) {
      through(arc);
      if (arc + 1 < arcs_.size()) pass_node(arc, path_.labels.change_behind(arc));
    }
    if (cyclic_) add_seam(start);
    const int last = cheapest_from(0);
    const double cost = cost_[idx(last)];
    if (!(cost < least_cost_ || (cost == least_cost_ && start < best_start_))) return;
    least_cost_ = cost;
    best_start_ = start;
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
  int best_start_ = 0;
  std::vector<double> cost_, next_cost_;  // of each label, where the way has come to
  std::vector<Label> start_of_;           // [arc, label along it] -> label at its start
  std::vector<Label> along_of_;           // [arc, label at its end] -> label along it
  std::vector<Label> previous_;  // [arc, label at its start] -> label at the last one's end
};

}  // namespace

void label_with_breaks(LabelledPath& path, const std::vector<Evidence>& evidence, bool cyclic,
                       double dear) {
  LeastContradiction(path, evidence, cyclic, dear).solve();
}

}  // namespace illustrate
