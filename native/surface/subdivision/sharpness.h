// Sharp and semi-sharp vertices of each level, as OpenSubdiv has them. Only for sources of this
// stage: it names OpenSubdiv's types.
#pragma once

#include <opensubdiv/far/topologyLevel.h>

#include "surface/subdivision/refined_mesh.h"

namespace illustrate {

// (n) Of the sound mesh, with vertices that seams hold; without corners of the boundary.
std::vector<float> vertex_sharpness(const SoundMesh& mesh);

// Fills sharp_vertices and semi_sharp of level 0.
void find_sharp_vertices(const SoundMesh& base, RefinedMesh& mesh);

// The same of the level `next` after `level`, which `parent` is. threads: 0 = all cores.
void inherit_sharp_vertices(const RefinedMesh& parent, const OpenSubdiv::Far::TopologyLevel& level,
                            const OpenSubdiv::Far::TopologyLevel& next, int threads,
                            RefinedMesh& child);

}  // namespace illustrate
