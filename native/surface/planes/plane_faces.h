// Flat faces as the maker of a mesh meant them, however they are triangulated: what subdivision and
// jets cannot tell from a strip or from a patch of a smooth form. Not in the paper.
//
// Faces that lie in one plane beside each other, whatever edges are between them, are one piece. A
// piece is a flat face where creases and boundaries run all round it. Where it goes on smoothly it
// is one if it is large beside what it goes on into: faces of a rounded box beside the strips of
// its roundings. Faces of a cylinder, a sphere or a cage are as large as their neighbours.
#pragma once

#include "mesh/sanitize.h"
#include "surface/surface.h"

namespace illustrate {

// Writes the number of the flat face of each face into mesh.face_planes, counted from `first`; none
// where there is none. Of a mesh with a double cover none are looked for. Slivers belong to the
// plane that their vertices lie in. threads: 0 = all cores.
std::vector<PlaneFace> find_plane_faces(SoundMesh& mesh, int object, int first, int threads);

}  // namespace illustrate
