#include "field/families/signed_graph.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "core/types.h"
#include "field/problem/components.h"

namespace illustrate {
namespace {

std::vector<int> order_of(std::size_t count, SeededNumbers* shuffle) {
  std::vector<int> order(count);
  std::iota(order.begin(), order.end(), 0);
  if (!shuffle) return order;
  for (std::size_t i = count; i > 1; --i) {
    const double turn = (shuffle->uniform() + 1) / 2;  // in [0, 1)
    std::swap(order[i - 1], order[static_cast<std::size_t>(turn * static_cast<double>(i))]);
  }
  return order;
}

// Of equally strong ones the first.
const SignedLink* strongest_open_link(const SignedGraph& graph, const Labels& labels, int node,
                                      const std::vector<Membership>& members) {
  const SignedLink* best = nullptr;
  double best_strength = 0;
  for (const SignedLink& link : graph.links[idx(node)]) {
    const double agreement =
        labels.empty() ? 1 : link.weight * labels[idx(node)] * labels[idx(link.node)];
    const double strength = std::abs(link.weight);
    if (members[idx(link.node)].aggregate != none || !(agreement > 0) || strength <= best_strength)
      continue;
    best = &link;
    best_strength = strength;
  }
  return best;
}

// The nodes of each aggregate, the second `none` for a single one.
std::vector<std::array<int, 2>> match(const SignedGraph& graph, const Labels& labels,
                                      SeededNumbers* shuffle, std::vector<Membership>& members) {
  std::vector<std::array<int, 2>> pairs;
  members.assign(graph.size(), {none, 1});
  for (const int node : order_of(graph.size(), shuffle)) {
    if (members[idx(node)].aggregate != none) continue;
    const int aggregate = static_cast<int>(pairs.size());
    members[idx(node)].aggregate = aggregate;
    pairs.push_back({node, none});
    const SignedLink* link = strongest_open_link(graph, labels, node, members);
    if (!link) continue;
    members[idx(link->node)] = {aggregate, static_cast<std::int8_t>(link->weight > 0 ? 1 : -1)};
    pairs.back()[1] = link->node;
  }
  return pairs;
}

}  // namespace

double cost(const SignedGraph& graph, const Labels& labels) {
  double sum = 0;
  for (std::size_t i = 0; i < graph.size(); ++i) {
    double ties = 0;
    for (const SignedLink& link : graph.links[i]) ties += link.weight * labels[idx(link.node)];
    sum -= (ties / 2 + graph.pulls[i]) * labels[i];
  }
  return sum;
}

SignedGraph coarsen(const SignedGraph& fine, const Labels& labels, SeededNumbers* shuffle,
                    std::vector<Membership>& members) {
  const std::vector<std::array<int, 2>> pairs = match(fine, labels, shuffle, members);
  SignedGraph coarse;
  coarse.pulls.assign(pairs.size(), 0);
  coarse.links.values.reserve(fine.links.values.size() * 2 / 3);
  // Of a link to there, in the list being built: links come in the order in which fine ones first
  // lead there, which no hash decides.
  std::vector<int> slots(pairs.size(), none);
  std::vector<SignedLink>& all = coarse.links.values;
  for (std::size_t a = 0; a < pairs.size(); ++a) {
    const std::size_t first = all.size();
    for (const int node : pairs[a]) {
      if (node == none) continue;
      const double sign = members[idx(node)].sign;
      coarse.pulls[a] += sign * fine.pulls[idx(node)];
      for (const SignedLink& link : fine.links[idx(node)]) {
        const Membership& there = members[idx(link.node)];
        if (there.aggregate == static_cast<int>(a)) continue;
        int& slot = slots[idx(there.aggregate)];
        if (slot == none) {
          slot = static_cast<int>(all.size());
          all.push_back({there.aggregate, 0});
        }
        all[idx(slot)].weight += sign * there.sign * link.weight;
      }
    }
    for (std::size_t k = first; k < all.size(); ++k) slots[idx(all[k].node)] = none;
    coarse.links.close_list();
  }
  return coarse;
}

Labels restricted(const Labels& labels, const std::vector<Membership>& members,
                  std::size_t aggregates) {
  Labels result(aggregates, 1);
  for (std::size_t i = 0; i < members.size(); ++i) {
    result[idx(members[i].aggregate)] = static_cast<std::int8_t>(members[i].sign * labels[i]);
  }
  return result;
}

Labels prolonged(const Labels& labels, const std::vector<Membership>& members) {
  Labels result;
  result.reserve(members.size());
  for (const Membership& member : members) {
    result.push_back(static_cast<std::int8_t>(member.sign * labels[idx(member.aggregate)]));
  }
  return result;
}

Ragged<int> connected_nodes(const SignedGraph& graph) {
  return connected_parts(graph.size(), [&](int node, const auto& take) {
    for (const SignedLink& link : graph.links[idx(node)]) take(link.node);
  });
}

}  // namespace illustrate
