// Where the cross turns by quarter turns round a point.
//
// Index of a triangle = (2 / pi) (sum of the turns of its edges, each within 45 degrees, + its
// excess), an integer for any field. The excess is the sum of its corner angles in the vertices'
// tangent planes - pi. The corner angles round an inner vertex sum to a full turn, but for a fan
// that folds over in projection: there what is missing goes to its least corner. So the indices sum
// to 4 chi on any closed surface (the paper's footnote 3).
#pragma once

#include "core/progress.h"
#include "field/problem/edges.h"

namespace illustrate {

// (t) radians; over a closed part they sum to 2 pi chi.
std::vector<double> triangle_excess(const Surface& surface, const TriangleEdges& edges,
                                    const TangentFrames& frames, int threads,
                                    const Progress& progress);

// +1 or -1: how the turn of the edge from corner k to the next counts in the sum round a triangle,
// seen from its front.
double side_sign(const Surface& surface, std::size_t triangle, int k);

// (t) quarter turns; 0 where a corner is repeated.
std::vector<int> triangle_indices(const Surface& surface, const TriangleEdges& triangle_edges,
                                  const std::vector<FieldEdge>& edges,
                                  const std::vector<double>& excess, const CrossNumbers& z,
                                  int threads, const Progress& progress);

}  // namespace illustrate
