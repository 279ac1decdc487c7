#include "control/slides.h"

#include <algorithm>
#include <cmath>

#include "control/smoothstep.h"
#include "control/turned_faces.h"

namespace illustrate {
namespace {

constexpr double least_slide = 0.7, full_slide = 1.4;  // of the shortest edge at the vertex
constexpr int rings = 3;

// The largest within one edge.
std::vector<double> wider(const HalfEdges& edges, const std::vector<double>& values) {
  std::vector<double> result = values;
  for (const int h : edges.first) {
    const std::size_t a = idx(edges.faces.corners[idx(h)]), b = idx(edges.faces.head(h));
    result[a] = std::max(result[a], values[b]);
    result[b] = std::max(result[b], values[a]);
  }
  return result;
}

// How far the limit of a smooth vertex is off within the surface.
double slide(const LimitPlaces& limits, std::size_t vertex, const Vec3& place) {
  const Vec3 off = limits.positions[vertex] - place, &normal = limits.directions[vertex];
  return (off - off.dot(normal) * normal).norm();
}

// (n) 1: a corner of a flat face.
std::vector<std::uint8_t> vertices_of_planes(const SoundMesh& mesh) {
  std::vector<std::uint8_t> result(mesh.positions.size(), 0);
  std::size_t corner = 0;
  for (std::size_t f = 0; f < mesh.face_planes.size(); ++f) {
    for (int k = 0; k < mesh.face_sizes[f]; ++k, ++corner) {
      if (mesh.face_planes[f] != none) result[idx(mesh.corner_vertices[corner])] = 1;
    }
  }
  return result;
}

// The least value on the way from a vertex to some start, on the way where that is largest.
std::vector<double> reached(const HalfEdges& edges, const std::vector<double>& values,
                            const std::vector<std::uint8_t>& is_start) {
  std::vector<double> result(values.size(), 0);
  for (std::size_t v = 0; v < values.size(); ++v) result[v] = is_start[v] ? values[v] : 0;
  for (bool grows = true; grows;) {
    grows = false;
    for (const int h : edges.first) {
      const std::size_t a = idx(edges.faces.corners[idx(h)]), b = idx(edges.faces.head(h));
      const double both = std::min({std::max(result[a], result[b]), values[a], values[b]});
      grows |= both > result[a] || both > result[b];
      result[a] = std::max(result[a], both);
      result[b] = std::max(result[b], both);
    }
  }
  return result;
}

std::vector<double> slides_from_planes(const SoundMesh& mesh, const HalfEdges& edges,
                                       const LimitPlaces& limits, double diagonal) {
  std::vector<double> all(mesh.positions.size(), 0);
  const std::vector<std::uint8_t> is_level = vertices_of_planes(mesh);
  if (std::find(is_level.begin(), is_level.end(), 1) == is_level.end()) return all;
  const std::vector<double> shortest = shortest_edges(edges, mesh.positions);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (limits.rules[v] != LimitPlaces::Rule::smooth) continue;
    const double off = slide(limits, v, mesh.positions[v]);
    const double weight = smoothstep(invisible_px, visible_px, diagonal_px / diagonal * off) *
                          smoothstep(least_slide, full_slide, off / shortest[v]);
    if (weight > 0) all[v] = weight;  // what is not a number does not slide
  }
  std::vector<double> result = reached(edges, all, is_level);
  for (int ring = 0; ring < rings; ++ring) result = wider(edges, result);
  return result;
}

}  // namespace

std::vector<double> slides(const SoundMesh& mesh, const HalfEdges& edges, const LimitPlaces& limits,
                           double diagonal) {
  return weights_of_turned_faces(mesh, edges, limits,
                                 slides_from_planes(mesh, edges, limits, diagonal));
}

}  // namespace illustrate
