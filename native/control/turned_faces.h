// Faces that lie level with what goes on from them, and that their limit turns over all the same.
//
// CAD models fill flat and nearly flat parts with needles beside large triangles. The limit of a
// vertex slides within the surface by a part of the large ones, farther than the needles are high:
// these turn over, and a silhouette runs through a flat face. It does no harm to leave the limit
// for the points of the mesh there (control/arc_faces.h), since what is level is the same surface
// wherever its points are.
#pragma once

#include "control/limit_masks.h"

namespace illustrate {

// (n) how far the surface has to leave the limit, at least `weights` (n, 0 .. 1): wholly at faces
// that turn over and all within three faces of them that no crease parts, and again where faces
// turn over then, at most eight times; by less where a piece of a face, which is split once, keeps
// a tenth of its area or less, and where a face does not lie level with its smooth neighbours:
// those that turn by 5 degrees do, those that turn by 15 do not. limits: of the mesh split once.
std::vector<double> weights_of_turned_faces(const SoundMesh& mesh, const HalfEdges& edges,
                                            const LimitPlaces& limits, std::vector<double> weights);

}  // namespace illustrate
