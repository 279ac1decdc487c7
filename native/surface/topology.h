// OpenSubdiv's topology of a sound mesh. Only for sources of this stage: it names OpenSubdiv's
// types.
#pragma once

#include <opensubdiv/far/topologyRefiner.h>

#include <memory>

#include "mesh/sanitize.h"

namespace illustrate {

// Holes are left in: they shape the limit like any face, and are left out when triangles are made.
// Null where OpenSubdiv refuses the mesh.
std::unique_ptr<OpenSubdiv::Far::TopologyRefiner> make_refiner(const SoundMesh& mesh,
                                                               Scheme scheme);

}  // namespace illustrate
