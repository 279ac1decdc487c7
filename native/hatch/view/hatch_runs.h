// Parts of hatches, and the regions of tone that they lie in.
#pragma once

#include "hatch/hatches.h"
#include "tone/tone_regions.h"

namespace illustrate {

// What hatches a cell takes: none, those of one family, or of both in shadows and undercuts.
enum class Region : std::uint8_t { neither, single, shadow, undercut };

inline Region region_of(Tone level, Band band) {
  if (band != Band::nothing) return band == Band::undercut ? Region::undercut : Region::neither;
  if (level == Tone::midtone) return Region::single;
  return level == Tone::shadow ? Region::shadow : Region::neither;
}

// Whether a cell takes any.
inline bool is_hatched(const ToneMap& tone, std::size_t cell) {
  return region_of(tone.level[cell], tone.band[cell]) != Region::neither;
}

inline bool is_hatched_anywhere(const ToneMap& tone) {
  for (std::size_t cell = 0; cell < tone.level.size(); ++cell)
    if (is_hatched(tone, cell)) return true;
  return false;
}

inline bool is_crossed(Region region) {
  return region == Region::shadow || region == Region::undercut;
}

// Of a point of a hatch. Beyond all, where a cell at the outline is empty, a point goes with the
// one before it.
inline Region region_of(const ToneMap& tone, const Vec2& image) {
  const int cell = tone.cell_of(image);
  return cell == none ? Region::neither : region_of(tone.level[idx(cell)], tone.band[idx(cell)]);
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
