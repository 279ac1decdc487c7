// A path with its labels.
#pragma once

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
  // would contradict of the rays, costs[b] for base b.
  int base = 0;
  std::vector<double> costs;

  bool is_balanced() const { return !costs.empty(); }
  void move_base(int by);
  int breaks(std::size_t arc) const {
    return (at_start[arc] != along[arc]) + (along[arc] != at_end[arc]);
  }
};

}  // namespace illustrate
