// Bends of flat faces that are edges though they turn by less than the crease angle: the ridge of a
// low roof, the ends of a ramp.
//
// Faces that are shaded flat are meant flat or never told otherwise, and below the crease angle
// they are taken for samples of a curve. But a curve goes on turning. Where two flat pieces meet in
// a *lone bend*, beyond which neither turns again, there is none, however little it turns.
#pragma once

#include "mesh/edge_turns.h"

namespace illustrate {

// The line where two flat pieces (mesh/flat_pieces.h) meet is a lone bend if
// - it turns by over 8 degrees, both are shaded flat, and a smooth surface would leave it by over a
//   pixel of a drawing in which the mesh's diagonal has 1400: by an eighth of the narrower piece
//   times the angle;
// - three tenths of the border of both pieces are sharp or open: they end where a curve does not;
// - across neither of them, along a border that runs about the same way, the next piece turns the
//   same way;
// - it begins and ends at sharp or open edges or other lone bends.
// turns: with what is sharp. Returns (edges) 1: of a lone bend.
std::vector<std::uint8_t> find_lone_bends(const Faces& faces, const Points& positions,
                                          const Ragged<int>& edges, const EdgeTurns& turns,
                                          const Shading& shading);

}  // namespace illustrate
