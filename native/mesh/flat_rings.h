// Flat faces with holes: ends of pipes, lids of nuts.
//
// A *flat ring* is a piece of a mesh in one plane with two borders or more. Where all of them turn
// steeply and one is round, it is where something was cut off straight, or drilled: no curved
// surface has a flat ring for a sample. Its borders are edges then, also those too coarse to tell a
// rounding from a corner by themselves.
#pragma once

#include "mesh/edge_turns.h"

namespace illustrate {

struct FlatRings {
  std::vector<std::uint8_t> is_rim;  // (edges) 1: of a border that turns by nearly a right angle
  std::vector<std::uint8_t> is_angular;  // (n) 1: on a border of corners beside one much rounder
};

// A flat ring's faces are within two degrees of their mean. All of its borders turn by over 30
// degrees on average, and one of eight edges or more is no ring of like sides and bends by less
// than 50 where it bends. Those that turn by over 76 are rims, but for rings of like sides. One is
// of corners if it bends by over 50 where it bends, and 1.6 times as far as another.
FlatRings find_flat_rings(const Faces& faces, const Points& positions, const EdgeTurns& turns,
                          const Shading& shading, std::size_t edge_count);

}  // namespace illustrate
