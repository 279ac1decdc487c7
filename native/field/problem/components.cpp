#include "field/problem/components.h"

namespace illustrate {

Ragged<int> connected_vertices(const FieldGraph& graph) {
  return connected_parts(graph.size(), [&](int vertex, const auto& take) {
    for (const Link& link : graph.links[idx(vertex)]) take(link.vertex);
  });
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
