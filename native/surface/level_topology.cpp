#include "surface/level_topology.h"

#include <algorithm>
#include <numeric>

#include "surface/base_edges.h"

namespace illustrate {
namespace {

namespace Far = OpenSubdiv::Far;
using Far::TopologyLevel;

template <class T>
T& at(std::vector<T>& values, int i) {
  return values[static_cast<std::size_t>(i)];
}
template <class T>
const T& at(const std::vector<T>& values, int i) {
  return values[static_cast<std::size_t>(i)];
}

// Copies of a vertex that seams end in share the place of the first of them.
std::vector<int> seam_places(const SoundMesh& mesh) {
  if (mesh.seams.empty()) return {};
  const int sources =
      1 + *std::max_element(mesh.source_vertices.begin(), mesh.source_vertices.end());
  std::vector<std::uint8_t> split(static_cast<std::size_t>(sources), 0);
  for (const Edge& e : mesh.seams) {
    for (const int v : e) at(split, at(mesh.source_vertices, v)) = 1;
  }
  std::vector<int> first(split.size(), none), places(mesh.positions.size());
  std::iota(places.begin(), places.end(), 0);
  for (int v = 0; v < static_cast<int>(places.size()); ++v) {
    const int source = at(mesh.source_vertices, v);
    if (source == none || !at(split, source)) continue;
    int& place = at(first, source);
    if (place == none) place = v;
    at(places, v) = place;
  }
  return places;
}

// An edge by the places of its ends, and what becomes of its middle.
struct PlacedEdge {
  Edge places;
  int child;
  bool is_seam;
  bool operator<(const PlacedEdge& e) const {
    return places != e.places ? places < e.places : child < e.child;
  }
};

// Middles of edges that a seam joins share the place of the first of them.
void place_seam_middles(const RefinedMesh& parent, const TopologyLevel& level,
                        std::vector<int>& places) {
  std::vector<std::uint8_t> shared(parent.places.size(), 0);
  for (int v = 0; v < level.GetNumVertices(); ++v) {
    const int place = at(parent.places, v);
    if (place != v) at(shared, place) = at(shared, v) = 1;
  }
  std::vector<PlacedEdge> edges;
  for (int e = 0; e < level.GetNumEdges(); ++e) {
    const auto ends = level.GetEdgeVertices(e);
    if (!at(shared, ends[0]) || !at(shared, ends[1])) continue;
    const int a = at(parent.places, ends[0]), b = at(parent.places, ends[1]);
    edges.push_back({{std::min(a, b), std::max(a, b)},
                     level.GetEdgeChildVertex(e),
                     at(parent.edge_kinds, e) == EdgeKind::seam});
  }
  std::sort(edges.begin(), edges.end());
  for (auto from = edges.begin(), to = from; from != edges.end(); from = to) {
    while (to != edges.end() && to->places == from->places) ++to;
    if (std::none_of(from, to, [](const PlacedEdge& e) { return e.is_seam; })) continue;
    for (auto e = from; e != to; ++e) at(places, e->child) = from->child;
  }
}

std::vector<int> child_places(const RefinedMesh& parent, const TopologyLevel& level, int vertices) {
  if (parent.places.empty()) return {};
  std::vector<int> places(static_cast<std::size_t>(vertices));
  std::iota(places.begin(), places.end(), 0);
  for (int v = 0; v < level.GetNumVertices(); ++v) {
    at(places, level.GetVertexChildVertex(v)) = level.GetVertexChildVertex(at(parent.places, v));
  }
  place_seam_middles(parent, level, places);
  return places;
}

std::vector<EdgeKind> child_edge_kinds(const RefinedMesh& parent, const TopologyLevel& level,
                                       int edges) {
  std::vector<EdgeKind> kinds(static_cast<std::size_t>(edges), EdgeKind::smooth);
  for (int e = 0; e < level.GetNumEdges(); ++e) {
    if (at(parent.edge_kinds, e) == EdgeKind::smooth) continue;
    for (const int child : level.GetEdgeChildEdges(e)) at(kinds, child) = at(parent.edge_kinds, e);
  }
  return kinds;
}

// Child k < 3 of a triangle, and of a quad any child, is the part at corner k.
FaceDomain child_domain(const FaceDomain& parent, int size, int child) {
  static const std::array<Vec2, 4> quad{Vec2(0, 0), Vec2(.5, 0), Vec2(.5, .5), Vec2(0, .5)};
  static const std::array<Vec2, 4> triangle{Vec2(0, 0), Vec2(.5, 0), Vec2(0, .5), Vec2(.5, .5)};
  const auto k = static_cast<std::size_t>(child);
  const Vec2& offset = size == 3 ? triangle[k] : quad[k];
  const double scale = size == 3 && child == 3 ? -.5 : .5;
  return {parent.ptex_face, parent.origin + parent.size * offset, parent.size * scale};
}

void inherit_faces(const RefinedMesh& parent, const TopologyLevel& level, RefinedMesh& child) {
  for (int f = 0; f < level.GetNumFaces(); ++f) {
    const int size = level.GetFaceVertices(f).size();
    const auto children = level.GetFaceChildFaces(f);
    const bool whole = size == 4 || parent.triangles_are_patches;
    const FaceDomain& domain = at(parent.domains, f);
    for (int k = 0; k < children.size(); ++k) {
      at(child.base_faces, children[k]) = at(parent.base_faces, f);
      at(child.domains, children[k]) =
          whole ? child_domain(domain, size, k) : FaceDomain{domain.ptex_face + k, Vec2::Zero(), 1};
    }
  }
}

void inherit_twin_vertices(const RefinedMesh& parent, const TopologyLevel& level,
                           RefinedMesh& child) {
  const auto twin = [&](int v) { return at(parent.twin_vertices, v); };
  for (int v = 0; v < level.GetNumVertices(); ++v) {
    if (twin(v) == none) continue;
    at(child.twin_vertices, level.GetVertexChildVertex(v)) = level.GetVertexChildVertex(twin(v));
  }
  for (int e = 0; e < level.GetNumEdges(); ++e) {
    const auto ends = level.GetEdgeVertices(e);
    if (twin(ends[0]) == none || twin(ends[1]) == none) continue;
    const int other = level.FindEdge(twin(ends[0]), twin(ends[1]));
    at(child.twin_vertices, level.GetEdgeChildVertex(e)) = level.GetEdgeChildVertex(other);
  }
  for (int f = 0; f < level.GetNumFaces() && !parent.triangles_are_patches; ++f) {
    const int other = at(parent.twin_faces, f);
    if (other == none) continue;
    at(child.twin_vertices, level.GetFaceChildVertex(f)) = level.GetFaceChildVertex(other);
  }
}

void inherit_twin_faces(const RefinedMesh& parent, const TopologyLevel& level, RefinedMesh& child) {
  for (int f = 0; f < level.GetNumFaces(); ++f) {
    const int other = at(parent.twin_faces, f);
    if (other == none) continue;
    const auto vertices = level.GetFaceVertices(f), other_vertices = level.GetFaceVertices(other);
    const auto children = level.GetFaceChildFaces(f), others = level.GetFaceChildFaces(other);
    for (int k = 0; k < vertices.size(); ++k) {
      const int j = other_vertices.FindIndex(at(parent.twin_vertices, vertices[k]));
      at(child.twin_faces, children[k]) = others[j];
    }
    if (children.size() > vertices.size()) at(child.twin_faces, children[3]) = others[3];
  }
}

}  // namespace

std::vector<int> ptex_faces(const SoundMesh& mesh, Scheme scheme) {
  std::vector<int> counts = mesh.face_sizes;
  const int regular_size = scheme == Scheme::loop ? 3 : 4;
  std::replace(counts.begin(), counts.end(), regular_size, 1);
  return face_offsets(counts);
}

RefinedMesh base_level(const SoundMesh& mesh, const Far::TopologyRefiner& refiner, Scheme scheme) {
  RefinedMesh result;
  result.triangles_are_patches = scheme == Scheme::loop;
  const TopologyLevel& level = refiner.GetLevel(0);
  const BaseEdgeKinds kinds(mesh);
  for (int e = 0; e < level.GetNumEdges(); ++e) {
    const auto ends = level.GetEdgeVertices(e), faces = level.GetEdgeFaces(e);
    const int face_a = !faces.empty() ? faces[0] : none,
              face_b = faces.size() > 1 ? faces[1] : none;
    result.edge_kinds.push_back(kinds.kind(ends[0], ends[1], face_a, face_b));
  }
  const std::vector<int> ptex = ptex_faces(mesh, scheme);
  for (int f = 0; f < level.GetNumFaces(); ++f) {
    result.base_faces.push_back(f);
    result.domains.push_back({at(ptex, f), Vec2::Zero(), 1});
  }
  result.places = seam_places(mesh);
  if (has_double_cover(mesh)) {
    result.twin_faces = mesh.twin_faces;
    result.twin_vertices = mesh.twin_vertices;
  }
  return result;
}

RefinedMesh next_level(const RefinedMesh& parent, const Far::TopologyRefiner& refiner,
                       int level_number) {
  const TopologyLevel& level = refiner.GetLevel(level_number - 1);
  const TopologyLevel& next = refiner.GetLevel(level_number);
  RefinedMesh child;
  child.triangles_are_patches = parent.triangles_are_patches;
  child.edge_kinds = child_edge_kinds(parent, level, next.GetNumEdges());
  child.base_faces.resize(static_cast<std::size_t>(next.GetNumFaces()));
  child.domains.resize(child.base_faces.size());
  inherit_faces(parent, level, child);
  child.places = child_places(parent, level, next.GetNumVertices());
  if (!parent.twin_faces.empty()) {
    child.twin_faces.assign(child.base_faces.size(), none);
    child.twin_vertices.assign(static_cast<std::size_t>(next.GetNumVertices()), none);
    inherit_twin_vertices(parent, level, child);
    inherit_twin_faces(parent, level, child);
  }
  return child;
}

void read_corners(RefinedMesh& mesh, const TopologyLevel& level) {
  for (int f = 0; f < level.GetNumFaces(); ++f) {
    const auto vertices = level.GetFaceVertices(f), edges = level.GetFaceEdges(f);
    mesh.corner_vertices.insert(mesh.corner_vertices.end(), vertices.begin(), vertices.end());
    mesh.corner_edges.insert(mesh.corner_edges.end(), edges.begin(), edges.end());
    mesh.face_offsets.push_back(static_cast<int>(mesh.corner_vertices.size()));
  }
  connect(mesh);
  for (int v = 0; v < level.GetNumVertices(); ++v) {
    mesh.sharp_vertices.push_back(level.IsVertexInfSharp(v));
    mesh.semi_sharp.push_back(level.IsVertexSemiSharp(v));
  }
  for (int e = 0; e < level.GetNumEdges(); ++e) {
    if (!level.IsEdgeSemiSharp(e)) continue;
    for (const int v : level.GetEdgeVertices(e)) at(mesh.semi_sharp, v) = 1;
  }
}

}  // namespace illustrate
