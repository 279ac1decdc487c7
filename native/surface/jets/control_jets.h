// Jets of subdivided meshes, whose support does not shrink with the level of refinement.
#pragma once

#include "surface/jets/curvature.h"

namespace illustrate {

// Curvature from jets at the nodes of ControlNodes, on the points that lie within so many rings of
// *control* edges, and in between interpolated. Near an extraordinary vertex the curvature of the
// limit surface itself is nothing like that of the smooth surface that the control mesh stands for;
// points farther away are hardly off. Writes the vertices of refined meshes to `result` and no
// other; returns those others, ascending.
std::vector<int> control_jets(const Surface& surface, const JetOptions& options,
                              const Progress& progress, Curvature& result);

}  // namespace illustrate
