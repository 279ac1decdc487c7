// Rounded edges that are finer than a drawing shows.
//
// CAD rounds off nearly every edge, and what turns within about a pixel looks sharp: a render shows
// a line there. A smooth surface has none, and what lies between the edges melts into one. So of
// the edges of such a rounding the middle one is sharp: the surface stays as it is, to less than a
// pixel.
#pragma once

#include "mesh/edge_turns.h"

namespace illustrate {

// reach: what a drawing shows as one line, in units of the positions. An edge that is not sharp is
// of a *fine bend* if, going across it from face to face over edges that run its way,
// - the faces turn by at least least_deg within half of `reach` to both sides, all one way, and not
//   at this edge alone, which a smooth surface rounds off over the whole of its faces; at an edge a
//   smooth surface turns from the middle of one strip of faces to that of the next;
// - it is at least three times as long as the strips beside it are wide: the steps of a scan are
//   not;
// - they turn as far on its one side as on the other, but for its own turn, and by less than 170
//   degrees in all within four times `reach`: a thin rod turns by 360, the rim of a sheet by 180.
// Of two edges side by side that are both in the middle the one that goes on an edge already chosen
// is, and what comes out shorter than six times `reach` is none.
// turns: with what is sharp. Returns (edges) 1: of a fine bend.
std::vector<std::uint8_t> find_fine_bends(const Faces& faces, const Points& positions,
                                          const Ragged<int>& edges, const EdgeTurns& turns,
                                          double reach, double least_deg);

}  // namespace illustrate
