// Connected cells of one tone, against flood fill cell by cell.
#include "tone/cell_patches.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

namespace illustrate {
namespace {

// Two objects and places where nothing is seen, in random blocks, with random tones on them.
struct RandomPicture {
  Surface surface;
  VisibleImage visible;
  std::vector<Tone> level;

  RandomPicture(int width, int height, unsigned seed) {
    std::mt19937 random(seed);
    surface.triangle_objects = {0, 1};
    visible.width = width;
    visible.height = height;
    for (int cell = 0; cell < width * height; ++cell) {
      const bool goes_on = cell > 0 && random() % 4 != 0;
      const int triangle = std::array{none, 0, 1}[random() % 3];
      visible.triangle.push_back(goes_on ? visible.triangle.back() : triangle);
      const bool is_same = cell >= width && random() % 3 != 0;
      level.push_back(is_same ? level[idx(cell - width)] : static_cast<Tone>(random() % 3));
    }
  }

  int object(int cell) const {
    const int t = visible.triangle[idx(cell)];
    return t == none ? none : surface.object_of(t);
  }
  std::vector<int> around(int cell) const {
    std::vector<int> cells;
    const int column = cell % visible.width, end = visible.width * visible.height;
    if (column > 0) cells.push_back(cell - 1);
    if (column + 1 < visible.width) cells.push_back(cell + 1);
    if (cell >= visible.width) cells.push_back(cell - visible.width);
    if (cell + visible.width < end) cells.push_back(cell + visible.width);
    return cells;
  }
};

// The patch of each cell, numbered by their first cells, and how many cells each has.
std::pair<std::vector<int>, std::vector<int>> flooded(const RandomPicture& picture) {
  std::vector<int> patches(picture.level.size(), none), areas;
  for (int first = 0; first < static_cast<int>(patches.size()); ++first) {
    if (picture.object(first) == none || patches[idx(first)] != none) continue;
    std::vector<int> open{first};
    patches[idx(first)] = static_cast<int>(areas.size());
    areas.push_back(0);
    while (!open.empty()) {
      const int cell = open.back();
      open.pop_back();
      ++areas.back();
      for (const int next : picture.around(cell)) {
        const bool is_one = picture.object(next) == picture.object(cell) &&
                            picture.level[idx(next)] == picture.level[idx(cell)];
        if (!is_one || patches[idx(next)] != none) continue;
        patches[idx(next)] = patches[idx(cell)];
        open.push_back(next);
      }
    }
  }
  return {patches, areas};
}

// Once, of all patches of fewer cells than `least`, highlights than a third.
void join_small(RandomPicture& picture, double least) {
  const auto [patches, areas] = flooded(picture);
  std::vector<std::array<int, 3>> along(areas.size(), {0, 0, 0});
  for (int cell = 0; cell < static_cast<int>(patches.size()); ++cell) {
    for (const int next : picture.around(cell)) {
      if (picture.object(cell) == none || picture.object(next) != picture.object(cell)) continue;
      const int a = patches[idx(cell)], b = patches[idx(next)];
      const bool is_larger = std::make_pair(areas[idx(b)], b) > std::make_pair(areas[idx(a)], a);
      if (is_larger) ++along[idx(a)][static_cast<std::size_t>(picture.level[idx(next)])];
    }
  }
  for (std::size_t cell = 0; cell < patches.size(); ++cell) {
    if (patches[cell] == none) continue;
    const auto& tones = along[idx(patches[cell])];
    const auto most = std::max_element(tones.begin(), tones.end());
    const double bound = picture.level[cell] == Tone::highlight ? least / 3 : least;
    if (*most > 0 && areas[idx(patches[cell])] < bound)
      picture.level[cell] = static_cast<Tone>(most - tones.begin());
  }
}

TEST(CellPatches, JoinAsCellsThatAreFloodedDo) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    RandomPicture picture(1 + static_cast<int>(seed % 17), 1 + static_cast<int>(seed % 13), seed);
    const std::vector<Tone> first = picture.level;
    CellPatches patches(SeenObjects(picture.surface, picture.visible), picture.level);
    for (int round = 0; round < 3; ++round) {
      const double least = 1 + seed % 9;
      const std::vector<Tone> before = picture.level;
      const bool any = patches.join_small([&](double) { return least; });
      join_small(picture, least);
      std::vector<Tone> written = first;
      patches.write(written);
      ASSERT_EQ(written, picture.level) << seed;
      ASSERT_EQ(any, picture.level != before) << seed;
    }
  }
}

TEST(CellPatches, HowManyCellsAnObjectHasIsTold) {
  Surface surface;
  surface.triangle_objects = {0, 2};
  VisibleImage visible;
  visible.width = 3;
  visible.height = 1;
  visible.triangle = {0, 1, 1};
  const SeenObjects seen(surface, visible);
  EXPECT_EQ(seen.areas, (std::vector<int>{1, 0, 2}));
  std::vector<double> asked;
  CellPatches patches(seen, {Tone::shadow, Tone::shadow, Tone::midtone});
  patches.join_small([&](double cells) {
    asked.push_back(cells);
    return 0;
  });
  EXPECT_EQ(asked, std::vector<double>{2}) << "only what borders on another tone";
}

}  // namespace
}  // namespace illustrate
