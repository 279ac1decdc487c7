// Absolute labels of a path: its base, and the breaks where a cycle contradicts itself.
#pragma once

#include "visibility/evidence.h"
#include "visibility/labelled_path.h"

namespace illustrate {

// The labels of a path that contradict the rays least, by length of line, a break counted as so
// many pixels of wrong label. A cycle whose changes sum to zero has no break, unless it runs along
// the outside of the drawing at different labels; any other cycle has one at least. Arcs at the
// outside of the drawing have 0. No label is negative. trusts_rules: false where the crossings of
// the mesh are not worth it (a crowd of needles): a balanced cycle then breaks like any other.
LabelledPath label_path(const Arrangement& arrangement, const Path& path, bool trusts_rules,
                        LayerRays& rays, KnownEvidence& known);

}  // namespace illustrate
