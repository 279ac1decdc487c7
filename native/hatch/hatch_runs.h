// Parts of hatches, and the regions of tone that they lie in.
#pragma once

#include "hatch/hatches.h"
#include "tone/tone_regions.h"

namespace illustrate {

// The region a point of a hatch lies in. Beyond all, where a cell at the outline is empty, a point
// goes with the one before it.
enum class Region : std::uint8_t { neither, single, shadow, undercut };

inline Region region_of(const ToneMap& tone, const Vec2& image) {
  const int cell = tone.cell_of(image);
  if (cell == none || tone.band[cell] == Band::mach_band) return Region::neither;
  if (tone.band[cell] == Band::undercut) return Region::undercut;
  if (tone.level[cell] == Tone::midtone) return Region::single;
  return tone.level[cell] == Tone::shadow ? Region::shadow : Region::neither;
}

// Points [from, to) of a hatch.
struct Run {
  int from;
  int to;
};

// The longest runs of points that are `chosen`.
template <class Chosen>
std::vector<Run> runs(const Run& within, const Chosen& chosen) {
  std::vector<Run> result;
  for (int from = within.from, to; from < within.to; from = to + 1) {
    for (to = from; to < within.to && chosen(to);) ++to;
    if (to > from) result.push_back({from, to});
  }
  return result;
}

inline double length_px(Span<const HatchPoint> curve) {
  double length = 0;
  for (std::size_t i = 1; i < curve.size(); ++i) {
    length += (curve[i].image - curve[i - 1].image).norm();
  }
  return length;
}

}  // namespace illustrate
