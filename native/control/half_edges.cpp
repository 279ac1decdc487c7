#include "control/half_edges.h"

#include <algorithm>
#include <limits>

#include "mesh/edge_table.h"
#include "mesh/polygons.h"

namespace illustrate {
namespace {

Faces faces_of(const SoundMesh& mesh) {
  Faces faces;
  faces.corners = mesh.corner_vertices;
  faces.offsets = face_offsets(mesh.face_sizes);
  faces.sources = mesh.source_faces;
  faces.corner_faces.reserve(faces.corners.size());
  for (int f = 0; f < static_cast<int>(mesh.face_sizes.size()); ++f)
    faces.corner_faces.insert(faces.corner_faces.end(), idx(mesh.face_sizes[idx(f)]), f);
  return faces;
}

}  // namespace

HalfEdges::HalfEdges(const SoundMesh& mesh)
    : faces(faces_of(mesh)),
      mates(mesh.corner_vertices.size(), none),
      edges(mesh.corner_vertices.size(), none) {
  const Ragged<int> lists = half_edges_by_edge(faces, mesh.positions.size());
  first.resize(lists.size());
  for (std::size_t e = 0; e < lists.size(); ++e) {
    const auto list = lists[e];
    first[e] = list[0];
    for (const int h : list) edges[idx(h)] = static_cast<int>(e);
    if (list.size() != 2) continue;
    mates[idx(list[0])] = list[1];
    mates[idx(list[1])] = list[0];
  }
  const EdgeTable table(mesh.positions.size(), mesh.edge_vertices);
  for (const int h : first) {
    const int known = table.find(faces.corners[idx(h)], faces.head(h));
    const double given = known == none ? 0 : mesh.edge_sharpness[idx(known)];
    sharpness.push_back(mates[idx(h)] == none ? infinitely_sharp : given);
  }
}

std::vector<double> shortest_edges(const HalfEdges& half_edges, const Points& positions) {
  std::vector<double> shortest(positions.size(), std::numeric_limits<double>::max());
  for (const int h : half_edges.first) {
    const int a = half_edges.faces.corners[idx(h)], b = half_edges.faces.head(h);
    const double length = (positions[idx(a)] - positions[idx(b)]).norm();
    for (const int v : {a, b}) shortest[idx(v)] = std::min(shortest[idx(v)], length);
  }
  return shortest;
}

VertexSectors find_sectors(const HalfEdges& mesh, std::size_t vertex_count) {
  VertexSectors sectors;
  sectors.sharp_edges.assign(vertex_count, 0);
  const Faces& faces = mesh.faces;
  for (const int h : mesh.first) {
    if (!mesh.is_sharp(h)) continue;
    ++sectors.sharp_edges[idx(faces.corners[idx(h)])];
    ++sectors.sharp_edges[idx(faces.head(h))];
  }
  sectors.corner_sectors.assign(faces.corners.size(), none);
  const auto ends_at = [&](int half_edge, int vertex) {
    if (mesh.mates[idx(half_edge)] == none) return true;
    return mesh.is_sharp(half_edge) && sectors.sharp_edges[idx(vertex)] > 1;
  };
  for (int c = 0; c < faces.corner_count(); ++c) {
    if (sectors.corner_sectors[idx(c)] != none) continue;
    const int vertex = faces.corners[idx(c)];
    int start = c;  // the sector's first corner, clockwise from here
    while (!ends_at(start, vertex)) {
      start = faces.next(mesh.mates[idx(start)]);
      if (start == c) break;
    }
    const int sector = static_cast<int>(sectors.corners.size());
    int corner = start;
    do {
      sectors.corner_sectors[idx(corner)] = sector;
      sectors.corners.push(corner);
      const int border = faces.previous(corner);
      corner = ends_at(border, vertex) ? none : mesh.mates[idx(border)];
    } while (corner != none && corner != start);
    sectors.corners.close_list();
  }
  return sectors;
}

std::vector<Edge> crease_neighbours(const HalfEdges& mesh, std::size_t vertex_count) {
  std::vector<Edge> neighbours(vertex_count, Edge{none, none});
  for (const int h : mesh.first) {
    if (!mesh.is_sharp(h)) continue;
    const int a = mesh.faces.corners[idx(h)], b = mesh.faces.head(h);
    for (const auto& [here, other] : {Edge{a, b}, Edge{b, a}}) {
      Edge& found = neighbours[idx(here)];
      (found[0] == none ? found[0] : found[1]) = other;
    }
  }
  return neighbours;
}

int find_patches(const HalfEdges& mesh, std::vector<int>& patches) {
  const Faces& faces = mesh.faces;
  patches.assign(faces.sources.size(), none);
  int count = 0;
  std::vector<int> queue;
  for (int f = 0; f < faces.size(); ++f) {
    if (patches[idx(f)] != none) continue;
    patches[idx(f)] = count;
    queue.assign(1, f);
    for (std::size_t i = 0; i < queue.size(); ++i) {
      for (int h = faces.offsets[idx(queue[i])]; h < faces.offsets[idx(queue[i]) + 1]; ++h) {
        if (mesh.is_sharp(h)) continue;
        int& patch = patches[idx(faces.corner_faces[idx(mesh.mates[idx(h)])])];
        if (patch != none) continue;
        patch = count;
        queue.push_back(faces.corner_faces[idx(mesh.mates[idx(h)])]);
      }
    }
    ++count;
  }
  return count;
}

}  // namespace illustrate
