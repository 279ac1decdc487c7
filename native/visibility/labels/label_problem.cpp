#include "visibility/labels/label_problem.h"

#include <algorithm>
#include <limits>

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

// Raises (by = 1) or lowers (by = -1) the set of unknowns that gains most: of equally good ones the
// smallest set that rises, the largest that falls. False where none is chosen.
class Step {
 public:
  Step(const LabelProblem& problem, int by)
      : problem_(problem), by_(by), costs_(idx(problem.unknowns)) {}

  bool take(std::vector<int>& x) {
    MinCut cut(problem_.unknowns);
    add_values(x);
    add_differences(x, cut);
    for (int i = 0; i < problem_.unknowns; ++i) cut.add_cost(i, costs_[idx(i)]);
    cut.solve();
    const std::vector<std::uint8_t> chosen = by_ > 0 ? cut.smallest() : cut.largest();
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += chosen[i] ? by_ : 0;
    return std::find(chosen.begin(), chosen.end(), 1) != chosen.end();
  }

 private:
  void add_values(const std::vector<int>& x) {
    std::fill(costs_.begin(), costs_.end(), 0);
    for (const ValueTerm& term : problem_.values) {
      const int now = x[idx(term.unknown)];
      costs_[idx(term.unknown)] += price_of(term, now + by_) - price_of(term, now);
    }
    for (std::size_t i = 0; by_ < 0 && i < x.size(); ++i) {
      if (x[i] == 0) costs_[i] = forbidden;
    }
  }

  // With d = x(to) - x(from): f(d + by) - f(d) where `to` alone is chosen, f(d - by) - f(d) where
  // `from` alone is. Their sum is 0 but at the bend of f: only there an edge is needed.
  void add_differences(const std::vector<int>& x, MinCut& cut) {
    for (const DifferenceTerm& term : problem_.differences) {
      const int d = x[idx(term.to)] - x[idx(term.from)];
      const std::int64_t now = price_of(term, d);
      const std::int64_t to_alone = price_of(term, d + by_) - now;
      const std::int64_t from_alone = price_of(term, d - by_) - now;
      add_to(term.from, from_alone);
      add_to(term.to, -from_alone);
      if (to_alone + from_alone > 0) cut.add_edge(term.to, term.from, to_alone + from_alone);
    }
  }

  void add_to(int unknown, std::int64_t cost) {
    std::int64_t& sum = costs_[idx(unknown)];
    if (sum != forbidden) sum += cost;
  }

  const LabelProblem& problem_;
  int by_;
  std::vector<std::int64_t> costs_;
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
  for (Step step : {Step(problem, 1), Step(problem, -1)}) {
    do progress.report(0);
    while (step.take(x));
  }
  return x;
}

}  // namespace illustrate
