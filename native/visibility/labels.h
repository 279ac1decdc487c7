// Absolute labels: the base of every path, and the break where a cycle contradicts itself.
#pragma once

#include <map>

#include "visibility/layer_rays.h"
#include "visibility/potential.h"

namespace illustrate {

// A path's arcs with the number of layers in front of each: at its start, along it, at its end.
// They differ where the path had to be broken: just behind an arc's start or just before its end
// the label then jumps against all rules.
struct LabelledPath {
  PathLabels labels;
  std::vector<int> at_start;  // (arcs)
  std::vector<int> along;     // (arcs)
  std::vector<int> at_end;    // (arcs)

  int breaks(std::size_t arc) const {
    return (at_start[arc] != along[arc]) + (along[arc] != at_end[arc]);
  }
};

// What rays say of an arc: so many layers, worth so many pixels of line.
struct Evidence {
  int layers;
  double weight;
};

// What was asked before, by strand and the crossings that bound the arc (none at the strand's
// ends).
using KnownEvidence = std::map<std::array<int, 3>, Evidence>;

// The labels of a path that contradict the rays least, by length of line, a break counted as so
// many pixels of wrong label. Where a cycle's changes do not sum to zero there is at least one
// break. Arcs at the outside of the drawing have 0. No label is negative.
LabelledPath label_path(const Arrangement& arrangement, const Path& path, LayerRays& rays,
                        KnownEvidence& known);

// Crossings whose back strand has fewer layers in front than the front strand.
std::vector<int> contradictions(const Arrangement& arrangement,
                                const std::vector<LabelledPath>& paths);

}  // namespace illustrate
