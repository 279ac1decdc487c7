#include "mesh/faces.h"

#include <algorithm>
#include <utility>

#include "core/angles.h"
#include "mesh/polygons.h"

namespace illustrate {
namespace {

// (higher vertex, half-edge) of all half-edges, listed by lower vertex.
Ragged<std::pair<int, int>> half_edges_by_lower_vertex(const Faces& faces,
                                                       std::size_t vertex_count) {
  return sorted_into<std::pair<int, int>>(vertex_count, [&](const auto& put) {
    for (int h = 0; h < faces.corner_count(); ++h) {
      const auto [lower, higher] = std::minmax({faces.corners[h], faces.head(h)});
      put(lower, {higher, h});
    }
  });
}

Vec3 unit_normal(Span<const int> face, const Points& positions) {
  const Vec3& origin = positions[face[0]];
  double extent = 0;
  for (const int vertex : face)
    extent = std::max(extent, (positions[vertex] - origin).cwiseAbs().maxCoeff());
  if (extent == 0) return Vec3::Zero();
  Vec3 area = Vec3::Zero();
  for (std::size_t k = 1; k + 1 < face.size(); ++k)
    area +=
        ((positions[face[k]] - origin) / extent).cross((positions[face[k + 1]] - origin) / extent);
  return area.stableNormalized();
}

}  // namespace

int Faces::reversed(int half_edge, int first) const {
  const int face = corner_faces[half_edge], size = offsets[face + 1] - offsets[face];
  const int k = half_edge - offsets[face];
  return first + (k == size - 1 ? size - 1 : size - 2 - k);
}

void Faces::close_face(int source) {
  corner_faces.resize(corners.size(), size());
  sources.push_back(source);
  offsets.push_back(corner_count());
}

Ragged<int> half_edges_by_edge(const Faces& faces, std::size_t vertex_count) {
  auto by_vertex = half_edges_by_lower_vertex(faces, vertex_count);
  Ragged<int> edges;
  edges.values.reserve(faces.corners.size());
  edges.offsets.reserve(faces.corners.size() / 2 + 1);
  for (std::size_t v = 0; v < vertex_count; ++v) {
    auto list = by_vertex[v];
    std::sort(list.begin(), list.end());
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (i > 0 && list[i].first != list[i - 1].first) edges.close_list();
      edges.push(list[i].second);
    }
    if (!list.empty()) edges.close_list();
  }
  return edges;
}

double corner_angle(const Faces& faces, const Points& positions, int corner) {
  const Vec3& here = positions[faces.corners[corner]];
  return angle_between(positions[faces.head(corner)] - here,
                       positions[faces.corners[faces.previous(corner)]] - here);
}

double reach_of_face(const Faces& faces, const Points& positions, int half_edge) {
  const Vec3& start = positions[idx(faces.corners[idx(half_edge)])];
  const Vec3 along = unit_or_zero(positions[idx(faces.head(half_edge))] - start);
  double reach = 0;
  for (const int v : faces[faces.corner_faces[idx(half_edge)]])
    reach = std::max(reach, (positions[idx(v)] - start).cross(along).norm());
  return reach;
}

Points unit_normals(const Faces& faces, const Points& positions) {
  Points normals;
  normals.reserve(faces.sources.size());
  for (int f = 0; f < faces.size(); ++f) normals.push_back(unit_normal(faces[f], positions));
  return normals;
}

}  // namespace illustrate
