#include <gtest/gtest.h>

#include "core/errors.h"
#include "field/families/signed_labels.h"

namespace illustrate {
namespace {

struct Tie {
  int a, b;
  double weight;
};

SignedGraph graph_of(std::vector<double> pulls, const std::vector<Tie>& ties) {
  SignedGraph graph;
  for (int node = 0; node < static_cast<int>(pulls.size()); ++node) {
    for (const Tie& tie : ties) {
      if (tie.a == node) graph.links.push({tie.b, tie.weight});
      if (tie.b == node) graph.links.push({tie.a, tie.weight});
    }
    graph.links.close_list();
  }
  graph.pulls = std::move(pulls);
  return graph;
}

// Ties and pulls by chance.
SignedGraph random_graph(int nodes, double density, SeededNumbers& numbers) {
  std::vector<double> pulls;
  std::vector<Tie> ties;
  for (int a = 0; a < nodes; ++a) {
    pulls.push_back(0.5 * numbers.uniform());
    for (int b = 0; b < a; ++b) {
      if (std::abs(numbers.uniform()) < density) ties.push_back({a, b, numbers.uniform()});
    }
  }
  return graph_of(pulls, ties);
}

// A sheet of squares with ties of one length; some ask for different labels.
SignedGraph sheet(int size, double share_of_signs, SeededNumbers& numbers) {
  std::vector<Tie> ties;
  std::vector<double> pulls;
  const auto sign = [&] { return std::abs(numbers.uniform()) < share_of_signs ? -1.0 : 1.0; };
  for (int i = 0; i < size; ++i) {
    for (int j = 0; j < size; ++j) {
      pulls.push_back(0.4 * numbers.uniform());
      if (i > 0) ties.push_back({i * size + j, (i - 1) * size + j, sign()});
      if (j > 0) ties.push_back({i * size + j, i * size + j - 1, sign()});
    }
  }
  return graph_of(pulls, ties);
}

double least_cost(const SignedGraph& graph) {
  double least = 1e9;
  for (unsigned bits = 0; bits < 1U << graph.size(); ++bits) {
    Labels labels;
    for (std::size_t i = 0; i < graph.size(); ++i) labels.push_back(bits >> i & 1U ? 1 : -1);
    least = std::min(least, cost(graph, labels));
  }
  return least;
}

TEST(SignedGraph, CostIsWhatItSays) {
  const SignedGraph graph = graph_of({0.5, 0, -1}, {{0, 1, 2}, {1, 2, -3}});
  EXPECT_DOUBLE_EQ(cost(graph, {1, 1, -1}), -2 - 3 - 0.5 - 1);
  EXPECT_DOUBLE_EQ(cost(graph, {1, -1, -1}), 2 + 3 - 0.5 - 1);
}

TEST(SignedGraph, CoarserGraphsCostTheSameUpToAConstant) {
  SeededNumbers numbers(3);
  const SignedGraph fine = random_graph(30, 0.2, numbers);
  std::vector<Membership> members;
  const SignedGraph coarse = coarsen(fine, {}, nullptr, members);
  EXPECT_LT(coarse.size(), 20U);
  const Labels some(coarse.size(), 1);
  const double constant = cost(fine, prolonged(some, members)) - cost(coarse, some);
  for (int k = 0; k < 20; ++k) {
    Labels labels;
    for (std::size_t i = 0; i < coarse.size(); ++i) {
      labels.push_back(numbers.uniform() < 0 ? -1 : 1);
    }
    const Labels of_fine = prolonged(labels, members);
    EXPECT_NEAR(cost(fine, of_fine) - cost(coarse, labels), constant, 1e-12);
    EXPECT_EQ(restricted(of_fine, members, coarse.size()), labels);
  }
}

TEST(SignedGraph, NodesThatDisagreeAreNotJoined) {
  SeededNumbers numbers(4);
  const SignedGraph graph = random_graph(30, 0.3, numbers);
  const Labels labels = cheap_labels(graph);
  std::vector<Membership> members;
  const SignedGraph coarse = coarsen(graph, labels, &numbers, members);
  EXPECT_EQ(prolonged(restricted(labels, members, coarse.size()), members), labels);
}

TEST(CheapLabels, AreTheCheapestOfSmallGraphs) {
  SeededNumbers numbers(5);
  for (int k = 0; k < 200; ++k) {
    const SignedGraph graph = random_graph(3 + k % 10, 0.2 + 0.1 * (k % 9), numbers);
    EXPECT_NEAR(cost(graph, cheap_labels(graph)), least_cost(graph), 1e-12) << k;
  }
}

TEST(CheapLabels, TiesThatAgreeAreAllSatisfied) {
  SeededNumbers numbers(6);
  SignedGraph graph = sheet(90, 0, numbers);  // more nodes than searches compete on
  graph.pulls.assign(graph.size(), 0);
  graph.pulls[17] = -1e-3;
  Labels hidden;
  for (std::size_t i = 0; i < graph.size(); ++i) hidden.push_back(numbers.uniform() < 0 ? -1 : 1);
  for (std::size_t i = 0; i < graph.size(); ++i) {
    for (SignedLink& link : graph.links[i]) {
      link.weight = hidden[i] * hidden[static_cast<std::size_t>(link.node)];
    }
  }
  const Labels found = cheap_labels(graph);
  for (std::size_t i = 0; i < graph.size(); ++i) {
    EXPECT_EQ(found[i] * hidden[i], -hidden[17]) << i;
  }
}

TEST(CheapLabels, NoSingleFlipPaysAndPlantedOnesAreReached) {
  SeededNumbers numbers(7);
  const SignedGraph graph = sheet(80, 0.08, numbers);
  const Labels labels = cheap_labels(graph);
  const double found = cost(graph, labels);
  for (std::size_t i = 0; i < graph.size(); i += 7) {
    Labels flipped = labels;
    flipped[i] = static_cast<std::int8_t>(-flipped[i]);
    EXPECT_GE(cost(graph, flipped), found - 1e-9);
  }
  EXPECT_LT(found, cost(graph, Labels(graph.size(), 1))) << "the signs were put on these";
}

// Both graphs side by side.
SignedGraph beside(const SignedGraph& one, SignedGraph both) {
  const auto shift = static_cast<int>(both.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    for (const SignedLink& link : one.links[i]) both.links.push({link.node + shift, link.weight});
    both.links.close_list();
    both.pulls.push_back(one.pulls[i]);
  }
  return both;
}

TEST(CheapLabels, OfAPartDoNotDependOnOthers) {
  SeededNumbers numbers(8);
  const SignedGraph one = sheet(20, 0.2, numbers), other = sheet(15, 0.3, numbers);
  const SignedGraph both = beside(one, other);
  const Labels alone = cheap_labels(one), together = cheap_labels(both);
  EXPECT_TRUE(std::equal(alone.begin(), alone.end(), together.end() - 400));
  EXPECT_EQ(cheap_labels(both), together) << "and they are the same again";
}

TEST(CheapLabels, KnownPartsAreNotSearchedAndThreadsChangeNothing) {
  SeededNumbers numbers(10);
  const SignedGraph one = sheet(50, 0.2, numbers);
  const SignedGraph both = beside(one, one);
  Labels known(both.size(), 0);
  std::fill_n(known.begin(), one.size(), std::int8_t{-1});
  Labels expected(one.size(), -1);
  const Labels searched = cheap_labels(one);
  expected.insert(expected.end(), searched.begin(), searched.end());
  EXPECT_EQ(cheap_labels(both, 1, {}, known), expected);
  EXPECT_EQ(cheap_labels(both, 2), cheap_labels(both, 1));
}

TEST(CheapLabels, OfNothingAreNoneAndCanBeCancelled) {
  EXPECT_TRUE(cheap_labels({}).empty());
  EXPECT_EQ(cheap_labels(graph_of({-1}, {})), Labels{-1});
  SeededNumbers numbers(9);
  int calls = 0;
  const Progress progress([&](double, const std::string&) { return ++calls < 3; }, "field");
  EXPECT_THROW(cheap_labels(sheet(30, 0.2, numbers), 1, progress), Cancelled);
}

}  // namespace
}  // namespace illustrate
