// OpenSubdiv's topology of a sound mesh. Only for sources of this stage: it names OpenSubdiv's
// types.
#pragma once

#include <opensubdiv/far/topologyRefiner.h>

#include <memory>

#include "mesh/sanitize.h"

namespace illustrate {

// False for vertices and faces of more than 65535 edges: OpenSubdiv numbers them in 16 bits, and
// does not look whether they fit.
bool can_be_refined(const SoundMesh& mesh);

// Holes are left in: they shape the limit like any face, and are left out when triangles are made.
// Null where the mesh cannot be refined.
std::unique_ptr<OpenSubdiv::Far::TopologyRefiner> make_refiner(const SoundMesh& mesh,
                                                               Scheme scheme);

}  // namespace illustrate
