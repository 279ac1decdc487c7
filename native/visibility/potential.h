// Relative labels: what quantitative invisibility does along each path.
#pragma once

#include "visibility/arrangement.h"

namespace illustrate {

// A stretch of a path between two visits or strand ends, on one strand. `begin` and `end` are the
// visits of that strand that bound it, none at the strand's own ends. On a closed strand with
// visits the last arc runs on round the start to the first visit.
struct PathArc {
  int strand;
  int begin;
  int end;
  int offset;        // invisibility minus the path's base
  bool starts_free;  // at a demoted crossing or cusp: the label may change otherwise there
  double length_px;
  std::array<StrandPlace, 5>
      samples;  // just behind its start, at its quarters, just before its end
};

struct PathLabels {
  std::vector<PathArc> arcs;
  int residual = 0;  // cyclic paths: sum of all changes; 0 where the labels can be true

  // Change of invisibility from arc i to the next one, on a cyclic path from the last to the first.
  int change_behind(std::size_t i) const {
    if (i + 1 < arcs.size()) return arcs[i + 1].offset - arcs[i].offset;
    return arcs.front().offset - arcs.back().offset + residual;
  }
};

// The residual of relative_labels alone.
int imbalance(const Arrangement& arrangement, const Path& path);

PathLabels relative_labels(const Arrangement& arrangement, const Path& path);

}  // namespace illustrate
