// A sound mesh by its half-edges. A half-edge has the index of the corner that it starts at.
#pragma once

#include "mesh/faces.h"
#include "mesh/sanitize.h"

namespace illustrate {

struct HalfEdges {
  Faces faces;
  std::vector<int> mates;         // (c) half-edge on the other side; none at open edges
  std::vector<int> edges;         // (c) number of its edge, by first half-edges
  std::vector<int> first;         // (e) half-edge of each edge, its lower one
  std::vector<double> sharpness;  // (e) infinitely_sharp at open edges

  explicit HalfEdges(const SoundMesh& mesh);

  int edge_count() const { return static_cast<int>(first.size()); }
  bool is_sharp(int half_edge) const {
    return sharpness[idx(edges[idx(half_edge)])] >= infinitely_sharp;
  }
  // The corner after this one counter-clockwise round their vertex; none beyond an open edge.
  int next_round_vertex(int corner) const { return mates[idx(faces.previous(corner))]; }
};

// (n) length of the shortest edge at each vertex; the largest number where there is none.
std::vector<double> shortest_edges(const HalfEdges& half_edges, const Points& positions);

// The corners of each vertex between two sharp or open edges, in ascending order of their lowest
// corners; counter-clockwise. The end of a single sharp edge has one sector all round.
struct VertexSectors {
  std::vector<int> corner_sectors;  // (c)
  Ragged<int> corners;              // of each sector
  std::vector<int> sharp_edges;     // (n) infinitely sharp and open edges at each vertex
};

VertexSectors find_sectors(const HalfEdges& half_edges, std::size_t vertex_count);

// (n) The first two neighbours of each vertex along sharp or open edges; none where there are
// fewer.
std::vector<Edge> crease_neighbours(const HalfEdges& half_edges, std::size_t vertex_count);

// Faces that no sharp or open edge parts: the patch of each, numbered by their first faces.
// Returns their count.
int find_patches(const HalfEdges& half_edges, std::vector<int>& patches);

}  // namespace illustrate
