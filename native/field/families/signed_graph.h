// Graphs whose nodes have one of two labels each, tied to be equal or to differ, and smaller and
// smaller ones with the same cost (a spin glass, in physics).
#pragma once

#include "core/ragged.h"
#include "field/search/diffusion.h"

namespace illustrate {

// A tie as one of its ends sees it: weight > 0 asks for the same label at both, < 0 for different
// ones. It costs 2 |weight| where it gets the other.
struct SignedLink {
  int node;
  double weight;
};

struct SignedGraph {
  Ragged<SignedLink> links;   // (n) every tie stands at both of its ends
  std::vector<double> pulls;  // (n) > 0 asks for label 1, < 0 for -1

  std::size_t size() const { return pulls.size(); }
};

using Labels = std::vector<std::int8_t>;  // (n) 1 or -1

// - sum over ties of weight label_a label_b - sum over nodes of pull label.
double cost(const SignedGraph& graph, const Labels& labels);

// A node's label is that of its aggregate, times `sign`.
struct Membership {
  int aggregate;
  std::int8_t sign;
};

// Pairs of nodes, greedily along the strongest tie of one that is left, become the nodes of the
// next graph, whose cost is the same up to a constant for labels that agree within each pair.
// labels: none, and both ends are as their tie asks; or (n), and only ties that these satisfy join
// nodes. shuffle: nodes are taken in an order of chance; null: in their own.
SignedGraph coarsen(const SignedGraph& fine, const Labels& labels, SeededNumbers* shuffle,
                    std::vector<Membership>& members);

// Labels that agree within each aggregate, and the aggregates' as labels of the nodes.
Labels restricted(const Labels& labels, const std::vector<Membership>& members,
                  std::size_t aggregates);
Labels prolonged(const Labels& labels, const std::vector<Membership>& members);

// The connected parts: nodes of each, ascending; parts by their first nodes.
Ragged<int> connected_nodes(const SignedGraph& graph);

}  // namespace illustrate
