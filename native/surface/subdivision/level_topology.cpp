#include "surface/subdivision/level_topology.h"

#include <algorithm>
#include <numeric>

#include "core/parallel.h"
#include "surface/subdivision/base_edges.h"
#include "surface/subdivision/child_corners.h"
#include "surface/subdivision/sharpness.h"

namespace illustrate {
namespace {

namespace Far = OpenSubdiv::Far;
using Far::TopologyLevel;

template <class T>
T& at(std::vector<T>& values, int i) {
  return values[idx(i)];
}
template <class T>
const T& at(const std::vector<T>& values, int i) {
  return values[idx(i)];
}

// Copies of a vertex that seams end in share the place of the first of them.
std::vector<int> seam_places(const SoundMesh& mesh) {
  if (mesh.seams.empty()) return {};
  const int sources =
      1 + *std::max_element(mesh.source_vertices.begin(), mesh.source_vertices.end());
  std::vector<std::uint8_t> split(idx(sources), 0);
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
    // The lowest child first: its place becomes that of all.
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
  for (int c = 0; c < static_cast<int>(parent.corner_count()); ++c) {
    const int from = parent.vertex(c), to = parent.vertex(parent.next(c)), f = parent.face(c);
    if (!at(shared, from) || !at(shared, to)) continue;
    const int a = at(parent.places, from), b = at(parent.places, to);
    const int edge = level.GetFaceEdges(f)[c - parent.first(f)];
    edges.push_back({{std::min(a, b), std::max(a, b)},
                     level.GetEdgeChildVertex(edge),
                     parent.kind(c) == EdgeKind::seam});
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
  std::vector<int> places(idx(vertices));
  std::iota(places.begin(), places.end(), 0);
  for (int v = 0; v < level.GetNumVertices(); ++v) {
    at(places, level.GetVertexChildVertex(v)) = level.GetVertexChildVertex(at(parent.places, v));
  }
  place_seam_middles(parent, level, places);
  return places;
}

// Child k < 3 of a triangle, and of a quad any child, is the part at corner k.
FaceDomain child_domain(const FaceDomain& parent, int size, int child) {
  const FaceDomain half{parent.ptex_face, parent.origin, parent.size / 2};
  // The middle triangle is turned by 180 degrees: its corner 0 is the far corner of the square of
  // half the size.
  if (size == 3 && child == 3) return {half.ptex_face, place_on_domain(half, 4, 2), -half.size};
  return {half.ptex_face, place_on_domain(half, size, child), half.size};
}

void inherit_faces(const RefinedMesh& parent, int threads, RefinedMesh& child) {
  child.base_faces.resize(child.face_count());
  child.domains.resize(child.base_faces.size());
  parallel_for(parent.face_count(), threads, [&](std::size_t begin, std::size_t end) {
    for (int f = static_cast<int>(begin); f < static_cast<int>(end); ++f) {
      const int size = parent.face_size(f);
      const bool whole = size == 4 || parent.triangles_are_patches;
      // Loop makes four of each triangle, Catmull-Clark one for each corner.
      const int first = parent.triangles_are_patches ? 4 * f : parent.first(f);
      const FaceDomain& domain = at(parent.domains, f);
      for (int k = 0; k < (whole ? 4 : size); ++k) {
        at(child.base_faces, first + k) = at(parent.base_faces, f);
        at(child.domains, first + k) =
            whole ? child_domain(domain, size, k) : FaceDomain{domain.ptex_face + k};
      }
    }
  });
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
      // By their vertices, since the twin is wound the other way.
      const int j = other_vertices.FindIndex(at(parent.twin_vertices, vertices[k]));
      at(child.twin_faces, children[k]) = others[j];
    }
    if (children.size() > vertices.size()) at(child.twin_faces, children[3]) = others[3];
  }
}

void read_corner_vertices(const TopologyLevel& level, int threads, RefinedMesh& mesh) {
  mesh.corner_vertices.resize(mesh.mates.size());
  parallel_for(mesh.face_count(), threads, [&](std::size_t begin, std::size_t end) {
    for (int f = static_cast<int>(begin); f < static_cast<int>(end); ++f) {
      const auto vertices = level.GetFaceVertices(f);
      std::copy(vertices.begin(), vertices.end(), mesh.corner_vertices.begin() + mesh.first(f));
    }
  });
}

}  // namespace

std::vector<int> ptex_faces(const SoundMesh& mesh, Scheme scheme) {
  std::vector<int> counts = mesh.face_sizes;
  const int regular_size = scheme == Scheme::loop ? 3 : 4;
  std::replace(counts.begin(), counts.end(), regular_size, 1);
  return face_offsets(counts);
}

RefinedMesh base_level(const SoundMesh& mesh, Scheme scheme, int threads) {
  RefinedMesh result = polygonal_mesh(mesh, threads);
  result.triangles_are_patches = scheme == Scheme::loop;
  const std::vector<int> ptex = ptex_faces(mesh, scheme);
  result.domains.resize(result.face_count());
  for (std::size_t f = 0; f < result.domains.size(); ++f) result.domains[f].ptex_face = ptex[f];
  result.places = seam_places(mesh);
  find_sharp_vertices(mesh, result);
  return result;
}

RefinedMesh next_level(const RefinedMesh& parent, const TopologyLevel& level,
                       const TopologyLevel& next, int threads) {
  RefinedMesh child;
  child.triangles_are_patches = parent.triangles_are_patches;
  divide_corners(parent, threads, child);
  read_corner_vertices(next, threads, child);
  inherit_faces(parent, threads, child);
  child.places = child_places(parent, level, next.GetNumVertices());
  if (!parent.twin_faces.empty()) {
    child.twin_faces.assign(child.face_count(), none);
    child.twin_vertices.assign(idx(next.GetNumVertices()), none);
    inherit_twin_vertices(parent, level, child);
    inherit_twin_faces(parent, level, child);
  }
  inherit_sharp_vertices(parent, level, next, threads, child);
  return child;
}

}  // namespace illustrate
