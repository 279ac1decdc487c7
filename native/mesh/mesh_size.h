// How large meshes are (core/spread.h).
#pragma once

#include "core/similarity.h"
#include "core/spread.h"
#include "mesh/faces.h"
#include "mesh/sanitize.h"

namespace illustrate {

// All faces where they are placed, polygons as fans.
void add_faces(const SoundMesh& mesh, const Similarity& placement, Spread& spread);

// Of the mesh by itself, world units.
double diagonal(const SoundMesh& mesh);
double diagonal(const Faces& faces, const Points& positions);

}  // namespace illustrate
