// Families that stay as they were: of the frame before.
#pragma once

#include "field/families/families.h"

namespace illustrate {

// (n) the last families, their directions moved along with the edges round each vertex, as those of
// this field; 0 on objects that are not the same. Empty where there are none, or no such object.
Families last_families(const Surface& surface, const CrossField& field, const LastFamilies& last);

}  // namespace illustrate
