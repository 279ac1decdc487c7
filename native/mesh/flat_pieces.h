// Pieces of a mesh that lie in one plane, however they are cut into faces.
#pragma once

#include "mesh/edge_turns.h"

namespace illustrate {

struct FlatPieces {
  std::vector<int> pieces;            // (f) the lowest face of each face's piece
  Points normals;                     // (f) of pieces, unit, by their lowest faces
  std::vector<std::uint8_t> is_flat;  // (f) the same: no face turns more than two degrees off it

  bool are_one(int face, int other) const { return pieces[idx(face)] == pieces[idx(other)]; }
};

// Joins faces across edges that are not sharp and turn by less than two degrees.
FlatPieces find_flat_pieces(const Faces& faces, const Points& positions, const EdgeTurns& turns,
                            const Shading& shading);

}  // namespace illustrate
