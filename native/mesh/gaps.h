// Gaps between the patches of a surface that was triangulated patch by patch.
//
// Programs for mechanical design mesh each face of a solid by itself. Its corners lie where that
// face ends, which is where the next one begins only to within the program's tolerance: between a
// millionth and a ten-thousandth of the object. A *gap* are two open edges so close to each other,
// running in opposite directions as those of neighbours do, whose faces are shaded as one surface.
// The two sides of a thin sheet or of a groove are shaded apart.
#pragma once

#include "mesh/border_edges.h"
#include "mesh/clean.h"

namespace illustrate {

// Gives the vertices at both sides of a gap the same number, the lowest. Its edges are apart at
// both ends by less than 1 % of their length and are within reach of each other, each is the
// nearest to the other, and they are shaded alike there (mesh/border_edges.h). Not for a cage,
// whose surface ends where its faces end.
//
// open: of these faces. numbers: weld_open_edges', with which it goes on. Counts "closed_gaps",
// "welded_vertices" and what cleaning the faces again counts.
void close_gaps(const Points& positions, const BorderEdges& open, Faces& faces,
                std::vector<int>& numbers, Counts& report);

}  // namespace illustrate
