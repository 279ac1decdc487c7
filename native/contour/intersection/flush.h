// Flush parts: two connected parts of the surface overlap in one plane and face the same way, as
// where the end of a beam lies in the face of a wall. A render shows one face, which goes on
// unchanged beyond the edge of either; so an edge of one that lies within the face of the other is
// no line of a drawing.
//
// Planes no farther apart than IntersectionCurves::reach are one. A crease at which the surface
// rises from the plane is a line all the same, and so are open borders, and the seam of parts that
// only abut, since neither goes on beyond it. Overlaps of a connected part with itself are not
// looked for.
#pragma once

#include "contour/intersection/intersections.h"

namespace illustrate {

// How much may lie between two stretches of an edge that are one all the same, as at the seam of
// two parts, which both sides of the edge reach at different places; world units.
double flush_gap(double reach);

// From the flush triangles of these curves; by side and share, the stretches of a side apart.
std::vector<FlushEdge> flush_edges(const Surface& surface, const IntersectionCurves& curves);

// (points) Whether the segment that follows each point is no line: it runs along a flush edge of
// one sheet, which stands for it, or both its triangles are flush.
std::vector<std::uint8_t> flush_segments(const Surface& surface, const IntersectionCurves& curves);

}  // namespace illustrate
