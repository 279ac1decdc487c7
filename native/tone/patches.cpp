#include "tone/patches.h"

#include <algorithm>
#include <cmath>

#include "core/rise.h"
#include "tone/cell_patches.h"

namespace illustrate {
namespace {

constexpr double window_share = 0.25;       // of a patch's side, that edges are evened out over
constexpr double least_undercut = 1.0 / 3;  // of a patch's area: undercuts are narrow and dense
constexpr int most_rounds = 3;
// In areas of a patch: of a smaller object nothing is joined, of a larger one all that is small.
constexpr double small_object = 2, large_object = 6;
constexpr double most_work = 16;  // areas of the image that the boxes of all objects may cover

struct Box {
  int left = 0, top = 0, right = 0, bottom = 0;  // right and bottom are beyond it

  void add(int column, int row) {
    if (right == 0) *this = {column, row, column + 1, row + 1};
    left = std::min(left, column);
    top = std::min(top, row);
    right = std::max(right, column + 1);
    bottom = std::max(bottom, row + 1);
  }
  int width() const { return right - left; }
  int height() const { return bottom - top; }
};

// How many cells of each tone there are, packed side by side: sums and differences are those of
// each as long as no window has more than two million cells.
using Counts3 = std::uint64_t;
constexpr int count_bits = 21;
Counts3 one_of(Tone tone) { return Counts3{1} << (count_bits * static_cast<int>(tone)); }
std::int64_t count_of(Counts3 counts, Tone tone) {
  return static_cast<std::int64_t>((counts >> (count_bits * static_cast<int>(tone))) &
                                   ((Counts3{1} << count_bits) - 1));
}

// The darker one where two halves are equal.
Tone median_of(Counts3 counts) {
  const std::int64_t light = count_of(counts, Tone::highlight);
  const std::int64_t dark = count_of(counts, Tone::shadow);
  const std::int64_t all = light + dark + count_of(counts, Tone::midtone);
  if (2 * dark >= all) return Tone::shadow;
  return 2 * light > all ? Tone::highlight : Tone::midtone;
}

// Gives each cell the median tone of the cells of its object round it.
class Evener {
 public:
  // level: (cells)
  Evener(const SeenObjects& seen, std::vector<Tone>& level)
      : width_(seen.width), height_(seen.height), object_(seen.of_cell), level_(level) {}

  // Over squares of 2 reach + 1 cells.
  void even_out(int reach) {
    const std::vector<Box> boxes = boxes_of_objects();
    double work = 0;
    for (const Box& box : boxes) work += static_cast<double>(box.width()) * box.height();
    if (work > most_work * static_cast<double>(level_.size())) return;
    const std::vector<Tone> before = level_;
    for (std::size_t object = 0; object < boxes.size(); ++object) {
      if (boxes[object].width() > 0)
        even_out(static_cast<int>(object), boxes[object], reach, before);
    }
  }

 private:
  std::size_t cell(int column, int row) const { return idx(row) * idx(width_) + idx(column); }

  std::vector<Box> boxes_of_objects() const {
    std::vector<Box> boxes;
    for (int row = 0; row < height_; ++row) {
      for (int column = 0; column < width_; ++column) {
        const int object = object_[cell(column, row)];
        if (object == none) continue;
        if (idx(object) >= boxes.size()) boxes.resize(idx(object) + 1);
        boxes[idx(object)].add(column, row);
      }
    }
    return boxes;
  }

  void even_out(int object, const Box& box, int reach, const std::vector<Tone>& before) {
    const auto columns = idx(box.width()) + 1;
    std::vector<Counts3> sums(columns * (idx(box.height()) + 1), 0);  // left of and above
    for (int row = 0; row < box.height(); ++row) {
      Counts3 in_row = 0;
      for (int column = 0; column < box.width(); ++column) {
        const std::size_t here = cell(box.left + column, box.top + row);
        if (object_[here] == object) in_row += one_of(before[here]);
        sums[(idx(row) + 1) * columns + idx(column) + 1] =
            sums[idx(row) * columns + idx(column) + 1] + in_row;
      }
    }
    for (int row = 0; row < box.height(); ++row) {
      const auto above = idx(std::max(row - reach, 0)) * columns;
      const auto below = idx(std::min(row + reach + 1, box.height())) * columns;
      for (int column = 0; column < box.width(); ++column) {
        const std::size_t here = cell(box.left + column, box.top + row);
        if (object_[here] != object) continue;
        const auto left = idx(std::max(column - reach, 0));
        const auto right = idx(std::min(column + reach + 1, box.width()));
        level_[here] = median_of(sums[below + right] - sums[below + left] - sums[above + right] +
                                 sums[above + left]);
      }
    }
  }

  const int width_, height_;
  const std::vector<int>& object_;  // (cells) none where nothing is seen
  std::vector<Tone>& level_;
};

}  // namespace

void settle_patches(const Surface& surface, const VisibleImage& visible, double patch_px,
                    ToneMap& tone) {
  const double side = patch_px / tone.cell_px;  // in cells
  if (!(side > 0)) return;
  const SeenObjects seen(surface, visible);
  const int reach = static_cast<int>(std::min(side * window_share / 2, 500.0));
  if (reach > 0) Evener(seen, tone.level).even_out(reach);
  const auto least_cells = [least = side * side](double cells) {
    return least * rise(cells / least, small_object, large_object);
  };
  CellPatches patches(seen, tone.level);
  for (int round = 0; round < most_rounds && patches.join_small(least_cells); ++round) continue;
  patches.write(tone.level);
  for (std::size_t cell = 0; cell < tone.extra.size(); ++cell) {
    if (tone.level[cell] != Tone::shadow) tone.extra[cell] = 0;
  }
}

void drop_small_undercuts(const Surface& surface, const VisibleImage& visible, double patch_px,
                          ToneMap& tone) {
  const double side = patch_px / tone.cell_px;  // in cells
  if (!(side > 0)) return;
  std::vector<Tone> level;
  level.reserve(tone.band.size());
  for (const Band band : tone.band) {
    level.push_back(band == Band::undercut ? Tone::shadow : Tone::highlight);
  }
  CellPatches patches(SeenObjects(surface, visible), level);
  if (!patches.join_small([&](double) { return least_undercut * side * side; })) return;
  patches.write(level);
  for (std::size_t cell = 0; cell < tone.band.size(); ++cell) {
    if (tone.band[cell] == Band::undercut && level[cell] != Tone::shadow)
      tone.band[cell] = Band::nothing;
  }
}

}  // namespace illustrate
