#include "hatch/broad_tone.h"

#include <algorithm>
#include <cmath>

namespace illustrate {
namespace {

using Mask = std::vector<std::uint8_t>;

// Calls take(row) for all rows, down and then up.
template <class Take>
void down_and_up(int count, const Take& take) {
  for (int i = 0; i < count; ++i) take(i);
  for (int i = count; i-- > 0;) take(i);
}

// Cells at most `reach` cells from one of the mask, along a row and then along a column.
Mask grown(const Mask& mask, int width, int height, int reach) {
  Mask along = mask, result;
  for (int row = 0; row < height; ++row) {
    const auto first = static_cast<std::size_t>(row) * static_cast<std::size_t>(width);
    int since = reach + 1;
    down_and_up(width, [&](int column) {
      const std::size_t cell = first + idx(column);
      since = mask[cell] ? 0 : std::min(since, reach) + 1;
      along[cell] |= since <= reach;
    });
  }
  result = along;
  std::vector<int> since(idx(width), reach + 1);
  down_and_up(height, [&](int row) {
    const auto first = static_cast<std::size_t>(row) * static_cast<std::size_t>(width);
    for (int column = 0; column < width; ++column) {
      const std::size_t cell = first + idx(column);
      int& count = since[idx(column)];
      count = along[cell] ? 0 : std::min(count, reach) + 1;
      result[cell] |= count <= reach;
    }
  });
  return result;
}

template <class Chosen>
Mask cells_of(const ToneMap& tone, const Chosen& chosen) {
  Mask mask(tone.level.size());
  for (std::size_t cell = 0; cell < mask.size(); ++cell) {
    mask[cell] = chosen(tone.level[cell], tone.band[cell]);
  }
  return mask;
}

}  // namespace

ToneMap broadened(const ToneMap& tone, double px) {
  const int reach = static_cast<int>(std::ceil(px / tone.cell_px));
  const auto is_dark = [](Tone level, Band band) {
    return band == Band::undercut || (band == Band::nothing && level == Tone::shadow);
  };
  const auto is_hatched = [&](Tone level, Band band) {
    return is_dark(level, band) || (band == Band::nothing && level == Tone::midtone);
  };
  const Mask dark = grown(cells_of(tone, is_dark), tone.width, tone.height, reach);
  const Mask hatched = grown(cells_of(tone, is_hatched), tone.width, tone.height, reach);
  ToneMap broad = tone;
  std::fill(broad.band.begin(), broad.band.end(), Band::nothing);
  for (std::size_t cell = 0; cell < broad.level.size(); ++cell) {
    if (tone.level[cell] == Tone::nothing) continue;
    broad.level[cell] = dark[cell] ? Tone::shadow : hatched[cell] ? Tone::midtone : Tone::highlight;
  }
  return broad;
}

}  // namespace illustrate
