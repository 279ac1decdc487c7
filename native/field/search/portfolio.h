// Several starts on the coarsest graph, fewer and fewer of them carried to the finer ones.
//
// A departure from section 5: from the principal directions any optimiser ends in a bad basin.
// Random starts are diffused, the best of them shaken; on the way to the finest graph the worst are
// dropped, since a coarse energy only hints at the final one. The number of starts, and of fields
// that are carried on, is bounded by that of the vertices, so that many small graphs cost no more
// than a large one.
#pragma once

#include "core/progress.h"
#include "field/problem/energy.h"

namespace illustrate {

// graph: connected. starts: fields of it that are tried besides the random ones. Returns a field
// near a good minimum; the same for the same input.
CrossNumbers portfolio_start(const FieldGraph& graph, const std::vector<CrossNumbers>& starts,
                             const Progress& progress);

}  // namespace illustrate
