// How many levels of refinement each mesh gets.
#pragma once

#include "surface/refine.h"

namespace illustrate {

// Levels of all meshes. Their schemes are given; those of Loop's are triangles. Throws InvalidInput
// where an explicit level makes more triangles than indices can count.
std::vector<int> choose_levels(const std::vector<SoundMesh>& meshes,
                               const std::vector<Scheme>& schemes, const SurfaceOptions& options);

}  // namespace illustrate
