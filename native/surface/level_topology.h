// What each level of OpenSubdiv's refinement inherits from the one before. Only for sources of this
// stage: it names OpenSubdiv's types.
#pragma once

#include <opensubdiv/far/topologyRefiner.h>

#include "surface/refined_mesh.h"

namespace illustrate {

// First ptex face of each base face, and the number of all: a face has one, unless it has another
// number of corners than its scheme likes; then it has one a corner.
std::vector<int> ptex_faces(const SoundMesh& mesh, Scheme scheme);

// Kinds of edges, origins, domains, places and twins; no corners and no points yet.
RefinedMesh base_level(const SoundMesh& mesh, const OpenSubdiv::Far::TopologyRefiner& refiner,
                       Scheme scheme);
RefinedMesh next_level(const RefinedMesh& parent, const OpenSubdiv::Far::TopologyRefiner& refiner,
                       int level);

// Corners, mates and sharpness of vertices.
void read_corners(RefinedMesh& mesh, const OpenSubdiv::Far::TopologyLevel& level);

}  // namespace illustrate
