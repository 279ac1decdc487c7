// Where parts of a cage touch: edges of more than two faces, and vertices of several fans.
//
// Splitting takes such places apart, and each part would be rounded for itself: two cubes that
// share an edge would become two balls that touch nowhere. A Subdivision modifier (OpenSubdiv)
// holds them: edges of more than two faces are infinitely sharp, and so are vertices of several
// fans, unless just two such edges run on through one, as amid the foot of a wall.
#pragma once

#include "mesh/faces.h"
#include "mesh/sanitize.h"

namespace illustrate {

struct HeldPlaces {
  std::vector<std::uint8_t> edges;     // (edges) 1: of more than two faces in the input
  std::vector<std::uint8_t> vertices;  // (n) 1
};

// edges: half_edges_by_edge's. is_cut: FaceAdjacency's. sound: its source_vertices and twins stand.
HeldPlaces find_held_places(const Faces& faces, const Ragged<int>& edges,
                            const std::vector<std::uint8_t>& is_cut, const SoundMesh& sound);

}  // namespace illustrate
