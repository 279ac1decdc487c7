// The field of a surface that is put together of objects of others (surface/joined.h).
#pragma once

#include "field/families/families.h"
#include "surface/joined.h"

namespace illustrate {

// From the field on each of those surfaces, turned with each object. Energies count once for each
// object.
CrossField joined(const std::vector<const CrossField*>& fields,
                  const std::vector<const Surface*>& surfaces, const ObjectSources& sources);
Families joined(const std::vector<const Families*>& families,
                const std::vector<const Surface*>& surfaces, const ObjectSources& sources);

}  // namespace illustrate
