// Where the limit of a mesh that is no cage slides, its surface is made of arcs (not in the paper).
#pragma once

#include "control/arc_faces.h"
#include "surface/limit/limit.h"

namespace illustrate {

// Moves the limits of `mesh`, refined from `base` whose faces have these arcs or none, as far as
// the weights of the arcs say. Their normals are those of the refined faces, their curvature is the
// mean of that of the patches round them. Double covers stay as they are. Returns (faces of `base`)
// 1: the surface is not base's limit there; empty: it is everywhere.
std::vector<std::uint8_t> lay_on_arcs(const SoundMesh& base, const ArcFaces& arcs,
                                      const RefinedMesh& mesh, const Sectors& sectors, int threads,
                                      SectorLimits& limits);

}  // namespace illustrate
