// Absolute labels of a path: its base, and the breaks where a cycle contradicts itself.
#pragma once

#include "visibility/evidence.h"
#include "visibility/labelled_path.h"

namespace illustrate {

// The labels of a path that contradict the rays least, by length of line, a break counted as so
// many pixels of wrong label. A path whose changes can all hold has no break, unless it runs along
// the outside of the drawing at different labels, would need negative ones, or a crossing or a cusp
// of it was demoted; a cycle whose changes do not sum to zero has one at least. Arcs at the outside
// of the drawing have 0. No label is negative. trusts_rules: false where the crossings of
// the mesh are not worth it (a crowd of needles): any path then breaks, and cheaply.
LabelledPath label_path(const Arrangement& arrangement, const Path& path, bool trusts_rules,
                        LayerRays& rays, KnownEvidence& known);

}  // namespace illustrate
