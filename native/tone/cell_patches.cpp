#include "tone/cell_patches.h"

#include <algorithm>
#include <utility>

#include "core/disjoint_sets.h"

namespace illustrate {
namespace {

constexpr double least_highlight = 1.0 / 3;  // of the area of others: light is spared in dots

}  // namespace

SeenObjects::SeenObjects(const Surface& surface, const VisibleImage& visible)
    : width(visible.width), height(visible.height) {
  of_cell.reserve(visible.triangle.size());
  for (const int t : visible.triangle) {
    const int object = t == none ? none : surface.object_of(t);
    of_cell.push_back(object);
    if (object == none) continue;
    if (idx(object) >= areas.size()) areas.resize(idx(object) + 1);
    ++areas[idx(object)];
  }
}

// Each run is a patch of its own until those that are connected are united.
CellPatches::CellPatches(const SeenObjects& seen, const std::vector<Tone>& level)
    : object_areas_(seen.areas) {
  std::size_t above = 0;
  for (int row = 0; row < seen.height; ++row) {
    const std::size_t begin = runs_.size();
    add_row(seen, level, row);
    meet_row_above(above, begin, seen.width);
    above = begin;
  }
  unite();
}

void CellPatches::add_row(const SeenObjects& seen, const std::vector<Tone>& level, int row) {
  const int first = row * seen.width, end = first + seen.width;
  for (int cell = first; cell < end;) {
    const int object = seen.of_cell[idx(cell)], begin = cell;
    const Tone tone = level[idx(cell)];
    while (cell < end && seen.of_cell[idx(cell)] == object && level[idx(cell)] == tone) ++cell;
    if (object == none) continue;
    const auto patch = static_cast<int>(patches_.size());
    const bool meets_last = begin > first && !runs_.empty() && runs_.back().end == begin &&
                            patches_.back().object == object;
    if (meets_last) borders_.push_back({patch - 1, patch, 1});
    runs_.push_back({begin, cell, patch});
    patches_.push_back({object, cell - begin, tone});
  }
}

// above, row: first runs of two consecutive rows, the second one the last.
void CellPatches::meet_row_above(std::size_t above, std::size_t row, int width) {
  for (std::size_t a = above, b = row; a < row && b < runs_.size();) {
    const int end_above = runs_[a].end + width, end = runs_[b].end;
    const int shared = std::min(end_above, end) - std::max(runs_[a].begin + width, runs_[b].begin);
    const int patch_above = runs_[a].patch, patch = runs_[b].patch;
    if (shared > 0 && patches_[idx(patch_above)].object == patches_[idx(patch)].object) {
      borders_.push_back({patch_above, patch, shared});
    }
    if (end_above <= end) ++a;
    if (end <= end_above) ++b;
  }
}

// Patches side by side that have one tone become one.
void CellPatches::unite() {
  DisjointSets joined(patches_.size());
  for (const Border& border : borders_) {
    if (patches_[idx(border.a)].tone == patches_[idx(border.b)].tone)
      joined.join(border.a, border.b);
  }
  std::vector<int> now(patches_.size());
  std::vector<Patch> united;
  for (std::size_t p = 0; p < patches_.size(); ++p) {
    const auto root = idx(joined.root(static_cast<int>(p)));
    now[p] = root == p ? static_cast<int>(united.size()) : now[root];
    if (root == p) {
      united.push_back(patches_[p]);
    } else {
      united[idx(now[p])].cells += patches_[p].cells;
    }
  }
  patches_ = std::move(united);
  for (Run& run : runs_) run.patch = now[idx(run.patch)];
  for (Border& border : borders_) border = {now[idx(border.a)], now[idx(border.b)], border.cells};
  borders_.erase(std::remove_if(borders_.begin(), borders_.end(),
                                [](const Border& border) { return border.a == border.b; }),
                 borders_.end());
}

// Patches join larger ones alone, so that two do not change places.
bool CellPatches::is_less(int a, int b) const {
  return std::make_pair(patches_[idx(a)].cells, a) < std::make_pair(patches_[idx(b)].cells, b);
}

bool CellPatches::join_small(const std::function<double(double object_cells)>& least_cells) {
  std::vector<std::array<int, tones>> along(patches_.size(), {0, 0, 0});
  for (const Border& border : borders_) {
    const auto [less, other] = is_less(border.a, border.b) ? std::make_pair(border.a, border.b)
                                                           : std::make_pair(border.b, border.a);
    along[idx(less)][static_cast<std::size_t>(patches_[idx(other)].tone)] += border.cells;
  }
  bool any = false;
  for (std::size_t p = 0; p < patches_.size(); ++p) {
    Patch& patch = patches_[p];
    const auto most = std::max_element(along[p].begin(), along[p].end());
    if (*most == 0) continue;
    const double least = least_cells(object_areas_[idx(patch.object)]);
    if (patch.cells >= (patch.tone == Tone::highlight ? least_highlight * least : least)) continue;
    patch.tone = static_cast<Tone>(most - along[p].begin());
    any = true;
  }
  if (any) unite();
  return any;
}

void CellPatches::write(std::vector<Tone>& level) const {
  for (const Run& run : runs_) {
    std::fill(level.begin() + run.begin, level.begin() + run.end, patches_[idx(run.patch)].tone);
  }
}

}  // namespace illustrate
