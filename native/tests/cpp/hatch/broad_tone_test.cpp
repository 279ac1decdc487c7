#include <gtest/gtest.h>

#include "hatch/view/broad_tone.h"

namespace illustrate {
namespace {

ToneMap map_of(const std::vector<std::string>& rows) {
  ToneMap tone;
  tone.width = static_cast<int>(rows[0].size());
  tone.height = static_cast<int>(rows.size());
  tone.cell_px = 0.5;
  for (const std::string& row : rows) {
    for (const char c : row) {
      tone.level.push_back(c == ' '   ? Tone::nothing
                           : c == 's' ? Tone::shadow
                           : c == 'm' ? Tone::midtone
                                      : Tone::highlight);
      tone.band.push_back(c == 'u' ? Band::undercut : c == 'b' ? Band::mach_band : Band::nothing);
    }
  }
  return tone;
}

TEST(BroadTone, ReachesFartherOverWhatIsSeen) {
  const ToneMap broad =
      broadened(map_of({"h.........", " .s...b..m", "..........", "u........."}), 1, 0.5);
  const std::vector<std::string> expected{"msssmhhmmm", " sssmhhmmm", "ssssmhhmmm", "ssmmmhhmmm"};
  for (std::size_t row = 0; row < 4; ++row) {
    for (std::size_t column = 0; column < 10; ++column) {
      const Tone level = broad.level[row * 10 + column];
      const char c = level == Tone::shadow    ? 's'
                     : level == Tone::midtone ? 'm'
                     : level == Tone::nothing ? ' '
                                              : 'h';
      EXPECT_EQ(broad.band[row * 10 + column], Band::nothing);
      EXPECT_EQ(c, expected[row][column]) << row << ", " << column;
    }
  }
}

TEST(BroadTone, IsTheTruthByBruteForce) {
  ToneMap tone;
  tone.width = 23;
  tone.height = 17;
  for (int cell = 0; cell < 23 * 17; ++cell) {
    tone.level.push_back(cell % 37 == 5 ? Tone::shadow : Tone::highlight);
    tone.band.push_back(Band::nothing);
  }
  const ToneMap broad = broadened(tone, 0, 3);
  for (int row = 0; row < 17; ++row) {
    for (int column = 0; column < 23; ++column) {
      bool is_near = false;
      for (int r = std::max(0, row - 3); r <= std::min(16, row + 3); ++r) {
        for (int c = std::max(0, column - 3); c <= std::min(22, column + 3); ++c) {
          is_near |= tone.level[idx(r * 23 + c)] == Tone::shadow;
        }
      }
      EXPECT_EQ(broad.level[idx(row * 23 + column)], is_near ? Tone::shadow : Tone::highlight);
    }
  }
}

}  // namespace
}  // namespace illustrate
