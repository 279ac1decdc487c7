#include "hatch/view/broad_tone.h"

#include <algorithm>
#include <cmath>

#include "hatch/view/hatch_runs.h"

namespace illustrate {
namespace {

using Mask = std::vector<std::uint8_t>;

// Calls take(i) for all i, up and then down.
template <class Take>
void down_and_up(int count, const Take& take) {
  for (int i = 0; i < count; ++i) take(i);
  for (int i = count; i-- > 0;) take(i);
}

// Cells at most `reach` cells from one of the mask along their row.
Mask grown_along_rows(const Mask& mask, int width, int height, int reach) {
  Mask result = mask;
  for (int row = 0; row < height; ++row) {
    const std::size_t first = idx(row) * idx(width);
    int since = reach + 1;
    down_and_up(width, [&](int column) {
      const std::size_t cell = first + idx(column);
      since = mask[cell] ? 0 : std::min(since, reach) + 1;
      result[cell] |= since <= reach;
    });
  }
  return result;
}

// The same along their column: row by row, as cells lie in memory.
Mask grown_along_columns(const Mask& mask, int width, int height, int reach) {
  Mask result = mask;
  std::vector<int> since(idx(width), reach + 1);
  down_and_up(height, [&](int row) {
    const std::size_t first = idx(row) * idx(width);
    for (int column = 0; column < width; ++column) {
      int& count = since[idx(column)];
      count = mask[first + idx(column)] ? 0 : std::min(count, reach) + 1;
      result[first + idx(column)] |= count <= reach;
    }
  });
  return result;
}

// Cells with one near whose region is chosen.
template <class Chosen>
Mask grown(const ToneMap& tone, const Chosen& chosen, double px) {
  const int reach = static_cast<int>(std::ceil(px / tone.cell_px));
  Mask mask(tone.level.size());
  for (std::size_t cell = 0; cell < mask.size(); ++cell) {
    mask[cell] = chosen(region_of(tone.level[cell], tone.band[cell]));
  }
  return grown_along_columns(grown_along_rows(mask, tone.width, tone.height, reach), tone.width,
                             tone.height, reach);
}

}  // namespace

ToneMap broadened(const ToneMap& tone, double midtone_px, double shadow_px) {
  const auto is_hatched = [](Region region) { return region != Region::neither; };
  const Mask dark = grown(tone, is_crossed, shadow_px);
  const Mask hatched = grown(tone, is_hatched, midtone_px);
  ToneMap broad = tone;
  std::fill(broad.band.begin(), broad.band.end(), Band::nothing);
  for (std::size_t cell = 0; cell < broad.level.size(); ++cell) {
    if (tone.level[cell] == Tone::nothing) continue;
    broad.level[cell] = dark[cell] ? Tone::shadow : hatched[cell] ? Tone::midtone : Tone::highlight;
  }
  return broad;
}

}  // namespace illustrate
