// The ways to break a mesh.
#pragma once

#include <vector>

#include "mesh/polygon_mesh.h"
#include "tests/fuzz/random.h"

namespace illustrate::fuzz {

// Faces as lists, since most of what is done here changes their lengths.
struct LooseMesh {
  Points positions;
  std::vector<std::vector<int>> faces;
};

using Mutation = void (*)(LooseMesh&, Random&);

// One defect each. All cope with meshes without vertices or faces.
const std::vector<Mutation>& mutations();

// A number that arithmetic dislikes: not finite, huge, tiny, a zero of either sign.
double nasty_number(Random& random);

}  // namespace illustrate::fuzz
