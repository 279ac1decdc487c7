// The streamlines of a view with the grid that finds them.
#pragma once

#include "hatch/view/hatch_view.h"

namespace illustrate {

class StreamlineSet {
 public:
  // box: where streamlines are expected (streamline_grid.h).
  explicit StreamlineSet(const HatchView& view, const Eigen::AlignedBox2d& box = {})
      : grid(view.empty_grid(box)) {}

  void add(Streamline streamline) {
    grid.add(streamline, static_cast<int>(streamlines.size()));
    streamlines.push_back(std::move(streamline));
  }
  // After nodes were moved, added or taken away. Streamlines of fewer than two nodes go.
  void rebuild() {
    streamlines.erase(
        std::remove_if(streamlines.begin(), streamlines.end(),
                       [](const Streamline& streamline) { return streamline.nodes.size() < 2; }),
        streamlines.end());
    grid.assign(streamlines);
  }
  // Shorter ones, in spacings, go.
  void drop_shorter(double least) {
    for (Streamline& streamline : streamlines) {
      if (streamline.is_fixed || any_is_held(streamline.nodes)) continue;
      if (length_of(streamline.nodes) < least * streamline.spacing) streamline.nodes.clear();
    }
    rebuild();
  }

  Streamlines streamlines;
  StreamlineGrid grid;
  std::int64_t steps = 0;  // of growing ends
};

}  // namespace illustrate
