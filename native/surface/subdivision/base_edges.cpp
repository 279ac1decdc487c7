#include "surface/subdivision/base_edges.h"

#include <algorithm>

namespace illustrate {
namespace {

std::vector<Edge> infinitely_sharp_edges(const SoundMesh& mesh) {
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < mesh.edge_vertices.size(); ++i) {
    if (mesh.edge_sharpness[i] >= infinitely_sharp) edges.push_back(mesh.edge_vertices[i]);
  }
  return edges;
}

}  // namespace

BaseEdgeKinds::BaseEdgeKinds(const SoundMesh& mesh)
    : mesh_(mesh),
      creases_(mesh.positions.size(), infinitely_sharp_edges(mesh)),
      marks_(mesh.positions.size(), mesh.marked_edges),
      seams_(mesh.positions.size(), mesh.seams) {}

EdgeKind BaseEdgeKinds::kind(int vertex_a, int vertex_b, int face_a, int face_b) const {
  if (face_b == none) {
    return seams_.find(vertex_a, vertex_b) == none ? EdgeKind::boundary : EdgeKind::seam;
  }
  if (creases_.find(vertex_a, vertex_b) != none) return EdgeKind::crease;
  if (marks_.find(vertex_a, vertex_b) != none) return EdgeKind::mark;
  const std::vector<int>& material = mesh_.face_materials;
  const bool differ = !material.empty() && material[idx(face_a)] != material[idx(face_b)];
  return differ ? EdgeKind::material : EdgeKind::smooth;
}

bool has_double_cover(const SoundMesh& mesh) {
  return std::any_of(mesh.twin_faces.begin(), mesh.twin_faces.end(),
                     [](int twin) { return twin != none; });
}

}  // namespace illustrate
