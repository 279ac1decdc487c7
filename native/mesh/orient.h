// Winding: consistent by flood fill, outward where closed, doubled where neither is possible.
#pragma once

#include "core/report.h"
#include "mesh/faces.h"

namespace illustrate {

// Reverses faces so that joined faces run along their edge in opposite directions. Per connected
// part the winding of most faces wins; a closed part of negative volume is turned outward. In parts
// that cannot be oriented some joined faces still disagree; their winding is the flood fill's.
// Counts "parts", "flipped_faces", "turned_parts", "covered_parts". Returns 1 for each face of a
// part that cannot be oriented.
std::vector<std::uint8_t> orient(Faces& faces, FaceAdjacency& adjacency, const Points& positions,
                                 Counts& report);

// The orientation double cover of the marked faces: a reversed twin of each is added at the end,
// and joined faces that disagree lead to the other sheet's. All agree afterwards. Returns the twin
// of each face; none for faces that are not marked.
std::vector<int> add_double_cover(Faces& faces, FaceAdjacency& adjacency,
                                  const std::vector<std::uint8_t>& is_covered);

}  // namespace illustrate
