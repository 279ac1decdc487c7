#include "surface/refined_mesh.h"

#include <algorithm>
#include <numeric>

#include "surface/base_edges.h"

namespace illustrate {
namespace {

// Corners by the smaller vertex of their edge, then the larger, then their own number.
struct HalfEdge {
  int larger;
  int corner;
  bool operator<(const HalfEdge& other) const {
    return larger != other.larger ? larger < other.larger : corner < other.corner;
  }
};

void number_edges(RefinedMesh& mesh) {
  std::vector<int> offsets(mesh.points.size() + 1, 0);
  const int corners = static_cast<int>(mesh.corner_vertices.size());
  const auto ends = [&](int c) { return std::minmax({mesh.vertex(c), mesh.vertex(mesh.next(c))}); };
  for (int c = 0; c < corners; ++c) ++offsets[static_cast<std::size_t>(ends(c).first) + 1];
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
  std::vector<int> cursor = offsets;
  std::vector<HalfEdge> sorted(mesh.corner_vertices.size());
  for (int c = 0; c < corners; ++c) {
    const auto [smaller, larger] = ends(c);
    sorted[static_cast<std::size_t>(cursor[static_cast<std::size_t>(smaller)]++)] = {larger, c};
  }
  mesh.corner_edges.resize(mesh.corner_vertices.size());
  int edge = none;
  for (std::size_t v = 0; v + 1 < offsets.size(); ++v) {
    const auto begin = sorted.begin() + offsets[v], end = sorted.begin() + offsets[v + 1];
    std::sort(begin, end);
    for (auto h = begin; h != end; ++h) {
      if (h == begin || h->larger != (h - 1)->larger) ++edge;
      mesh.corner_edges[static_cast<std::size_t>(h->corner)] = edge;
    }
  }
  mesh.edge_kinds.assign(static_cast<std::size_t>(edge) + 1, EdgeKind::smooth);
}

void classify_edges(const SoundMesh& base, RefinedMesh& mesh) {
  const BaseEdgeKinds kinds(base);
  for (int c = 0; c < static_cast<int>(mesh.mates.size()); ++c) {
    const int mate = mesh.mate(c);
    if (mate != none && mate < c) continue;
    mesh.edge_kinds[static_cast<std::size_t>(mesh.corner_edges[static_cast<std::size_t>(c)])] =
        kinds.kind(mesh.vertex(c), mesh.vertex(mesh.next(c)), mesh.face(c),
                   mate == none ? none : mesh.face(mate));
  }
}

}  // namespace

int twin_corner(const RefinedMesh& mesh, int corner) {
  const int face = mesh.twin_faces[static_cast<std::size_t>(mesh.face(corner))];
  if (face == none) return none;
  const int vertex = mesh.twin_vertices[static_cast<std::size_t>(mesh.vertex(corner))];
  for (int c = mesh.first(face); c < mesh.first(face + 1); ++c) {
    if (mesh.vertex(c) == vertex) return c;
  }
  return none;
}

BasePlace base_place(const RefinedMesh& mesh, int corner) {
  if (mesh.domains.empty()) return {};
  const int face = mesh.face(corner);
  const int k = corner - mesh.first(face);
  const FaceDomain& domain = mesh.domains[static_cast<std::size_t>(face)];
  if (mesh.face_size(face) > 4) return {domain.ptex_face + k, Vec2::Zero()};
  if (mesh.face_size(face) == 3 && !mesh.triangles_are_patches) {
    return {domain.ptex_face + k, Vec2::Zero()};
  }
  static const std::array<Vec2, 4> quad{Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)};
  static const std::array<Vec2, 3> triangle{Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)};
  const Vec2& unit = mesh.face_size(face) == 3 ? triangle[static_cast<std::size_t>(k)]
                                               : quad[static_cast<std::size_t>(k)];
  return {domain.ptex_face, domain.origin + domain.size * unit};
}

void connect(RefinedMesh& mesh) {
  mesh.corner_faces.resize(mesh.corner_vertices.size());
  for (int f = 0; f < static_cast<int>(mesh.face_count()); ++f) {
    std::fill(mesh.corner_faces.begin() + mesh.first(f),
              mesh.corner_faces.begin() + mesh.first(f + 1), f);
  }
  if (mesh.corner_edges.empty()) number_edges(mesh);
  mesh.mates.assign(mesh.corner_vertices.size(), none);
  std::vector<int> waiting(mesh.edge_kinds.size(), none);
  for (int c = 0; c < static_cast<int>(mesh.mates.size()); ++c) {
    int& other = waiting[static_cast<std::size_t>(mesh.corner_edges[static_cast<std::size_t>(c)])];
    if (other == none) {
      other = c;
    } else {
      mesh.mates[static_cast<std::size_t>(c)] = other;
      mesh.mates[static_cast<std::size_t>(other)] = c;
    }
  }
}

RefinedMesh polygonal_mesh(const SoundMesh& base) {
  RefinedMesh mesh;
  mesh.points = base.positions;
  mesh.face_offsets = face_offsets(base.face_sizes);
  mesh.corner_vertices = base.corner_vertices;
  connect(mesh);
  classify_edges(base, mesh);
  mesh.sharp_vertices.assign(mesh.points.size(), 1);
  mesh.semi_sharp.assign(mesh.points.size(), 0);
  mesh.base_faces.resize(mesh.face_count());
  std::iota(mesh.base_faces.begin(), mesh.base_faces.end(), 0);
  mesh.places = base.source_vertices;
  if (has_double_cover(base)) {
    mesh.twin_faces = base.twin_faces;
    mesh.twin_vertices = base.twin_vertices;
  }
  return mesh;
}

}  // namespace illustrate
