// The arcs of a path: what lies between two crossings, cusps or joints on it.
#pragma once

#include "visibility/arrangement/arrangement.h"

namespace illustrate {

// A stretch of a path between two visits or strand ends, on one strand. `begin` and `end` are the
// visits of that strand that bound it, none at the strand's own ends. On a closed strand with
// visits the last arc runs on round the start to the first visit.
struct PathArc {
  int strand;
  int begin;
  int end;
  int step;  // of the path: the index of the strand in it
  double length_px;
  std::array<StrandPlace, 3> samples;  // at its quarters
};

// In order along the path.
std::vector<PathArc> path_arcs(const Arrangement& arrangement, const Path& path);

// (paths)(arcs) of all paths.
std::vector<std::vector<PathArc>> arcs_of_paths(const Arrangement& arrangement);

// The sum of what a closed path's crossings and cusps change; 0 where its labels can all be true.
int imbalance(const Arrangement& arrangement, const Path& path);

}  // namespace illustrate
