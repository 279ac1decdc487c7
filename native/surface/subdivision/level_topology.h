// What each level of OpenSubdiv's refinement inherits from the one before. Only for sources of this
// stage: it names OpenSubdiv's types.
#pragma once

#include <opensubdiv/far/topologyRefiner.h>

#include "surface/subdivision/refined_mesh.h"

namespace illustrate {

// First ptex face of each base face, and the number of all: a face with as many corners as its
// scheme's (4, of Loop's 3) is one, any other has one at each corner.
std::vector<int> ptex_faces(const SoundMesh& mesh, Scheme scheme);

// Level 0, with its points. threads: 0 = all cores.
RefinedMesh base_level(const SoundMesh& mesh, Scheme scheme, int threads);

// The level `next` after `level`, which `parent` is; without points.
RefinedMesh next_level(const RefinedMesh& parent, const OpenSubdiv::Far::TopologyLevel& level,
                       const OpenSubdiv::Far::TopologyLevel& next, int threads);

}  // namespace illustrate
