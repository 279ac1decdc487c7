#include "mesh/memory_order.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/keep_elements.h"
#include "core/ragged.h"

namespace illustrate {
namespace {

constexpr std::size_t least_vertices = 4096;  // fewer stay in the cache of a core

// Between the numbers of two corners in a row, on average: in square roots of the number of
// vertices, of which a search by breadth has a few in each of its rings.
constexpr double farthest_apart = 4;

bool is_scattered(const SoundMesh& mesh) {
  const std::vector<int>& corners = mesh.corner_vertices;
  if (mesh.positions.size() < least_vertices) return false;
  double sum = 0;
  for (std::size_t c = 1; c < corners.size(); ++c) sum += std::abs(corners[c] - corners[c - 1]);
  const double mean = sum / static_cast<double>(corners.size());
  return mean > farthest_apart * std::sqrt(static_cast<double>(mesh.positions.size()));
}

bool has_cover(const SoundMesh& mesh) {
  return std::any_of(mesh.twin_faces.begin(), mesh.twin_faces.end(),
                     [](int twin) { return twin != none; });
}

// The vertices of each face.
Ragged<int> faces_of(const SoundMesh& mesh) {
  Ragged<int> faces;
  faces.values = mesh.corner_vertices;
  for (const int size : mesh.face_sizes) faces.offsets.push_back(faces.offsets.back() + size);
  return faces;
}

// Part by part, each from its first face on.
std::vector<int> by_breadth(const Ragged<int>& faces, const Ragged<int>& at_vertices) {
  std::vector<int> order;
  std::vector<std::uint8_t> is_met(faces.size(), 0);
  const auto meet = [&](int face) {
    if (!is_met[idx(face)]) order.push_back(face);
    is_met[idx(face)] = 1;
  };
  for (std::size_t first = 0, done = 0; first < faces.size(); ++first) {
    meet(static_cast<int>(first));
    for (; done < order.size(); ++done) {
      for (const int vertex : faces[idx(order[done])]) {
        for (const int face : at_vertices[idx(vertex)]) meet(face);
      }
    }
  }
  return order;
}

// Vertices as faces of that order come to them.
std::vector<int> as_met(const Ragged<int>& faces, const std::vector<int>& face_order,
                        std::size_t vertices) {
  std::vector<int> order;
  std::vector<std::uint8_t> is_met(vertices, 0);
  for (const int face : face_order) {
    for (const int vertex : faces[idx(face)]) {
      if (!is_met[idx(vertex)]) order.push_back(vertex);
      is_met[idx(vertex)] = 1;
    }
  }
  return order;
}

std::vector<int> corners_of(const Ragged<int>& faces, const std::vector<int>& face_order) {
  std::vector<int> order;
  order.reserve(faces.values.size());
  for (const int face : face_order) {
    for (int c = faces.offsets[idx(face)]; c < faces.offsets[idx(face) + 1]; ++c)
      order.push_back(c);
  }
  return order;
}

void renumber(std::vector<Edge>& edges, const std::vector<int>& numbers) {
  for (Edge& edge : edges) {
    for (int& vertex : edge) vertex = numbers[idx(vertex)];
  }
}

void reorder_faces(SoundMesh& mesh, const std::vector<int>& order,
                   const std::vector<int>& corner_order) {
  keep_elements(mesh.corner_vertices, corner_order);
  keep_elements(mesh.corner_normals, corner_order);
  keep_elements(mesh.face_sizes, order);
  keep_elements(mesh.source_faces, order);
  keep_elements(mesh.face_materials, order);
  keep_elements(mesh.face_planes, order);
  keep_elements(mesh.holes, order);
  keep_elements(mesh.kept, order);
}

void reorder_vertices(SoundMesh& mesh, const std::vector<int>& order) {
  keep_elements(mesh.positions, order);
  keep_elements(mesh.source_vertices, order);
  keep_elements(mesh.vertex_sharpness, order);
  std::vector<int> numbers(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) numbers[idx(order[i])] = static_cast<int>(i);
  for (int& vertex : mesh.corner_vertices) vertex = numbers[idx(vertex)];
  renumber(mesh.edge_vertices, numbers);
  renumber(mesh.marked_edges, numbers);
  renumber(mesh.seams, numbers);
}

}  // namespace

void order_for_memory(SoundMesh& mesh) {
  if (!is_scattered(mesh) || has_cover(mesh)) return;
  const std::size_t vertices = mesh.positions.size();
  const Ragged<int> faces = faces_of(mesh);
  const Ragged<int> at_vertices = sorted_into<int>(vertices, [&](const auto& put) {
    for (std::size_t face = 0; face < faces.size(); ++face) {
      for (const int vertex : faces[face]) put(vertex, static_cast<int>(face));
    }
  });
  const std::vector<int> face_order = by_breadth(faces, at_vertices);
  reorder_faces(mesh, face_order, corners_of(faces, face_order));
  reorder_vertices(mesh, as_met(faces, face_order, vertices));
}

}  // namespace illustrate
