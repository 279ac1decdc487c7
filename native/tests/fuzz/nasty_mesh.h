// Meshes that nobody would make on purpose, by seed: good shapes and soups, broken in several ways
// at once, with creases, corners, marks, materials and holes of any value.
#pragma once

#include "mesh/polygon_mesh.h"
#include "tests/fuzz/random.h"

namespace illustrate::fuzz {

// The arrays always fit together: `validate` accepts every one.
PolygonMesh nasty_mesh(Random& random);

}  // namespace illustrate::fuzz
