// The field of objects that share their surface (surface/instances.h).
#pragma once

#include "field/families/families.h"
#include "surface/instances.h"

namespace illustrate {

// The field of the originals, turned with each object. Energies count once for each object.
CrossField placed(const CrossField& field, const Surface& originals, const Instances& instances);
Families placed(const Families& families, const Surface& originals, const Instances& instances);

}  // namespace illustrate
