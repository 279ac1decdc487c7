// Stage `visibility`: crossings in the image and the number of layers in front of every arc
// (paper section 4.4; departure: labels that cannot contradict each other take the place of the
// vote).
//
// Image points are rounded to a grid of 2^-16 px; crossings are decided with exact predicates and a
// symbolic perturbation by index, so that two closed curves always cross an even number of times.
// Quantitative invisibility is then a potential along each path of strands: it changes only where
// the path passes behind another curve and at cusps. Rays beside the arcs say how many layers there
// are. The labels of all arcs are the solution of one convex problem (view_labels.h), in which a
// broken rule has a price; where one gives way its crossing or cusp becomes a joint, so that no
// crossing of the result contradicts its labels. Crossings that only the interpolation has made are
// repaired first (repairs.h).
#pragma once

#include "contour/intersection/intersections.h"
#include "contour/network/curve_network.h"
#include "core/progress.h"
#include "mesh/bvh.h"
#include "surface/surface.h"
#include "view/camera.h"
#include "visibility/labelled_graph.h"

namespace illustrate {

// A view of more than 200,000 crossings, or of an incomplete network, is sampled instead
// (label_pile.h), and says so: "sampled_views" counts it. The result is the same for any number of
// threads (0: all cores).
//
// insets: IntersectionCurves', by which surfaces that touch are told apart.
//
// Adds "crossings", "rays", "loops", "unbalanced_loops", "repairs" to `counts`, the repairs by kind
// too: "repaired_twists", "repaired_swallowtails", "repaired_labels"; and
// "dropped_touches" apart: crossings next to joints that are no crossings (repairs.h).
LabelledGraph label_network(const CurveNetwork& network, const Surface& surface, const Bvh& bvh,
                            const Camera& camera, Counts& counts, const Progress& progress = {},
                            int threads = 1, const Insets& insets = {});

}  // namespace illustrate
