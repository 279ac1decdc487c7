// Labels of a signed graph that cost little: which of two directions stays, all over a surface.
//
// The problem is that of a spin glass in a field: ties that contradict each other round a loop (a
// singularity of a cross) cannot all be satisfied, and least cost is hard to find. Multilevel
// search, as graphs are partitioned: on smaller and smaller graphs single nodes stand for larger
// and larger patches, so that moves of single nodes move borders at every scale (Walshaw,
// "Multilevel refinement for combinatorial optimisation problems", 2004; the moves: Fiduccia and
// Mattheyses 1982). Several searches compete on a graph of some thousand nodes; where their
// results differ each place takes the better one.
#pragma once

#include "core/progress.h"
#include "field/families/signed_graph.h"

namespace illustrate {

// The same for the same graph, whatever else there is and on any number of threads (0: all cores):
// each connected part is searched by itself. Not always the least cost, but no flip of one label
// costs less, and graphs of up to some ten nodes get the least. known: (n) the labels of parts that
// keep theirs, 0 in the others; empty: all are searched. Throws Cancelled through `progress`.
Labels cheap_labels(const SignedGraph& graph, int threads = 0, const Progress& progress = {},
                    Labels known = {});

// Labels near the given ones (n): borders move where that pays within some flips, and no label
// flips that has none near.
Labels nearby_labels(const SignedGraph& graph, Labels labels);

}  // namespace illustrate
