// Normals of folds within a part that is not flat as a whole, turned to the side that its faces
// show.
#pragma once

#include "surface/subdivision/refined_mesh.h"

namespace illustrate {

// Where the limit of flat faces folds over itself (flat_faces.h), normals point the opposite way
// from those of all the control faces round them, and a silhouette would run round each: they are
// turned. Needles of `control` (level 0 of `mesh`) have no say. normals: of corner_sectors'.
void turn_folded_normals(const RefinedMesh& control, const RefinedMesh& mesh,
                         const std::vector<int>& corner_sectors, Points& normals);

}  // namespace illustrate
