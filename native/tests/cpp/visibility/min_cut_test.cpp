#include "visibility/labels/min_cut.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

namespace illustrate {
namespace {

// A small problem in plain numbers, and its sets of least cost found by trying all.
struct TriedCut {
  struct Edge {
    int from, to;
    std::int64_t cost;
  };
  std::vector<std::int64_t> costs;
  std::vector<Edge> edges;

  std::int64_t cost(unsigned set) const {
    const auto has = [&](int node) { return (set >> node & 1) != 0; };
    std::int64_t sum = 0;
    for (std::size_t n = 0; n < costs.size(); ++n) sum += has(static_cast<int>(n)) ? costs[n] : 0;
    for (const Edge& edge : edges) sum += has(edge.from) && !has(edge.to) ? edge.cost : 0;
    return sum;
  }

  // The smallest of them is what all share, the largest what any has.
  std::array<unsigned, 2> least() const {
    std::int64_t best = 0;
    std::array<unsigned, 2> found{0, 0};
    for (unsigned set = 1; set < 1U << costs.size(); ++set) {
      const std::int64_t tried = cost(set);
      if (tried < best) best = tried, found = {set, set};
      if (tried == best) found = {found[0] & set, found[1] | set};
    }
    return found;
  }
};

unsigned set_of(const std::vector<std::uint8_t>& chosen) {
  unsigned set = 0;
  for (std::size_t n = 0; n < chosen.size(); ++n) set |= chosen[n] ? 1U << n : 0;
  return set;
}

void expect_least(const MinCut& cut, const TriedCut& tried) {
  const auto [smallest, largest] = tried.least();
  ASSERT_EQ(set_of(cut.smallest()), smallest);
  ASSERT_EQ(set_of(cut.largest()), largest);
}

TEST(MinCut, IsTheLeastOfAllAlsoAfterChanges) {
  std::mt19937 random(1);
  const auto below = [&](int count) { return static_cast<int>(random() % unsigned(count)); };
  for (int round = 0; round < 300; ++round) {
    const int nodes = 2 + below(8);
    MinCut cut(nodes);
    TriedCut tried{std::vector<std::int64_t>(idx(nodes), 0), {}};
    const auto add_cost = [&] {
      const int node = below(nodes), cost = below(21) - 10;
      tried.costs[idx(node)] += cost;
      cut.add_cost(node, cost);
    };
    for (int i = 0; i < nodes; ++i) add_cost();
    for (int e = below(3 * nodes); e >= 0; --e) {
      tried.edges.push_back({below(nodes), below(nodes), below(8)});
      const TriedCut::Edge& edge = tried.edges.back();
      ASSERT_EQ(cut.add_edge(edge.from, edge.to, edge.cost),
                static_cast<int>(tried.edges.size() - 1));
    }
    for (int change = 0; change < 8; ++change) {
      cut.solve();
      ASSERT_NO_FATAL_FAILURE(expect_least(cut, tried)) << round << ", " << change;
      for (int i = below(4); i > 0; --i) add_cost();
      for (int i = below(4); i > 0; --i) {
        const int edge = below(static_cast<int>(tried.edges.size()));
        tried.edges[idx(edge)].cost = below(8);
        cut.set_edge(edge, tried.edges[idx(edge)].cost);
      }
    }
  }
}

}  // namespace
}  // namespace illustrate
