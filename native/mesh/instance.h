// The same mesh at another place.
#pragma once

#include <memory>

#include "mesh/polygon_mesh.h"

namespace illustrate {

// The mesh with its positions moved by an affine map (points as columns). Where that is a
// similarity, the result knows its original, and all that are made of one original share what is
// prepared of it. A mirror turns the winding of all faces round, so that front stays front.
// Throws InvalidInput where the map is not affine or not finite.
PolygonMesh instance(std::shared_ptr<const PolygonMesh> original, const Mat4& placement,
                     std::string name);

}  // namespace illustrate
