#include "field/components.h"

#include <algorithm>

namespace illustrate {
namespace {

// Appends to `vertices` what links lead to from its last vertex, which is new.
void collect(const FieldGraph& graph, std::vector<std::uint8_t>& is_met,
             std::vector<int>& vertices) {
  for (std::size_t next = vertices.size() - 1; next < vertices.size(); ++next) {
    for (const Link& link : graph.links[idx(vertices[next])]) {
      if (is_met[idx(link.vertex)]) continue;
      is_met[idx(link.vertex)] = 1;
      vertices.push_back(link.vertex);
    }
  }
}

}  // namespace

Ragged<int> connected_vertices(const FieldGraph& graph) {
  Ragged<int> parts;
  std::vector<std::uint8_t> is_met(graph.size(), 0);
  for (std::size_t i = 0; i < graph.size(); ++i) {
    if (is_met[i]) continue;
    is_met[i] = 1;
    parts.push(static_cast<int>(i));
    collect(graph, is_met, parts.values);
    std::sort(parts.values.begin() + parts.offsets.back(), parts.values.end());
    parts.close_list();
  }
  return parts;
}

FieldGraph part_of(const FieldGraph& graph, Span<const int> vertices, std::vector<int>& numbers) {
  for (std::size_t i = 0; i < vertices.size(); ++i) numbers[idx(vertices[i])] = static_cast<int>(i);
  FieldGraph part;
  for (const int vertex : vertices) {
    part.pulls.push_back(graph.pulls[idx(vertex)]);
    part.weights.push_back(graph.weights[idx(vertex)]);
    for (const Link& link : graph.links[idx(vertex)]) {
      part.links.push({link.transport, numbers[idx(link.vertex)], link.mirrored});
    }
    part.links.close_list();
  }
  return part;
}

}  // namespace illustrate
