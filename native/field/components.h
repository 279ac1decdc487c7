// A graph's connected parts, each as a graph of its own.
#pragma once

#include "field/energy.h"

namespace illustrate {

// The vertices of each part, ascending; parts in the order of their first vertices.
Ragged<int> connected_vertices(const FieldGraph& graph);

// The part that has these vertices, which keep their order. numbers: scratch of the graph's size,
// of which only the places of these vertices are used: parts may share it.
FieldGraph part_of(const FieldGraph& graph, Span<const int> vertices, std::vector<int>& numbers);

}  // namespace illustrate
