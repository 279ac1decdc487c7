// Which scheme a mesh is subdivided by.
#pragma once

#include "mesh/sanitize.h"

namespace illustrate {

// The mesh's own, else the `usual`; `automatic`: Catmull-Clark where most faces are quads, else
// Loop, as for a mesh that is no cage and has a face round a corner, of which the middle does not
// see all. No faces: polygons. Never `automatic`.
Scheme choose_scheme(const SoundMesh& mesh, Scheme usual);

}  // namespace illustrate
