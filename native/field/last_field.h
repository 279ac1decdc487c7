// A field that is near the last one: of the frame before, or of other guides and thresholds.
#pragma once

#include "field/cross_field.h"
#include "field/problem/edges.h"

namespace illustrate {

// (n) the crosses of the last field, turned with the edges round each vertex; 0 on objects that are
// not the same (surface/same_objects.h). Empty where there is no last field, or no such object.
CrossNumbers last_crosses(const Surface& surface, const TangentFrames& frames,
                          const TriangleEdges& edges, const FieldAids& aids,
                          const Progress& progress);

// (n) 1: no edge at the vertex has been stretched since the last surface: its cross can stay. Empty
// where `last_crosses` is, and on the last surface itself, whose field is of other options.
std::vector<std::uint8_t> resting_vertices(const Surface& surface, const TriangleEdges& edges,
                                           const FieldAids& aids);

}  // namespace illustrate
