// Where the cross turns by quarter turns round a point.
//
// Index of a triangle = (2 / pi) (sum of the turns of its edges, each within 45 degrees, + sum of
// its corner angles in the vertices' tangent planes - pi), an integer for any field. The corner
// angles round an inner vertex sum to a full turn, but for a fan that folds over in projection:
// there what is missing goes to its least corner. So the indices sum to 4 chi on any closed
// orientable surface (the paper's footnote 3).
#pragma once

#include "field/cross_field.h"
#include "field/edges.h"

namespace illustrate {

// Sets singular_triangles and singular_indices from the field's directions.
void find_singularities(const Surface& surface, const TriangleEdges& edges,
                        const TangentFrames& frames, int threads, CrossField& field);

}  // namespace illustrate
