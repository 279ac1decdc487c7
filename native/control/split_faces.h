// Triangles for Loop's scheme.
#pragma once

#include "mesh/sanitize.h"

namespace illustrate {

// Other faces are split: a quad along its shorter diagonal, larger ones as `triangulate` does, a
// face of a double cover and its twin alike. Where a diagonal would join two vertices that an edge
// or another diagonal joins already, which would make that edge one of more than two faces, the
// face becomes a star round its middle, a vertex without source.
SoundMesh split_into_triangles(SoundMesh mesh);

}  // namespace illustrate
