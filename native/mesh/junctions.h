// Junctions of the patches of a surface that was triangulated patch by patch.
//
// Where programs mesh each face of a solid by itself (mesh/gaps.h), two of them that meet along a
// curve may have divided it differently. A *junction* is a vertex of one that lies on an open edge
// of the other, between its ends, as the foot of the letter T on its bar: the edges have no common
// ends, so nothing joins them, and a border runs through the surface.
#pragma once

#include "core/report.h"
#include "mesh/border_edges.h"

namespace illustrate {

// Open edges with junctions are divided there: the faces get corners more, straight but for the
// distance. A vertex is within reach of the edge (mesh/border_edges.h) and farther than that from
// its ends; an open edge at it runs in the opposite direction, and the normals there differ little,
// both to within 30 degrees. Whether a crease runs there is asked of joined faces (mesh/creases.h).
// Not for a cage.
//
// open: of these faces; it holds no more where there are junctions. Whether there are; counts
// "junctions".
bool divide_at_junctions(const Points& positions, const BorderEdges& open, Faces& faces,
                         Counts& report);

}  // namespace illustrate
