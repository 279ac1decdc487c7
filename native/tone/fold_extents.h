// How far visible folds run on, for bands.h.
#pragma once

#include <vector>

#include "view/camera.h"
#include "visibility/labelled_graph.h"

namespace illustrate {

// Whether a curve is seen and separates a fold from what lies beyond it, or two sheets that meet.
bool is_visible_fold(const GraphArc& arc);

// Of visible folds, joined where they share a node.
struct FoldExtents {
  std::vector<double> from_start, from_end;  // (arcs) px from a node of it to the nearest end
  std::vector<double> length;                // (arcs) px
  std::vector<double> most;                  // (arcs) px

  // From a place `along` px along an arc, along the folds, to where they end: inside the frame no
  // other goes on there. Where they nowhere end, as round a tip that comes through a face, an
  // eighth of the length of all that are joined.
  double to_end(int arc, double along) const;
};

FoldExtents fold_extents(const LabelledGraph& graph, const Camera& camera);

}  // namespace illustrate
