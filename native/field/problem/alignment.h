// Soft pulls at features: creases and boundaries attract the cross, and the copies of a vertex on
// the sides of a crease or of a split edge see each other. Not in the paper.
//
// An edge counts with alignment_weight times its length in hundredths of its object's diagonal, so
// that the pull reaches equally far into the surface at any level of refinement.
#pragma once

#include "field/problem/edges.h"

namespace illustrate {

struct Alignment {
  CrossNumbers pulls;                // (n) weighted sum of the crosses that a vertex should have
  std::vector<FieldEdge> couplings;  // between copies of one point, along the edge they share
};

// diagonals: (n) of each vertex's object.
Alignment align_to_features(const Surface& surface, const TangentFrames& frames,
                            const std::vector<double>& diagonals, double weight,
                            const Progress& progress = {});

}  // namespace illustrate
