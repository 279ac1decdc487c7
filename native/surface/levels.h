// Which scheme and how many levels of refinement each mesh gets.
#pragma once

#include "surface/refine.h"

namespace illustrate {

// Never `automatic`. Most faces are quads: Catmull-Clark; no faces: none.
Scheme choose_scheme(const SoundMesh& mesh, const SurfaceOptions& options);

// Levels of all meshes. Their schemes are given; those of Loop's are triangles. Throws InvalidInput
// where an explicit level makes more triangles than indices can count.
std::vector<int> choose_levels(const std::vector<SoundMesh>& meshes,
                               const std::vector<Scheme>& schemes, const SurfaceOptions& options);

}  // namespace illustrate
