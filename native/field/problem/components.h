// A graph's connected parts, each as a graph of its own.
#pragma once

#include <algorithm>

#include "field/problem/energy.h"

namespace illustrate {

// The nodes of each part of a graph of `count` nodes, ascending; parts in the order of their first
// nodes. neighbours(i, take) calls take(j) for all that node i is linked to.
template <class Neighbours>
Ragged<int> connected_parts(std::size_t count, const Neighbours& neighbours) {
  Ragged<int> parts;
  std::vector<std::uint8_t> is_met(count, 0);
  const auto take = [&](int node) {
    if (is_met[idx(node)]) return;
    is_met[idx(node)] = 1;
    parts.push(node);
  };
  for (std::size_t first = 0; first < count; ++first) {
    if (is_met[first]) continue;
    take(static_cast<int>(first));
    for (std::size_t i = idx(parts.offsets.back()); i < parts.values.size(); ++i) {
      neighbours(parts.values[i], take);
    }
    std::sort(parts.values.begin() + parts.offsets.back(), parts.values.end());
    parts.close_list();
  }
  return parts;
}

// Of vertices.
Ragged<int> connected_vertices(const FieldGraph& graph);

// The part that has these vertices, which keep their order. numbers: scratch of the graph's size,
// of which only the places of these vertices are used: parts may share it.
FieldGraph part_of(const FieldGraph& graph, Span<const int> vertices, std::vector<int>& numbers);

}  // namespace illustrate
