// The search for the best crosses of a graph, of each connected part as if there were no other:
// what becomes of one part does not change another by a bit.
#pragma once

#include "core/progress.h"
#include "field/cross_field.h"
#include "field/problem/energy.h"
#include "field/search/minimise.h"

namespace illustrate {

struct SearchStarts {
  CrossNumbers initial, principal;  // (n)
  // (n) the search stays near; empty, or 0 on a connected part: it goes far and wide.
  CrossNumbers nearby;
};

struct SearchResult {
  CrossNumbers z;           // (n)
  MinimiseResult minimise;  // whether all parts converged; the most evaluations of one of them
};

// Uses `start`, `max_evaluations` and `threads` of the options.
SearchResult search_crosses(const FieldGraph& graph, const SearchStarts& starts,
                            const FieldOptions& options, const Progress& progress);

}  // namespace illustrate
