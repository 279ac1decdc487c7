// Absolute labels: the base of every path, and the break where a cycle contradicts itself.
#pragma once

#include "core/progress.h"
#include "visibility/layer_rays.h"
#include "visibility/potential.h"

namespace illustrate {

// A path's arcs with the number of layers in front of each, at its start and at its end. They
// differ where the path had to be broken: in the arc's middle the label jumps against all rules.
struct LabelledPath {
  PathLabels labels;
  std::vector<int> at_start;      // (arcs)
  std::vector<int> at_end;        // (arcs)
  std::vector<int> break_sample;  // (arcs) where the jump is, if there is one

  bool is_broken(std::size_t arc) const { return at_start[arc] != at_end[arc]; }
};

// One for each path of the arrangement: the labels that contradict the rays least, by length of
// line, a break counted as so many pixels of wrong label. Where a cycle's changes do not sum to
// zero there is at least one break. Arcs at the outside of the drawing have 0. No label is
// negative.
std::vector<LabelledPath> label_paths(const Arrangement& arrangement, LayerRays& rays,
                                      const Progress& progress);

// Crossings whose back strand has fewer layers in front than the front strand.
std::vector<int> contradictions(const Arrangement& arrangement,
                                const std::vector<LabelledPath>& paths);

}  // namespace illustrate
