// Minimum cuts of sparse graphs (Boykov and Kolmogorov 2004, "An experimental comparison of
// min-cut/max-flow algorithms for energy minimization in vision").
//
// Two search trees, one from the source and one from the sink, grow until they touch; the path
// found is filled, what it cuts off is adopted by a neighbour or set free. Made for graphs in which
// most nodes have a terminal near. What has been found stays: after costs have changed, no more is
// searched than they concern (Kohli and Torr 2007, "Dynamic graph cuts for efficient inference in
// Markov random fields").
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "core/types.h"

namespace illustrate {

// A set of nodes, the chosen ones, of least cost: a node has its own cost when it is chosen, which
// may be negative, and an edge has one where its first node is chosen and its second is not.
class MinCut {
 public:
  explicit MinCut(int nodes);

  // Of a node, to what it has; also after `solve`, like the next but one.
  void add_cost(int node, std::int64_t cost);
  // Returns the number of the edge. cost >= 0; more edges between two nodes add up. All of
  // them before the first `set_edge` or `solve`.
  int add_edge(int from, int to, std::int64_t cost);
  void set_edge(int edge, std::int64_t cost);

  void solve();

  // (nodes) After `solve`: whether each is in the smallest set of least cost, or in the largest.
  std::vector<std::uint8_t> smallest() const { return mask(Tree::source, true); }
  std::vector<std::uint8_t> largest() const { return mask(Tree::sink, false); }

 private:
  enum class Tree : std::uint8_t { free, source, sink };

  struct Edge {
    int from, to;
    std::int64_t cost;
  };
  // Half of an edge: what may still flow to `head`. All of one tail stand together.
  struct Half {
    int head;
    int other;  // half of the edge
    std::int64_t room;
  };
  struct Node {
    int first = 0;      // half-edge; those of the next node follow
    int parent = none;  // half-edge to the parent in its tree; at_terminal, orphan
    bool is_active = false;
    int distance = 0;  // to the terminal, true at `time`
    int time = 0;
    std::int64_t room = 0;  // from the source, or, < 0, to the sink: what it costs not to choose it
  };
  static constexpr int at_terminal = -2, orphan = -3;

  int other(int half) const { return halves_[idx(half)].other; }
  int tail(int half) const { return halves_[idx(other(half))].head; }
  int end_of(int node) const { return nodes_[idx(node) + 1].first; }
  bool can_grow(Tree tree, int half) const {
    return halves_[idx(tree == Tree::source ? half : other(half))].room > 0;
  }

  Tree& tree(int node) { return trees_[idx(node)]; }

  void lay_out_edges();
  void activate(int node);
  void plant(int node);
  void change_room(int node, std::int64_t by);
  void mind_room(int half, bool had_room);
  int grow(int node);
  void augment(int bridge);
  std::int64_t bottleneck(int node) const;
  void push(int node, std::int64_t flow);
  void adopt_orphans();
  void adopt(int node);
  void set_free(int node);
  int distance_to_terminal(int node);
  std::vector<std::uint8_t> mask(Tree of, bool chosen) const;

  std::vector<Node> nodes_;  // and one behind the last
  std::vector<Tree> trees_;  // (nodes)
  std::vector<Edge> edges_;  // until they are laid out
  std::vector<Half> halves_;
  std::vector<int> half_of_edge_;  // (edges) that from its tail
  std::deque<int> active_;
  std::deque<int> orphans_;
  int time_ = 0;
};

}  // namespace illustrate
