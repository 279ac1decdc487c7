// Minimum cuts of sparse graphs (Boykov and Kolmogorov 2004, "An experimental comparison of
// min-cut/max-flow algorithms for energy minimization in vision").
//
// Two search trees, one from the source and one from the sink, grow until they touch; the path
// found is filled, what it cuts off is adopted by a neighbour or set free. Made for graphs in which
// most nodes have a terminal near.
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

  void add_cost(int node, std::int64_t cost) { nodes_[idx(node)].cost -= cost; }
  // cost > 0; more edges between two nodes add up.
  void add_edge(int from, int to, std::int64_t cost);

  void solve();

  // After `solve`: whether a node is in the smallest set of least cost, or in the largest.
  std::vector<std::uint8_t> smallest() const;
  std::vector<std::uint8_t> largest() const;

 private:
  enum class Tree : std::uint8_t { free, source, sink };

  // Half of an edge: what may still flow to `head`; the other half is its index ^ 1.
  struct Half {
    int head;
    int next;  // of the same tail
    std::int64_t room;
  };
  struct Node {
    int first = none;   // half-edge
    int parent = none;  // half-edge to the parent in its tree; at_terminal, orphan
    Tree tree = Tree::free;
    bool is_active = false;
    int distance = 0;  // to the terminal, true at `time`
    int time = 0;
    std::int64_t cost =
        0;  // negative of the node's cost: room from the source, or, < 0, to the sink
  };
  static constexpr int at_terminal = -2, orphan = -3;

  int tail(int half) const { return halves_[idx(half ^ 1)].head; }
  // What may flow between a node and its child along the half-edge from the child to it.
  std::int64_t& room_to_child(Tree tree, int to_parent) {
    return halves_[idx(tree == Tree::source ? to_parent ^ 1 : to_parent)].room;
  }
  bool can_grow(Tree tree, int half) const {
    return halves_[idx(tree == Tree::source ? half : half ^ 1)].room > 0;
  }

  void activate(int node);
  void plant();
  int grow(int node);
  void augment(int bridge);
  std::int64_t bottleneck(int node) const;
  void push(int node, std::int64_t flow);
  void adopt_orphans();
  void adopt(int node);
  void set_free(int node);
  int distance_to_terminal(int node);
  std::vector<std::uint8_t> reached_from(Tree root) const;

  std::vector<Node> nodes_;
  std::vector<Half> halves_;
  std::deque<int> active_;
  std::deque<int> orphans_;
  int time_ = 0;
};

}  // namespace illustrate
