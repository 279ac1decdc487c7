// Flat faces whose limit folds over itself, spread out again.
//
// A flat part of a mesh between creases has a flat limit, but the map onto it need not be one to
// one. Where two creases meet at a corner with more than 180 degrees inside, the subdivision rules
// fold the triangles next to it over the creases, at every level: OpenSubdiv has no rule for such
// corners (Biermann, Levin, Zorin, "Piecewise smooth subdivision surfaces with normal control",
// SIGGRAPH 2000, give one); next to corners where four faces or more meet, and in slivers, some are
// turned round as well. There the normal points to the wrong side, silhouettes run through a plane,
// and what lies beyond the crease passes through the next face.
#pragma once

#include "surface/limit/limit.h"

namespace illustrate {

// A flat part is what smooth edges connect in `control` (level 0 of `mesh`), where all its vertices
// lie in a plane. Where the limit of one folds, its normals become those of the plane, and points
// near the folds move within it until no triangle is turned round, if they can; its border stays.
// Returns (faces of `control`) 1: changed; empty: none is.
std::vector<std::uint8_t> unfold_flat_faces(const RefinedMesh& control, const RefinedMesh& mesh,
                                            const std::vector<int>& corner_sectors, int threads,
                                            SectorLimits& limits);

}  // namespace illustrate
