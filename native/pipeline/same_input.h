// Whether two inputs are the same to the byte.
#pragma once

#include "pipeline/options.h"

namespace illustrate {

// All but the reflectance, which shapes nothing.
bool is_same(const PolygonMesh& a, const PolygonMesh& b);
// The same but for where they are, what they are called, and how long their edges may be.
bool has_same_form(const PolygonMesh& a, const PolygonMesh& b);
// Positions and shading normals.
bool has_same_place(const PolygonMesh& a, const PolygonMesh& b);
// Threads never change a result and are not compared.
bool is_same(const SurfaceOptions& a, const SurfaceOptions& b);
bool is_same(const JetOptions& a, const JetOptions& b);
bool is_same(const FieldOptions& a, const FieldOptions& b);

}  // namespace illustrate
