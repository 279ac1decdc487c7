// A field that is nearly a minimum, brought to it at all scales.
#pragma once

#include "core/progress.h"
#include "field/problem/energy.h"

namespace illustrate {

// Looks for the change of z (n) on aggregates of vertices, from large ones to single vertices: what
// an optimiser that sees neighbours only needs hundreds of steps for. The energy never rises.
void relax_at_all_scales(const FieldGraph& graph, CrossNumbers& z, const Progress& progress);

}  // namespace illustrate
