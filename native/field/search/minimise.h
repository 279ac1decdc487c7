// The last stage: NLopt's LD_LBFGS on u = 4 theta, without constraints (paper section 5, step 4).
#pragma once

#include "core/progress.h"
#include "field/problem/energy.h"

namespace illustrate {

struct MinimiseResult {
  bool converged = false;
  int evaluations = 0;
};

// Moves z (n) to a minimum of the graph's energy nearby; never to a point with more energy.
// When NLopt gives up, the best point so far is kept; `converged` is whether it is a minimum.
MinimiseResult minimise(const FieldGraph& graph, int max_evaluations, int threads, CrossNumbers& z,
                        const Progress& progress);

}  // namespace illustrate
