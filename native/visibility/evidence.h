// What rays say of the arcs of a path.
#pragma once

#include <algorithm>
#include <map>

#include "visibility/layer_rays.h"
#include "visibility/potential.h"

namespace illustrate {

constexpr double missed_share = 0.75;
constexpr double outline_weight = 1e9;  // the outside of the drawing is certain: px of length

// What rays say of an arc: so many layers, or up to `unsure` more, worth so many pixels of line.
struct Evidence {
  int layers;
  int unsure;
  double weight;
  bool beside_nothing = false;

  // Pixels of wrong label where the arc has `label` layers. A ray that starts beside the curve
  // rather misses a layer than that it meets one too many.
  double against(int label) const {
    const int missed = std::max(label - layers - unsure, 0);
    const double share = beside_nothing ? 1 : missed_share;
    return weight * (std::max(layers - label, 0) + share * missed);
  }
};

// What was asked before, by strand and the crossings that bound the arc (none at the strand's
// ends).
using KnownEvidence = std::map<std::array<int, 3>, Evidence>;

// One for each arc: those at the outside of the drawing have 0 layers for certain, the others have
// weight 0.
std::vector<Evidence> outline_evidence(const Arrangement& arrangement,
                                       const std::vector<PathArc>& arcs);

// Adds what rays say of the longest of the other arcs.
void ask_rays(const Arrangement& arrangement, const std::vector<PathArc>& arcs, LayerRays& rays,
              KnownEvidence& known, std::vector<Evidence>& evidence);

}  // namespace illustrate
