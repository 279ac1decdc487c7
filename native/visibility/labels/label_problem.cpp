#include "visibility/labels/label_problem.h"

#include <algorithm>

#include "core/ragged.h"
#include "visibility/labels/min_cut.h"

namespace illustrate {
namespace {

// No sum of prices is as large.
constexpr std::int64_t forbidden = std::int64_t{1} << 60;

std::int64_t price_of(const ValueTerm& term, int x) {
  return term.below * std::max(term.low - x, 0) + term.above * std::max(x - term.high, 0);
}

std::int64_t price_of(const DifferenceTerm& term, int difference) {
  const std::int64_t over = difference - term.wanted;
  return over < 0 ? -over * term.below : over * term.above;
}

// What the two unknowns of a term cost where they are chosen, and what it costs more
// to choose `to` alone. With d = x(to) - x(from): f(d + by) - f(d) where `to` alone is chosen, f(d
// - by) - f(d) where `from` alone is. Their sum is 0 but at the bend of f.
struct PairCosts {
  std::int64_t from, to, edge;
};

PairCosts costs_of(const DifferenceTerm& term, int d, int by) {
  const std::int64_t now = price_of(term, d);
  const std::int64_t to_alone = price_of(term, d + by) - now;
  const std::int64_t from_alone = price_of(term, d - by) - now;
  return {from_alone, -from_alone, to_alone + from_alone};
}

// (unknowns) the terms that each is in.
template <class Term, class Visit>
Ragged<int> terms_of(int unknowns, const std::vector<Term>& terms, const Visit& visit) {
  return sorted_into<int>(idx(unknowns), [&](const auto& put) {
    for (std::size_t t = 0; t < terms.size(); ++t) {
      visit(terms[t], [&](int i) { put(i, static_cast<int>(t)); });
    }
  });
}

// Raises (by = 1) or lowers (by = -1) sets of unknowns: each time the one that gains most, of
// equally good ones the smallest set that rises, the largest that falls. Many sets are small, and
// no more is searched for one than what the last has changed.
class Steps {
 public:
  Steps(const LabelProblem& problem, int by, std::vector<int>& x)
      : problem_(problem),
        by_(by),
        x_(x),
        values_of_(terms_of(problem.unknowns, problem.values,
                            [](const ValueTerm& term, const auto& use) { use(term.unknown); })),
        differences_of_(terms_of(problem.unknowns, problem.differences,
                                 [](const DifferenceTerm& term, const auto& use) {
                                   use(term.from);
                                   use(term.to);
                                 })),
        cut_(problem.unknowns) {
    add_costs();
    for (const DifferenceTerm& term : problem.differences) {
      edges_.push_back(
          cut_.add_edge(term.to, term.from, costs_of(term, difference(term), by).edge));
    }
  }

  // False where no set is chosen.
  bool take() {
    cut_.solve();
    const std::vector<std::uint8_t> chosen = by_ > 0 ? cut_.smallest() : cut_.largest();
    bool is_any = false;
    for (int i = 0; i < problem_.unknowns; ++i) {
      if (chosen[idx(i)]) change(i, chosen), is_any = true;
    }
    for (std::size_t i = 0; is_any && i < chosen.size(); ++i) x_[i] += chosen[i] ? by_ : 0;
    return is_any;
  }

 private:
  int difference(const DifferenceTerm& term) const { return x_[idx(term.to)] - x_[idx(term.from)]; }

  std::int64_t cost_of(const ValueTerm& term, int x) const {
    return price_of(term, x + by_) - price_of(term, x);
  }
  // Labels are never less than 0.
  std::int64_t cost_of_falling(int x) const { return by_ < 0 && x == 0 ? forbidden : 0; }

  void add_costs() {
    std::vector<std::int64_t> costs(x_.size());
    for (std::size_t i = 0; i < x_.size(); ++i) costs[i] = cost_of_falling(x_[i]);
    for (const ValueTerm& term : problem_.values) {
      costs[idx(term.unknown)] += cost_of(term, x_[idx(term.unknown)]);
    }
    for (const DifferenceTerm& term : problem_.differences) {
      const PairCosts pair = costs_of(term, difference(term), by_);
      costs[idx(term.from)] += pair.from;
      costs[idx(term.to)] += pair.to;
    }
    for (int i = 0; i < problem_.unknowns; ++i) cut_.add_cost(i, costs[idx(i)]);
  }

  // Tells the cut what changes as an unknown takes the step with all that are chosen.
  void change(int i, const std::vector<std::uint8_t>& chosen) {
    const int now = x_[idx(i)], then = now + by_;
    std::int64_t cost = cost_of_falling(then) - cost_of_falling(now);
    for (const int t : values_of_[idx(i)]) {
      const ValueTerm& term = problem_.values[idx(t)];
      cost += cost_of(term, then) - cost_of(term, now);
    }
    cut_.add_cost(i, cost);
    for (const int t : differences_of_[idx(i)]) {
      const DifferenceTerm& term = problem_.differences[idx(t)];
      if (!chosen[idx(term.from)] || !chosen[idx(term.to)]) change(t, i == term.to ? by_ : -by_);
    }
  }

  void change(int t, int by) {
    const DifferenceTerm& term = problem_.differences[idx(t)];
    const int now = difference(term);
    const PairCosts before = costs_of(term, now, by_), after = costs_of(term, now + by, by_);
    cut_.set_edge(edges_[idx(t)], after.edge);
    cut_.add_cost(term.from, after.from - before.from);
    cut_.add_cost(term.to, after.to - before.to);
  }

  const LabelProblem& problem_;
  const int by_;
  std::vector<int>& x_;
  const Ragged<int> values_of_, differences_of_;  // (unknowns) terms
  MinCut cut_;
  std::vector<int> edges_;  // (differences)
};

}  // namespace

std::int64_t price(const LabelProblem& problem, const std::vector<int>& x) {
  std::int64_t sum = 0;
  for (const ValueTerm& term : problem.values) sum += price_of(term, x[idx(term.unknown)]);
  for (const DifferenceTerm& term : problem.differences) {
    sum += price_of(term, x[idx(term.to)] - x[idx(term.from)]);
  }
  return sum;
}

std::vector<int> least_labels(const LabelProblem& problem, std::vector<int> start,
                              const Progress& progress) {
  std::vector<int> x = std::move(start);
  for (const int by : {1, -1}) {
    Steps steps(problem, by, x);
    do progress.report(0);
    while (steps.take());
  }
  return x;
}

}  // namespace illustrate
