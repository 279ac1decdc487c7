#include "field/problem/energy.h"

#include "core/parallel.h"

namespace illustrate {
namespace {

// The edge seen from its other end: z_to = transport' z_from, mirrored the same way.
CrossNumber reversed(const FieldEdge& edge) { return mirrored_if(!edge.mirrored, edge.transport); }

// Calls visit(vertex, other, transport, mirrored) for both ends of all edges, in order.
template <class Visit>
void for_each_end(const std::vector<FieldEdge>& edges, const Progress& progress,
                  const Visit& visit) {
  parallel_for(edges.size(), 1, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e) {
      const FieldEdge& edge = edges[e];
      visit(idx(edge.from), idx(edge.to), edge.transport, edge.mirrored);
      visit(idx(edge.to), idx(edge.from), reversed(edge), edge.mirrored);
    }
  });
}

// Numbers the free vertices; the others get `none`.
std::vector<int> number_free(const std::vector<std::uint8_t>& held,
                             std::vector<int>& free_vertices) {
  std::vector<int> number(held.size(), none);
  free_vertices.clear();
  for (std::size_t i = 0; i < held.size(); ++i) {
    if (held[i]) continue;
    number[i] = static_cast<int>(free_vertices.size());
    free_vertices.push_back(static_cast<int>(i));
  }
  return number;
}

void count_links(const std::vector<FieldEdge>& edges, const std::vector<int>& number,
                 const Progress& progress, FieldGraph& graph) {
  graph.links.offsets.assign(graph.size() + 1, 0);
  for_each_end(edges, progress, [&](std::size_t i, std::size_t j, const CrossNumber&, bool) {
    if (number[i] != none && number[j] != none) ++graph.links.offsets[idx(number[i]) + 1];
  });
  for (std::size_t i = 0; i < graph.size(); ++i) {
    graph.links.offsets[i + 1] += graph.links.offsets[i];
  }
  graph.links.values.resize(idx(graph.links.offsets.back()));
}

}  // namespace

FieldGraph free_graph(const std::vector<FieldEdge>& edges, const CrossNumbers& pulls,
                      const std::vector<std::uint8_t>& held, const CrossNumbers& z,
                      std::vector<int>& free_vertices, const Progress& progress) {
  const std::vector<int> number = number_free(held, free_vertices);
  FieldGraph graph;
  for (const int vertex : free_vertices) {
    graph.pulls.push_back(pulls[idx(vertex)]);
    graph.weights.push_back(std::sqrt(std::norm(graph.pulls.back())));
  }
  count_links(edges, number, progress.part(0, 0.3), graph);
  std::vector<int> next(graph.links.offsets.begin(), graph.links.offsets.end() - 1);
  const auto add = [&](std::size_t i, std::size_t j, const CrossNumber& transport, bool mirrored) {
    if (number[i] == none) return;
    const std::size_t vertex = idx(number[i]);
    graph.weights[vertex] += std::sqrt(std::norm(transport));
    if (number[j] == none) {
      graph.pulls[vertex] += product(transport, mirrored_if(mirrored, z[j]));
    } else {
      graph.links.values[idx(next[vertex]++)] = {transport, number[j], mirrored};
    }
  };
  for_each_end(edges, progress.part(0.3, 1), add);
  return graph;
}

double energy(const FieldGraph& graph, const double* u, double* gradient, int threads) {
  const std::size_t n = graph.size();
  CrossNumbers z(n);
  std::vector<double> terms(n);
  parallel_for(n, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) z[i] = {std::cos(u[i]), std::sin(u[i])};
  });
  parallel_for(n, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const CrossNumber against = product(std::conj(z[i]), graph.attraction(i, z));
      const CrossNumber pulled = product(std::conj(z[i]), graph.pulls[i]);
      terms[i] = -0.5 * (against.real() + pulled.real());  // every edge is met at both of its ends
      if (gradient) gradient[i] = -against.imag();
    }
  });
  // In the order of the vertices, not of the threads: the same bits for any number of them.
  double sum = 0;
  for (const double term : terms) sum += term;
  return sum;
}

double edge_energy(const FieldEdge& edge, const CrossNumbers& z) {
  const CrossNumber carried = product(edge.transport, mirrored_if(edge.mirrored, z[idx(edge.to)]));
  return -product(std::conj(z[idx(edge.from)]), carried).real();
}

double energy(const std::vector<FieldEdge>& edges, const CrossNumbers& z) {
  double sum = 0;
  for (const FieldEdge& edge : edges) sum += edge_energy(edge, z);
  return sum;
}

}  // namespace illustrate
