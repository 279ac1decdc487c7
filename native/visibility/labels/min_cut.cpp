#include "visibility/labels/min_cut.h"

#include <algorithm>
#include <limits>

namespace illustrate {

MinCut::MinCut(int nodes) : nodes_(idx(nodes)) {}

void MinCut::add_edge(int from, int to, std::int64_t cost) {
  const int half = static_cast<int>(halves_.size());
  halves_.push_back({to, nodes_[idx(from)].first, cost});
  nodes_[idx(from)].first = half;
  halves_.push_back({from, nodes_[idx(to)].first, 0});
  nodes_[idx(to)].first = half + 1;
}

void MinCut::activate(int node) {
  if (nodes_[idx(node)].is_active) return;
  nodes_[idx(node)].is_active = true;
  active_.push_back(node);
}

// Every node with room to a terminal is the child of that terminal.
void MinCut::plant() {
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    Node& node = nodes_[n];
    if (node.cost == 0) continue;
    node.tree = node.cost > 0 ? Tree::source : Tree::sink;
    node.parent = at_terminal;
    node.distance = 1;
    activate(static_cast<int>(n));
  }
}

void MinCut::solve() {
  plant();
  while (!active_.empty()) {
    const int node =
        active_.front();  // the oldest: both trees grow in breadth, and paths are short
    if (nodes_[idx(node)].parent == none) {
      nodes_[idx(node)].is_active = false;
      active_.pop_front();
      continue;
    }
    const int bridge = grow(node);
    ++time_;
    if (bridge == none) {
      nodes_[idx(node)].is_active = false;
      active_.pop_front();
      continue;
    }
    augment(bridge);
    adopt_orphans();
  }
}

// Takes free neighbours into the node's tree. A half-edge from the source's tree to the sink's,
// none where there is no such.
int MinCut::grow(int node) {
  const Tree tree = nodes_[idx(node)].tree;
  for (int half = nodes_[idx(node)].first; half != none; half = halves_[idx(half)].next) {
    if (!can_grow(tree, half)) continue;
    Node& other = nodes_[idx(halves_[idx(half)].head)];
    if (other.tree == Tree::free) {
      other.tree = tree;
      other.parent = half ^ 1;
      other.time = nodes_[idx(node)].time;
      other.distance = nodes_[idx(node)].distance + 1;
      activate(halves_[idx(half)].head);
    } else if (other.tree != tree) {
      return tree == Tree::source ? half : half ^ 1;
    } else if (other.time <= nodes_[idx(node)].time &&
               other.distance > nodes_[idx(node)].distance + 1) {
      other.parent = half ^ 1;  // a shorter way to the terminal
      other.time = nodes_[idx(node)].time;
      other.distance = nodes_[idx(node)].distance + 1;
    }
  }
  return none;
}

// What may flow between a node and the terminal of its tree.
std::int64_t MinCut::bottleneck(int node) const {
  const Tree tree = nodes_[idx(node)].tree;
  std::int64_t least = std::numeric_limits<std::int64_t>::max();
  for (int n = node;;) {
    const int up = nodes_[idx(n)].parent;
    if (up == at_terminal) return std::min(least, std::abs(nodes_[idx(n)].cost));
    least = std::min(least, halves_[idx(tree == Tree::source ? up ^ 1 : up)].room);
    n = halves_[idx(up)].head;
  }
}

void MinCut::push(int node, std::int64_t flow) {
  const Tree tree = nodes_[idx(node)].tree;
  for (int n = node;;) {
    const int up = nodes_[idx(n)].parent;
    if (up == at_terminal) {
      nodes_[idx(n)].cost -= tree == Tree::source ? flow : -flow;
      if (nodes_[idx(n)].cost == 0) set_free(n);
      return;
    }
    const int next = halves_[idx(up)].head;
    const int filled = tree == Tree::source ? up ^ 1 : up;
    halves_[idx(filled)].room -= flow;
    halves_[idx(filled ^ 1)].room += flow;
    if (halves_[idx(filled)].room == 0) set_free(n);
    n = next;
  }
}

void MinCut::augment(int bridge) {
  const int from = tail(bridge), to = halves_[idx(bridge)].head;
  const std::int64_t flow = std::min({halves_[idx(bridge)].room, bottleneck(from), bottleneck(to)});
  halves_[idx(bridge)].room -= flow;
  halves_[idx(bridge ^ 1)].room += flow;
  push(from, flow);
  push(to, flow);
}

void MinCut::set_free(int node) {
  nodes_[idx(node)].parent = orphan;
  orphans_.push_back(node);
}

void MinCut::adopt_orphans() {
  while (!orphans_.empty()) {
    const int node = orphans_.front();
    orphans_.pop_front();
    adopt(node);
  }
}

// Steps to the terminal, or -1 where the way ends at an orphan. Nodes on the way remember theirs.
int MinCut::distance_to_terminal(int node) {
  int steps = 0, n = node;
  while (nodes_[idx(n)].time != time_ || nodes_[idx(n)].parent < 0) {
    const int up = nodes_[idx(n)].parent;
    if (up == orphan || up == none) return -1;
    ++steps;
    if (up == at_terminal) {
      nodes_[idx(n)].time = time_;
      nodes_[idx(n)].distance = 1;
      break;
    }
    n = halves_[idx(up)].head;
  }
  const bool stopped_at_known = nodes_[idx(n)].parent >= 0;
  const int total = stopped_at_known ? steps + nodes_[idx(n)].distance : steps;
  int left = total;
  for (int m = node; m != n; m = halves_[idx(nodes_[idx(m)].parent)].head) {
    nodes_[idx(m)].time = time_;
    nodes_[idx(m)].distance = left--;
  }
  return total;
}

// Finds the orphan the neighbour nearest to the terminal, or lets it and its children go.
void MinCut::adopt(int node) {
  const Tree tree = nodes_[idx(node)].tree;
  int best = none, best_distance = std::numeric_limits<int>::max();
  for (int half = nodes_[idx(node)].first; half != none; half = halves_[idx(half)].next) {
    const int other = halves_[idx(half)].head;
    if (nodes_[idx(other)].tree != tree || !can_grow(tree, half ^ 1)) continue;
    const int distance = distance_to_terminal(other);
    if (distance >= 0 && distance < best_distance) best = half, best_distance = distance;
  }
  nodes_[idx(node)].parent = best;
  if (best != none) {
    nodes_[idx(node)].time = time_;
    nodes_[idx(node)].distance = best_distance + 1;
    return;
  }
  for (int half = nodes_[idx(node)].first; half != none; half = halves_[idx(half)].next) {
    const int other = halves_[idx(half)].head;
    if (nodes_[idx(other)].tree != tree) continue;
    if (can_grow(tree, half ^ 1)) activate(other);
    if (nodes_[idx(other)].parent == (half ^ 1)) set_free(other);
  }
  nodes_[idx(node)].tree = Tree::free;
}

// Nodes that the source reaches through what has room, or that reach the sink.
std::vector<std::uint8_t> MinCut::reached_from(Tree root) const {
  const bool from_source = root == Tree::source;
  std::vector<std::uint8_t> reached(nodes_.size(), 0);
  std::vector<int> stack;
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    if (from_source ? nodes_[n].cost <= 0 : nodes_[n].cost >= 0) continue;
    reached[n] = 1;
    stack.push_back(static_cast<int>(n));
  }
  while (!stack.empty()) {
    const int node = stack.back();
    stack.pop_back();
    for (int half = nodes_[idx(node)].first; half != none; half = halves_[idx(half)].next) {
      const int other = halves_[idx(half)].head;
      if (reached[idx(other)] || halves_[idx(from_source ? half : half ^ 1)].room == 0) continue;
      reached[idx(other)] = 1;
      stack.push_back(other);
    }
  }
  return reached;
}

std::vector<std::uint8_t> MinCut::smallest() const { return reached_from(Tree::source); }

std::vector<std::uint8_t> MinCut::largest() const {
  std::vector<std::uint8_t> chosen = reached_from(Tree::sink);
  for (std::uint8_t& is_chosen : chosen) is_chosen = !is_chosen;
  return chosen;
}

}  // namespace illustrate
