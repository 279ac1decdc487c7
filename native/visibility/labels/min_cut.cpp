#include "visibility/labels/min_cut.h"

#include <algorithm>
#include <limits>

namespace illustrate {

MinCut::MinCut(int nodes) : nodes_(idx(nodes) + 1), trees_(idx(nodes), Tree::free) {}

int MinCut::add_edge(int from, int to, std::int64_t cost) {
  edges_.push_back({from, to, cost});
  return static_cast<int>(edges_.size()) - 1;
}

// The search goes from node to node over all half-edges of each: side by side they take a fifth
// less time.
void MinCut::lay_out_edges() {
  if (edges_.empty()) return;
  for (const Edge& edge : edges_) ++nodes_[idx(edge.from)].first, ++nodes_[idx(edge.to)].first;
  int end = 0;
  for (Node& node : nodes_) node.first = end += node.first;
  halves_.resize(2 * edges_.size());
  for (const Edge& edge : edges_) {
    const int half = --nodes_[idx(edge.from)].first, other = --nodes_[idx(edge.to)].first;
    halves_[idx(half)] = {edge.to, other, edge.cost};
    halves_[idx(other)] = {edge.from, half, 0};
    half_of_edge_.push_back(half);
  }
  edges_ = {};
}

void MinCut::add_cost(int node, std::int64_t cost) { change_room(node, -cost); }

// Flow that has no room any more stays with the nodes at both ends.
void MinCut::set_edge(int edge, std::int64_t cost) {
  lay_out_edges();
  const int half = half_of_edge_[idx(edge)];
  Half& ahead = halves_[idx(half)];
  Half& back = halves_[idx(ahead.other)];
  const bool had_room = ahead.room > 0, had_flow = back.room > 0;
  const std::int64_t flow = std::min(back.room, cost), excess = back.room - flow;
  ahead.room = cost - flow;
  back.room = flow;
  mind_room(half, had_room);
  mind_room(ahead.other, had_flow);
  if (excess == 0) return;
  change_room(back.head, excess);
  change_room(ahead.head, -excess);
}

// Trees do not grow over a half-edge without room, and may grow over one that has got some.
void MinCut::mind_room(int half, bool had_room) {
  const int from = tail(half), to = halves_[idx(half)].head;
  if (halves_[idx(half)].room > 0) {
    if (had_room) return;
    if (tree(from) == Tree::source) activate(from);
    if (tree(to) == Tree::sink) activate(to);
    return;
  }
  if (tree(to) == Tree::source && nodes_[idx(to)].parent == other(half)) set_free(to);
  if (tree(from) == Tree::sink && nodes_[idx(from)].parent == half) set_free(from);
}

void MinCut::change_room(int node, std::int64_t by) {
  Node& changed = nodes_[idx(node)];
  changed.room += by;
  if (changed.room != 0) {
    plant(node);
  } else if (changed.parent == at_terminal) {
    set_free(node);
  }
}

void MinCut::activate(int node) {
  if (nodes_[idx(node)].is_active) return;
  nodes_[idx(node)].is_active = true;
  active_.push_back(node);
}

// A node with room to a terminal is the child of that terminal; what was below it in the tree of
// the other one has to find another parent.
void MinCut::plant(int node) {
  const Tree wanted = nodes_[idx(node)].room > 0 ? Tree::source : Tree::sink;
  if (tree(node) != wanted) {
    for (int half = nodes_[idx(node)].first; half != end_of(node); ++half) {
      const int next = halves_[idx(half)].head;
      if (tree(next) == wanted || tree(next) == Tree::free) continue;
      if (nodes_[idx(next)].parent == other(half)) set_free(next);
      activate(next);
    }
    tree(node) = wanted;
    activate(node);
  }
  nodes_[idx(node)].parent = at_terminal;
  nodes_[idx(node)].time = time_;
  nodes_[idx(node)].distance = 1;
}

void MinCut::solve() {
  lay_out_edges();
  ++time_;
  adopt_orphans();
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
  const Tree own = tree(node);
  for (int half = nodes_[idx(node)].first; half != end_of(node); ++half) {
    if (!can_grow(own, half)) continue;
    Tree& of_next = tree(halves_[idx(half)].head);
    Node& next = nodes_[idx(halves_[idx(half)].head)];
    if (of_next == Tree::free) {
      of_next = own;
      next.parent = other(half);
      next.time = nodes_[idx(node)].time;
      next.distance = nodes_[idx(node)].distance + 1;
      activate(halves_[idx(half)].head);
    } else if (of_next != own) {
      return own == Tree::source ? half : other(half);
    } else if (next.time <= nodes_[idx(node)].time &&
               next.distance > nodes_[idx(node)].distance + 1) {
      next.parent = other(half);  // a shorter way to the terminal
      next.time = nodes_[idx(node)].time;
      next.distance = nodes_[idx(node)].distance + 1;
    }
  }
  return none;
}

// What may flow between a node and the terminal of its tree.
std::int64_t MinCut::bottleneck(int node) const {
  const Tree own = trees_[idx(node)];
  std::int64_t least = std::numeric_limits<std::int64_t>::max();
  for (int n = node;;) {
    const int up = nodes_[idx(n)].parent;
    if (up == at_terminal) return std::min(least, std::abs(nodes_[idx(n)].room));
    least = std::min(least, halves_[idx(own == Tree::source ? other(up) : up)].room);
    n = halves_[idx(up)].head;
  }
}

void MinCut::push(int node, std::int64_t flow) {
  const Tree own = tree(node);
  for (int n = node;;) {
    const int up = nodes_[idx(n)].parent;
    if (up == at_terminal) {
      nodes_[idx(n)].room -= own == Tree::source ? flow : -flow;
      if (nodes_[idx(n)].room == 0) set_free(n);
      return;
    }
    const int next = halves_[idx(up)].head;
    const int filled = own == Tree::source ? other(up) : up;
    halves_[idx(filled)].room -= flow;
    halves_[idx(other(filled))].room += flow;
    if (halves_[idx(filled)].room == 0) set_free(n);
    n = next;
  }
}

void MinCut::augment(int bridge) {
  const int from = tail(bridge), to = halves_[idx(bridge)].head;
  const std::int64_t flow = std::min({halves_[idx(bridge)].room, bottleneck(from), bottleneck(to)});
  halves_[idx(bridge)].room -= flow;
  halves_[idx(other(bridge))].room += flow;
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
    if (nodes_[idx(node)].parent == orphan) adopt(node);
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
  const Tree own = tree(node);
  int best = none, best_distance = std::numeric_limits<int>::max();
  for (int half = nodes_[idx(node)].first; half != end_of(node); ++half) {
    const int next = halves_[idx(half)].head;
    if (tree(next) != own || !can_grow(own, other(half))) continue;
    const int distance = distance_to_terminal(next);
    if (distance >= 0 && distance < best_distance) best = half, best_distance = distance;
  }
  nodes_[idx(node)].parent = best;
  if (best != none) {
    nodes_[idx(node)].time = time_;
    nodes_[idx(node)].distance = best_distance + 1;
    return;
  }
  for (int half = nodes_[idx(node)].first; half != end_of(node); ++half) {
    const int next = halves_[idx(half)].head;
    if (tree(next) != own) continue;
    if (can_grow(own, other(half))) activate(next);
    if (nodes_[idx(next)].parent == other(half)) set_free(next);
  }
  tree(node) = Tree::free;
}

// Once solved, a tree has all nodes that its terminal reaches, or that reach it, through what has
// room.
std::vector<std::uint8_t> MinCut::mask(Tree of, bool chosen) const {
  std::vector<std::uint8_t> is_chosen(trees_.size());
  std::transform(trees_.begin(), trees_.end(), is_chosen.begin(),
                 [&](Tree tree) { return static_cast<std::uint8_t>((tree == of) == chosen); });
  return is_chosen;
}

}  // namespace illustrate
