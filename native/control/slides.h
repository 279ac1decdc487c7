// Where the limit of a mesh slides from its vertices within itself, to longer edges.
#pragma once

#include "control/limit_masks.h"

namespace illustrate {

// (n) 0 .. 1 how far the surface has to leave the limit for arcs (control/arc_faces.h). A smooth
// vertex slides wholly where the limit is off within the surface by more than 1.4 of the shortest
// edge at it, not at all below .7, nor where nobody sees it (smoothstep(.75, 2.25) of pixels of a
// drawing in which the object's diagonal has 1400). Counted are those of flat faces (face_planes),
// and what goes on from them sliding as far: a rounding from rim to rim. And as far all vertices
// within three edges of these: beside one that slides are others that slide less, and what held one
// of them alone would ripple.
// Beside no flat face vertices slide as well, at slivers of scans and of metaballs, and do no harm:
// what is bent evenly is the same surface wherever its vertices are; unless a face turns over
// (control/turned_faces.h), which is counted wherever it is.
// limits: of the mesh split once. diagonal: of the mesh.
std::vector<double> slides(const SoundMesh& mesh, const HalfEdges& edges, const LimitPlaces& limits,
                           double diagonal);

}  // namespace illustrate
