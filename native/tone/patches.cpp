#include "tone/patches.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/disjoint_sets.h"
#include "core/rise.h"

namespace illustrate {
namespace {

constexpr double window_share = 0.25;        // of a patch's side, that edges are evened out over
constexpr double least_highlight = 1.0 / 3;  // of the area of a patch: light is spared in dots
constexpr double least_undercut = 1.0 / 3;   // the same of undercuts, which are narrow and dense
constexpr int most_rounds = 3;
// In areas of a patch: of a smaller object nothing is joined, of a larger one all that is small.
constexpr double small_object = 2, large_object = 6;
constexpr double most_work = 16;  // areas of the image that the boxes of all objects may cover
constexpr int tones = 3;

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

class Patches {
 public:
  Patches(const Surface& surface, const VisibleImage& visible, ToneMap& tone)
      : width_(tone.width), height_(tone.height), level_(tone.level) {
    object_.reserve(visible.triangle.size());
    for (const int t : visible.triangle) object_.push_back(t == none ? none : surface.object_of(t));
    for (const int object : object_) {
      if (object == none) continue;
      if (idx(object) >= object_area_.size()) object_area_.resize(idx(object) + 1);
      ++object_area_[idx(object)];
    }
  }

  // Medians over squares of 2 reach + 1 cells.
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

  // least_cells(cells): of a patch that stays, on an object of so many. Whether anything changed.
  template <class Least>
  bool join_small(const Least& least_cells) {
    find_patches();
    std::vector<std::array<int, tones>> borders(area_.size(), {0, 0, 0});
    visit_neighbours([&](std::size_t a, std::size_t b) {
      if (object_[a] != object_[b] || patch_[a] == patch_[b]) return;
      const bool a_joins = is_less(patch_[a], patch_[b]);
      ++borders[idx(a_joins ? patch_[a] : patch_[b])]
               [static_cast<std::size_t>(level_[a_joins ? b : a])];
    });
    bool changed = false;
    std::vector<Tone> wanted = tone_;
    for (std::size_t p = 0; p < area_.size(); ++p) {
      const double on_object = least_cells(object_area_[idx(patch_object_[p])]);
      const double least = tone_[p] == Tone::highlight ? least_highlight * on_object : on_object;
      const auto most = std::max_element(borders[p].begin(), borders[p].end());
      if (area_[p] >= least || *most == 0) continue;
      wanted[p] = static_cast<Tone>(most - borders[p].begin());
      changed = true;
    }
    if (!changed) return false;
    for (std::size_t cell = 0; cell < level_.size(); ++cell) {
      if (patch_[cell] != none) level_[cell] = wanted[idx(patch_[cell])];
    }
    return true;
  }

 private:
  std::size_t cell(int column, int row) const { return idx(row) * idx(width_) + idx(column); }

  // Patches join larger ones alone, so that two do not change places.
  bool is_less(int a, int b) const {
    return std::make_pair(area_[idx(a)], a) < std::make_pair(area_[idx(b)], b);
  }

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

  // Calls visit(cell, neighbour) for all seen cells side by side, each pair once.
  template <class Visit>
  void visit_neighbours(const Visit& visit) const {
    for (int row = 0; row < height_; ++row) {
      for (int column = 0; column < width_; ++column) {
        const std::size_t here = cell(column, row);
        if (object_[here] == none) continue;
        if (column > 0 && object_[here - 1] != none) visit(here, here - 1);
        if (row > 0 && object_[here - idx(width_)] != none) visit(here, here - idx(width_));
      }
    }
  }

  // Connected cells of one object and tone, numbered in the order of their first cells.
  void find_patches() {
    DisjointSets joined(level_.size());
    visit_neighbours([&](std::size_t a, std::size_t b) {
      if (object_[a] != object_[b] || level_[a] != level_[b]) return;
      joined.join(static_cast<int>(a), static_cast<int>(b));
    });
    patch_.assign(level_.size(), none);
    area_.clear();
    tone_.clear();
    patch_object_.clear();
    for (std::size_t cell = 0; cell < level_.size(); ++cell) {
      if (object_[cell] == none) continue;
      const auto first = idx(joined.root(static_cast<int>(cell)));
      if (first == cell) {
        patch_[cell] = static_cast<int>(area_.size());
        area_.push_back(0);
        tone_.push_back(level_[cell]);
        patch_object_.push_back(object_[cell]);
      }
      patch_[cell] = patch_[first];
      ++area_[idx(patch_[cell])];
    }
  }

  const int width_, height_;
  std::vector<Tone>& level_;
  std::vector<int> object_;        // (cells) none where nothing is seen
  std::vector<int> object_area_;   // (objects) cells
  std::vector<int> patch_;         // (cells)
  std::vector<int> area_;          // (patches) cells
  std::vector<Tone> tone_;         // (patches)
  std::vector<int> patch_object_;  // (patches)
};

}  // namespace

void settle_patches(const Surface& surface, const VisibleImage& visible, double patch_px,
                    ToneMap& tone) {
  const double side = patch_px / tone.cell_px;  // in cells
  if (!(side > 0)) return;
  Patches patches(surface, visible, tone);
  const int reach = static_cast<int>(std::min(side * window_share / 2, 500.0));
  if (reach > 0) patches.even_out(reach);
  const auto least_cells = [least = side * side](double cells) {
    return least * rise(cells / least, small_object, large_object);
  };
  for (int round = 0; round < most_rounds && patches.join_small(least_cells); ++round) continue;
  for (std::size_t cell = 0; cell < tone.extra.size(); ++cell) {
    if (tone.level[cell] != Tone::shadow) tone.extra[cell] = 0;
  }
}

void drop_small_undercuts(const Surface& surface, const VisibleImage& visible, double patch_px,
                          ToneMap& tone) {
  const double side = patch_px / tone.cell_px;  // in cells
  if (!(side > 0)) return;
  ToneMap marked = tone;
  for (std::size_t cell = 0; cell < tone.band.size(); ++cell) {
    marked.level[cell] = tone.band[cell] == Band::undercut ? Tone::shadow : Tone::highlight;
  }
  const auto least_cells = [&](double) { return least_undercut * side * side; };
  Patches(surface, visible, marked).join_small(least_cells);
  for (std::size_t cell = 0; cell < tone.band.size(); ++cell) {
    if (tone.band[cell] == Band::undercut && marked.level[cell] != Tone::shadow)
      tone.band[cell] = Band::nothing;
  }
}

}  // namespace illustrate
