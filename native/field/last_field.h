// A field that is near the last one: of the frame before, or of other guides and thresholds.
#pragma once

#include "field/cross_field.h"
#include "field/edges.h"

namespace illustrate {

// (n) the crosses of the last field, turned with the edges round each vertex. Empty where there is
// none, or it belongs to other vertices (surface/same_vertices.h).
CrossNumbers last_crosses(const Surface& surface, const TangentFrames& frames,
                          const TriangleEdges& edges, const FieldAids& aids,
                          const Progress& progress);

}  // namespace illustrate
