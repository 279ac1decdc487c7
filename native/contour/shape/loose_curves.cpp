#include "contour/shape/loose_curves.h"

#include <algorithm>

namespace illustrate {
namespace {

class LooseChainer {
 public:
  LooseChainer(const PolygonMesh& mesh, int object, CurveNetwork& network)
      : mesh_(mesh),
        object_(object),
        network_(network),
        edges_(sound_edges(mesh)),
        used_(edges_.size(), 0),
        nodes_(mesh.positions.size(), none) {
    find_edges_at_vertices();
  }

  void run() {
    find_nodes();
    for (int v = 0; v < static_cast<int>(nodes_.size()); ++v) {
      if (nodes_[idx(v)] == none) continue;
      for (const int e : at_[idx(v)])
        if (!used_[idx(e)]) follow(v, e);
    }
    for (int e = 0; e < static_cast<int>(edges_.size()); ++e)
      if (!used_[idx(e)]) follow(edges_[idx(e)][0], e);
  }

 private:
  static std::vector<Edge> sound_edges(const PolygonMesh& mesh) {
    std::vector<Edge> edges;
    for (const auto& [a, b] : mesh.loose_edges) {
      const Vec3 &p = mesh.positions[idx(a)], &q = mesh.positions[idx(b)];
      if (p.allFinite() && q.allFinite() && p != q)
        edges.push_back({std::min(a, b), std::max(a, b)});
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
  }

  void find_edges_at_vertices() {
    at_ = sorted_into<int>(nodes_.size(), [&](const auto& put) {
      for (std::size_t e = 0; e < edges_.size(); ++e)
        for (const int v : edges_[e]) put(v, static_cast<int>(e));
    });
  }

  void find_nodes() {
    std::vector<std::uint8_t> has_face(nodes_.size(), 0);
    for (const int v : mesh_.corner_vertices) has_face[idx(v)] = 1;
    for (std::size_t v = 0; v < nodes_.size(); ++v) {
      const std::size_t count = at_[v].size();
      if (count == 0 || (count == 2 && !has_face[v])) continue;
      const bool is_end = count == 1 && !has_face[v];
      nodes_[v] = static_cast<int>(network_.nodes.size());
      network_.nodes.push_back({is_end ? NodeKind::end : NodeKind::joint, mesh_.positions[v]});
    }
  }

  // From a vertex along an edge to the next node, or round to the vertex.
  void follow(int start, int edge) {
    int v = start;
    for (int e = edge; e != none; e = onward(v)) {
      used_[idx(e)] = 1;
      push(v);
      v = edges_[idx(e)][0] == v ? edges_[idx(e)][1] : edges_[idx(e)][0];
    }
    const bool is_closed = nodes_[idx(v)] == none;
    if (!is_closed) push(v);
    network_.points.close_list();
    Strand strand;
    strand.kind = Kind::loose;
    strand.object = object_;
    strand.start_node = nodes_[idx(start)];
    strand.end_node = nodes_[idx(v)];
    network_.strands.push_back(strand);
  }

  int onward(int v) const {
    if (nodes_[idx(v)] != none) return none;
    for (const int e : at_[idx(v)])
      if (!used_[idx(e)]) return e;
    return none;
  }

  void push(int v) { network_.points.push({mesh_.positions[idx(v)], {}}); }

  const PolygonMesh& mesh_;
  const int object_;
  CurveNetwork& network_;
  std::vector<Edge> edges_;
  std::vector<std::uint8_t> used_;  // (edges)
  std::vector<int> nodes_;          // (vertices) of the network, or none
  Ragged<int> at_;                  // (vertices) edges
};

}  // namespace

CurveNetwork loose_curves(const std::vector<std::shared_ptr<const PolygonMesh>>& meshes,
                          const std::vector<std::uint8_t>& wanted) {
  CurveNetwork network;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    if (wanted[i] && !meshes[i]->loose_edges.empty())
      LooseChainer(*meshes[i], static_cast<int>(i), network).run();
  }
  return network;
}

}  // namespace illustrate
