#include "hatch/view/broad_tone.h"

#include <algorithm>
#include <cmath>

#include "hatch/view/hatch_runs.h"

namespace illustrate {
namespace {

using Mask = std::vector<std::uint8_t>;

// Cells at most `reach` cells from one of the mask along their row: run by run.
Mask grown_along_rows(const Mask& mask, int width, int height, int reach) {
  Mask result = mask;
  for (int row = 0; row < height; ++row) {
    const auto begin = mask.begin() + row * width, end = begin + width;
    const auto grown = result.begin() + row * width;
    for (auto from = std::find(begin, end, 1), to = from; from != end;
         from = std::find(to, end, 1)) {
      to = std::find(from, end, 0);
      std::fill(grown + std::max(0, static_cast<int>(from - begin) - reach),
                grown + std::min(width, static_cast<int>(to - begin) + reach), std::uint8_t{1});
    }
  }
  return result;
}

// The same along their column: row by row, as cells lie in memory.
Mask grown_along_columns(const Mask& mask, int width, int height, int reach) {
  Mask result = mask;
  std::vector<int> since(idx(width));  // rows since the last of the mask, `reach + 1` at most
  const auto take = [&](int row) {
    const std::uint8_t* masked = mask.data() + idx(row) * idx(width);
    std::uint8_t* grown = result.data() + idx(row) * idx(width);
    for (int column = 0; column < width; ++column) {
      const int count = masked[column] ? 0 : std::min(since[column], reach) + 1;
      since[column] = count;
      grown[column] |= count <= reach;
    }
  };
  std::fill(since.begin(), since.end(), reach + 1);
  for (int row = 0; row < height; ++row) take(row);
  std::fill(since.begin(), since.end(), reach + 1);
  for (int row = height; row-- > 0;) take(row);
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
