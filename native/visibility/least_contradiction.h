// The last resort: labels that jump against the rules where that contradicts the rays least.
#pragma once

#include "visibility/evidence.h"
#include "visibility/labelled_path.h"

namespace illustrate {

// Fills in the labels of a path whose arcs are known: the cheapest way through (arc, layers), where
// a label other than the ray's costs the arc's weight for each layer and a break its price in
// pixels of wrong label, times `dear`. `evidence`: one for each arc.
void label_with_breaks(LabelledPath& path, const std::vector<Evidence>& evidence, bool cyclic,
                       double dear);

}  // namespace illustrate
