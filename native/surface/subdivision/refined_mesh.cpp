#include "surface/subdivision/refined_mesh.h"

#include <algorithm>
#include <numeric>

#include "core/parallel.h"
#include "surface/subdivision/base_edges.h"

namespace illustrate {
namespace {

// Corners at each vertex, which are also the half-edges from there.
struct VertexCorners {
  std::vector<int> offsets;  // (n + 1)
  std::vector<int> corners;  // those of each vertex in ascending order

  explicit VertexCorners(const RefinedMesh& mesh)
      : offsets(mesh.points.size() + 1, 0), corners(mesh.corner_count()) {
    for (const int v : mesh.corner_vertices) ++offsets[idx(v) + 1];
    std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
    std::vector<int> cursor(offsets.begin(), offsets.end() - 1);
    for (int c = 0; c < static_cast<int>(corners.size()); ++c) {
      corners[idx(cursor[idx(mesh.vertex(c))]++)] = c;
    }
  }

  int count(int v) const { return offsets[idx(v) + 1] - offsets[idx(v)]; }

  // The first of a vertex's corners that fits, else none.
  template <class Fits>
  int find(int v, const Fits& fits) const {
    const auto end = corners.begin() + offsets[idx(v) + 1];
    const auto found = std::find_if(corners.begin() + offsets[idx(v)], end, fits);
    return found == end ? none : *found;
  }
};

// Searched for at the end with fewer edges, so that a vertex of very many costs no more than
// others.
int find_mate(const RefinedMesh& mesh, const VertexCorners& at, int corner) {
  const int from = mesh.vertex(corner), to = mesh.vertex(mesh.next(corner));
  if (at.count(to) <= at.count(from)) {
    return at.find(to, [&](int c) { return mesh.vertex(mesh.next(c)) == from; });
  }
  const int after = at.find(from, [&](int c) { return mesh.vertex(mesh.previous(c)) == to; });
  return after == none ? none : mesh.previous(after);
}

void read_faces(const SoundMesh& base, RefinedMesh& mesh) {
  const std::vector<int>& sizes = base.face_sizes;
  mesh.corner_vertices = base.corner_vertices;
  const bool same = std::all_of(sizes.begin(), sizes.end(), [&](int s) { return s == sizes[0]; });
  if (same && !sizes.empty() && sizes[0] <= 4) {
    mesh.corners_per_face = sizes[0];
    return;
  }
  mesh.face_offsets = face_offsets(sizes);
  mesh.corner_faces.reserve(mesh.corner_count());
  for (std::size_t f = 0; f < sizes.size(); ++f) {
    mesh.corner_faces.insert(mesh.corner_faces.end(), idx(sizes[f]), static_cast<int>(f));
  }
}

void connect(RefinedMesh& mesh, int threads) {
  const VertexCorners at(mesh);
  mesh.mates.resize(mesh.corner_count());
  parallel_for(mesh.mates.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      mesh.mates[c] = find_mate(mesh, at, static_cast<int>(c));
    }
  });
}

void classify_edges(const SoundMesh& base, RefinedMesh& mesh, int threads) {
  const BaseEdgeKinds kinds(base);
  mesh.corner_kinds.resize(mesh.corner_count());
  parallel_for(mesh.corner_count(), threads, [&](std::size_t begin, std::size_t end) {
    for (int c = static_cast<int>(begin); c < static_cast<int>(end); ++c) {
      const int mate = mesh.mate(c);
      mesh.corner_kinds[idx(c)] = kinds.kind(mesh.vertex(c), mesh.vertex(mesh.next(c)),
                                             mesh.face(c), mate == none ? none : mesh.face(mate));
    }
  });
}

}  // namespace

Vec3 RefinedMesh::twice_area(int face) const {
  Vec3 sum = Vec3::Zero();
  const Vec3& origin = point(first(face));
  for (int c = first(face); c < first(face + 1); ++c)
    sum += (point(c) - origin).cross(point(next(c)) - point(c));
  return sum;
}

double RefinedMesh::longest_edge(int face) const {
  double longest = 0;
  for (int c = first(face); c < first(face + 1); ++c)
    longest = std::max(longest, (point(next(c)) - point(c)).norm());
  return longest;
}

int twin_corner(const RefinedMesh& mesh, int corner) {
  const int face = mesh.twin_faces[idx(mesh.face(corner))];
  if (face == none) return none;
  const int vertex = mesh.twin_vertices[idx(mesh.vertex(corner))];
  for (int c = mesh.first(face); c < mesh.first(face + 1); ++c) {
    if (mesh.vertex(c) == vertex) return c;
  }
  return none;
}

std::array<std::uint16_t, 2> place_on_domain(const FaceDomain& domain, int size, int k) {
  static constexpr int quad[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  static constexpr int triangle[3][2] = {{0, 0}, {1, 0}, {0, 1}};
  const auto& unit = size == 3 ? triangle[k] : quad[k];
  return {static_cast<std::uint16_t>(domain.origin[0] + domain.size * unit[0]),
          static_cast<std::uint16_t>(domain.origin[1] + domain.size * unit[1])};
}

BasePlace base_place(const RefinedMesh& mesh, int corner) {
  if (mesh.domains.empty()) return {};
  const int face = mesh.face(corner), size = mesh.face_size(face);
  const int k = corner - mesh.first(face);
  const FaceDomain& domain = mesh.domains[idx(face)];
  const bool is_patch = size == 4 || (size == 3 && mesh.triangles_are_patches);
  if (!is_patch) return {domain.ptex_face + k, Vec2::Zero()};
  const auto place = place_on_domain(domain, size, k);
  return {domain.ptex_face, Vec2(place[0], place[1]) / FaceDomain::steps};
}

RefinedMesh polygonal_mesh(const SoundMesh& base, int threads) {
  RefinedMesh mesh;
  mesh.points = base.positions;
  read_faces(base, mesh);
  connect(mesh, threads);
  classify_edges(base, mesh, threads);
  mesh.sharp_vertices.assign(mesh.points.size(), 1);
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
