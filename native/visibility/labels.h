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
  // Of a balanced path without breaks: its labels are base plus the offsets, and what other bases
  // would contradict of the rays, costs[b] for base b; above the last one all labels are above
  // their evidence.
  int base = 0;
  std::vector<double> costs;

  bool is_balanced() const { return !costs.empty(); }
  void move_base(int by);
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
// many pixels of wrong label. A cycle whose changes sum to zero has no break, unless it runs along
// the outside of the drawing at different labels; any other cycle has one at least. Arcs at the
// outside of the drawing have 0. No label is negative. trusts_rules: false where the crossings of
// the mesh are not worth it (a crowd of needles): a balanced cycle then breaks like any other.
LabelledPath label_path(const Arrangement& arrangement, const Path& path, bool trusts_rules,
                        LayerRays& rays, KnownEvidence& known);

// Crossings tie only the back path to itself: gives balanced paths other bases where, all in all,
// fewer crossings contradict their labels at little price in rays.
void settle_bases(const Arrangement& arrangement, std::vector<LabelledPath>& paths);

// Crossings whose back strand has fewer layers in front than the front strand.
std::vector<int> contradictions(const Arrangement& arrangement,
                                const std::vector<LabelledPath>& paths);

}  // namespace illustrate
