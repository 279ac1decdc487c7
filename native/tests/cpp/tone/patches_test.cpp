// Patches of tone that are too small, and ragged edges.
#include "tone/patches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/cpp/shapes.h"

namespace illustrate {
namespace {

// Letters: l highlight, m midtone, s shadow of the first object, L M S of the second, . nothing.
struct Picture {
  Surface surface;
  VisibleImage visible;
  ToneMap tone;

  explicit Picture(const std::vector<std::string>& rows) {
    surface.triangle_objects = {0, 1};
    visible.height = tone.height = static_cast<int>(rows.size());
    visible.width = tone.width = static_cast<int>(rows[0].size());
    for (const std::string& row : rows) {
      for (const char c : row) {
        visible.triangle.push_back(c == '.' ? none : c < 'a' ? 1 : 0);
        const char lower = c < 'a' ? static_cast<char>(c + 32) : c;
        tone.level.push_back(c == '.'       ? Tone::nothing
                             : lower == 'l' ? Tone::highlight
                             : lower == 'm' ? Tone::midtone
                                            : Tone::shadow);
      }
    }
  }

  Picture& settle(double patch_px) {
    settle_patches(surface, visible, patch_px, tone);
    return *this;
  }

  std::vector<std::string> rows() const {
    std::vector<std::string> found;
    for (std::size_t i = 0; i < tone.level.size(); ++i) {
      if (i % idx(tone.width) == 0) found.emplace_back();
      const Tone level = tone.level[i];
      const int capital = visible.triangle[i] == 1 ? 32 : 0;
      found.back() += level == Tone::nothing
                          ? '.'
                          : static_cast<char>("lms"[static_cast<int>(level)] - capital);
    }
    return found;
  }
};

using Rows = std::vector<std::string>;

TEST(SettlePatches, SmallOnesJoinTheToneThatSurroundsThem) {
  const Rows rows{"mmmmmm", "mssmmm", "mssmll", "mmmmll", "mmmmll"};
  EXPECT_EQ(Picture(rows).settle(2).rows(), rows);
  EXPECT_EQ(Picture(rows).settle(2.5).rows(),
            (Rows{"mmmmmm", "mmmmmm", "mmmmll", "mmmmll", "mmmmll"}));
  EXPECT_EQ(Picture(rows).settle(0).rows(), rows);
}

// With more midtones on the right: so that there is room for a few patches.
Rows widened(Rows rows, std::size_t columns) {
  for (std::string& row : rows) row += std::string(columns, 'm');
  return rows;
}

TEST(SettlePatches, HighlightsMayBeSmaller) {
  const Rows rows = widened({"mmmmm", "mllsm", "mllsm", "mmmmm"}, 20);
  EXPECT_EQ(Picture(rows).settle(3).rows(), widened({"mmmmm", "mllmm", "mllmm", "mmmmm"}, 20));
  EXPECT_EQ(Picture(rows).settle(4).rows(), widened({"mmmmm", "mmmmm", "mmmmm", "mmmmm"}, 20));
}

TEST(SettlePatches, ObjectsAreOnTheirOwn) {
  const Rows rows{"mmmmMMMMM..", "mmsmMSMMMmm", "mmmmMMMMMms", "mmmm......m"};
  EXPECT_EQ(Picture(rows).settle(1.9).rows(),
            (Rows{"mmmmMMMMM..", "mmmmMMMMMmm", "mmmmMMMMMmm", "mmmm......m"}));
  EXPECT_EQ(Picture({"s.SSSSSS", "s.SSSSSS"}).settle(1.5).rows(), (Rows{"s.SSSSSS", "s.SSSSSS"}));
}

TEST(SettlePatches, SmallObjectsKeepTheirLightAndShade) {
  const Rows rows{"mmmmmmmmmm", "msmmmmmmmm", "mmmmmmMMMM", "mmmmmmMSMM"};
  EXPECT_EQ(Picture(rows).settle(2).rows(),
            (Rows{"mmmmmmmmmm", "mmmmmmmmmm", "mmmmmmMMMM", "mmmmmmMSMM"}))
      << "of the one 32 cells are seen, of the other 8";
}

TEST(SettlePatches, EdgesAreEvenedOut) {
  std::mt19937 random(1);
  Rows rows;
  for (int row = 0; row < 60; ++row) {
    const int edge = 30 + static_cast<int>(random() % 7) - 3;
    rows.push_back(std::string(idx(edge), 's') + std::string(idx(60 - edge), 'm'));
  }
  const auto roughness = [](const Rows& picture) {
    int sum = 0;
    for (std::size_t i = 1; i < picture.size(); ++i)
      sum += std::abs(static_cast<int>(picture[i].find('m')) -
                      static_cast<int>(picture[i - 1].find('m')));
    return sum;
  };
  EXPECT_LT(roughness(Picture(rows).settle(40).rows()), roughness(rows) / 5);
}

TEST(SettlePatches, StraightEdgesStayWhereTheyAre) {
  Rows rows(40, std::string(15, 'l') + std::string(10, 'm') + std::string(15, 's'));
  EXPECT_EQ(Picture(rows).settle(20).rows(), rows);
}

TEST(SettlePatches, ExtraLevelsGoWithTheirShadow) {
  Picture picture({"mmmmmm", "msmmmm", "mmmmmm"});
  picture.tone.extra.assign(18, 0);
  picture.tone.extra[7] = 2;
  picture.settle(2);
  EXPECT_EQ(picture.tone.extra, std::vector<std::uint8_t>(18, 0));
}

TEST(SettlePatches, SmallUndercutsGoAndLargeOnesStay) {
  Picture picture({"mmmmmm", "mmmmmm", "mmmmmm"});
  picture.tone.band.assign(18, Band::nothing);
  for (const std::size_t cell : {0, 3, 4, 5, 9, 10, 11}) picture.tone.band[cell] = Band::undercut;
  picture.tone.band[7] = Band::mach_band;
  drop_small_undercuts(picture.surface, picture.visible, 3, picture.tone);
  EXPECT_EQ(picture.tone.band[0], Band::nothing);
  EXPECT_EQ(picture.tone.band[7], Band::mach_band);
  EXPECT_EQ(std::count(picture.tone.band.begin(), picture.tone.band.end(), Band::undercut), 6);
}

}  // namespace
}  // namespace illustrate
