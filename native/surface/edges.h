// Outlines of flat areas, and the list of edges that are drawn or end something (paper section 4).
#pragma once

#include "surface/surface.h"

namespace illustrate {

// Turns smooth edges round flat areas into EdgeKind::flat_outline. A flat area is grown from its
// first triangle: connected triangles, three at least, whose normals agree with that one's within
// tolerance::flat_rad. On a mesh that is no cage it takes in what lies in its plane beside it,
// slivers and folds within the plane; its inner vertices get its normal and no curvature.
// surface.diagonal stands. threads: 0 = all cores.
void mark_flat_outlines(Surface& surface, int threads);

// Fills feature_edges and feature_kinds from edge_kinds.
void collect_feature_edges(Surface& surface);

}  // namespace illustrate
