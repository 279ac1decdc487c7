// Guide strokes: each adds - weight cos 4(theta - alpha) to the energy at the vertices that it
// passes, alpha its direction there.
#pragma once

#include "core/progress.h"
#include "field/problem/frames.h"
#include "field/problem/guidance.h"
#include "mesh/bvh.h"
#include "surface/surface.h"

namespace illustrate {

// (n) what the guides ask of each vertex; the length is the weight, less where the directions of
// one guide contradict each other. Points of a guide are moved to the nearest of the surface; what
// is farther from it than a twentieth of the scene's diagonal is left out, and so is what runs
// along the normal.
CrossNumbers guide_pulls(const Surface& surface, const TangentFrames& frames, const Bvh& bvh,
                         const std::vector<Guide>& guides, const Progress& progress);

// (n) 1: no farther along edges from a vertex that is pulled than `radius` diagonals. `diagonals`:
// (n) of each vertex's object.
std::vector<std::uint8_t> near_pulls(const Surface& surface, const CrossNumbers& pulls,
                                     const std::vector<double>& diagonals, double radius);

}  // namespace illustrate
