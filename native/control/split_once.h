// One level of Catmull-Clark's or Loop's scheme, as a mesh of its own.
//
// The vertices are first those of the parent, then one for each edge, then, with Catmull-Clark, one
// for each face. Everything that the parent carries goes on: creases (semi-sharp ones a step
// softer, as OpenSubdiv has it), corners, marks, seams, materials, holes, twins. So the limit
// surface with `cage_points` is that of the parent, and its materials, marks and seams lie where
// they did.
#pragma once

#include "control/half_edges.h"

namespace illustrate {

// The split mesh, still without points, and without corner normals. The children of a face stand
// side by side, one for each of its corners in their order; with Loop's scheme the middle one
// follows. A new vertex gets a number in source_vertices that no vertex of the input has; copies of
// one place, on both sides of a seam or on both sheets, share it. The parent's boundary rule is
// `edges`, as with all that is no cage. scheme: catmull_clark, or loop for triangles.
SoundMesh split_once(const SoundMesh& parent, const HalfEdges& edges, Scheme scheme);

// The points that the scheme gives to the split mesh (OpenSubdiv's rules).
Points cage_points(const SoundMesh& parent, const HalfEdges& edges, Scheme scheme);

}  // namespace illustrate
