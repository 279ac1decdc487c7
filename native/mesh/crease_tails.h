// Where creases fade out.
//
// The edge between two pipes that meet at right angles turns by 90 degrees in the fork and by none
// where the pipes lie side by side. Somewhere between it falls below the crease angle: as if the
// pipes were welded in the fork and cast in one piece beside it. Who draws such an edge draws it to
// where it can no longer be told.
#pragma once

#include "mesh/edge_turns.h"

namespace illustrate {

// A crease may have a *tail* at a vertex where no other edge is sharp or open, if up to there it is
// a line of at least three edges: at each vertex nothing else is sharp, it turns by less than 40
// degrees, and all its edges are convex or all concave. Of the tail is the edge that goes straight
// on in this way, if it turns by over 10 degrees between faces that are shaded flat; then the next
// one, but no more than the line has edges.
// turns: with what is sharp. Returns (edges) 1: of a tail.
std::vector<std::uint8_t> find_crease_tails(const Faces& faces, const Points& positions,
                                            const Ragged<int>& edges, const EdgeTurns& turns,
                                            const Shading& shading);

}  // namespace illustrate
