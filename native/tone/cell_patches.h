// Connected cells of one tone (tone/patches.h), told by the runs of cells that make up rows.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "tone/tone_regions.h"

namespace illustrate {

// Which object is seen at each cell of an image.
struct SeenObjects {
  int width = 0, height = 0;
  std::vector<int> of_cell;  // (height * width) none where nothing is seen
  std::vector<int> areas;    // (objects) cells; objects beyond are not seen

  SeenObjects(const Surface& surface, const VisibleImage& visible);
};

// Patches: connected cells of one object and tone. Cells are connected along rows and columns.
class CellPatches {
 public:
  // level: (cells), one of highlight, midtone, shadow where anything is seen.
  CellPatches(const SeenObjects& seen, const std::vector<Tone>& level);

  // Patches of fewer cells than least_cells(cells of their object), highlights of fewer than a
  // third of that, take the tone of those larger ones that they share most of their border with,
  // all at once, and are one with them then. Whether any did.
  bool join_small(const std::function<double(double object_cells)>& least_cells);

  // The tones of all cells that are seen.
  void write(std::vector<Tone>& level) const;

 private:
  static constexpr int tones = 3;
  // Consecutive cells of one row.
  struct Run {
    int begin, end, patch;
  };
  struct Patch {
    int object, cells;
    Tone tone;
  };
  // Two patches of one object side by side along so many cells.
  struct Border {
    int a, b, cells;
  };

  void add_row(const SeenObjects& seen, const std::vector<Tone>& level, int row);
  void meet_row_above(std::size_t above, std::size_t row, int width);
  void unite();
  bool is_less(int a, int b) const;

  std::vector<Run> runs_;        // in the order of their cells
  std::vector<Patch> patches_;   // in the order of their first cells
  std::vector<Border> borders_;  // of two patches perhaps several
  std::vector<int> object_areas_;
};

}  // namespace illustrate
