// Strokes as pixels: as much ink as their width and length, whatever the direction.
#include <gtest/gtest.h>

#include "stroke/rasterise.h"

namespace illustrate {
namespace {

constexpr Colour black{0, 0, 0, 255}, white{255, 255, 255, 255}, clear{0, 0, 0, 0};

struct Lines {
  ImagePoints image;
  std::vector<float> widths;
  std::vector<int> offsets{0};
  std::vector<std::uint8_t> closed;
  std::vector<Colour> colours;

  void add(const ImagePoints& points, float width, const Colour& colour = black,
           bool is_closed = false) {
    image.insert(image.end(), points.begin(), points.end());
    widths.resize(image.size(), width);
    offsets.push_back(static_cast<int>(image.size()));
    closed.push_back(is_closed);
    colours.push_back(colour);
  }

  std::vector<Colour> painted(const Colour& paper = white, int threads = 1) const {
    return rasterise({image, widths, offsets, closed, colours}, 200, 150, paper, threads);
  }
};

double ink_of(const std::vector<Colour>& picture) {
  double ink = 0;
  for (const Colour& pixel : picture) ink += 1 - pixel[0] / 255.0;
  return ink;
}

TEST(Rasterise, ALineHasTheInkOfItsArea) {
  for (const double angle : {0.0, 0.1, 0.6, 0.785398, 1.2, 1.570796}) {
    for (const float width : {0.2F, 0.7F, 1.0F, 2.5F, 9.0F}) {
      Lines lines;
      const Vec2 along(std::cos(angle), std::sin(angle)), middle(100.3, 75.1);
      lines.add({middle - 60 * along, middle + 60 * along}, width);
      const double wide = static_cast<double>(width), area = 120 * wide + 0.785 * wide * wide;
      EXPECT_NEAR(ink_of(lines.painted()) / area, 1, 0.03) << angle << " " << width;
    }
  }
}

TEST(Rasterise, PiecesOfAStrokeLeaveNoBeads) {
  Lines whole, pieces;
  ImagePoints points;
  for (int i = 0; i <= 700; ++i) points.emplace_back(20 + i * 0.2, 30 + i * 0.1);
  whole.add({points.front(), points.back()}, 1.3F);
  pieces.add(points, 1.3F);
  const std::vector<Colour> a = whole.painted(), b = pieces.painted();
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i][0], b[i][0], 2);
}

TEST(Rasterise, ClosedStrokesClose) {
  Lines lines;
  lines.add({{50, 50}, {100, 50}, {100, 100}, {50, 100}}, 2, black, true);
  EXPECT_LT(lines.painted()[75 * 200 + 50][0], 10);
}

TEST(Rasterise, LaterStrokesLieOnTop) {
  Lines lines;
  lines.add({{50.5, 10}, {50.5, 140}}, 8);
  lines.add({{10, 70.5}, {190, 70.5}}, 8, {200, 0, 0, 255});
  const std::vector<Colour> picture = lines.painted();
  EXPECT_EQ(picture[70 * 200 + 50], (Colour{200, 0, 0, 255}));
  EXPECT_EQ(picture[30 * 200 + 50], black);
  EXPECT_EQ(picture[0], white);
}

TEST(Rasterise, PaperMayBeClear) {
  Lines lines;
  lines.add({{10, 70.5}, {190, 70.5}}, 1, {200, 100, 0, 128});
  const std::vector<Colour> picture = lines.painted(clear);
  EXPECT_EQ(picture[0], clear);
  EXPECT_EQ(picture[70 * 200 + 50], (Colour{200, 100, 0, 128}));
}

TEST(Rasterise, IsTheSameWithAnyThreads) {
  Lines lines;
  for (int i = 0; i < 60; ++i) {
    lines.add({{i * 3.0, -20}, {200 - i * 2.0, 60}, {i * 1.0, 180}},
              0.3F + 0.1F * static_cast<float>(i));
  }
  EXPECT_EQ(lines.painted(white, 1), lines.painted(white, 3));
}

TEST(Rasterise, LeavesOutWhatIsNotFinite) {
  Lines lines;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  lines.add({{10, 10}, {nan, 40}, {1e300, 70}}, 3);
  lines.add({{10, 10}, {90, 10}}, std::numeric_limits<float>::infinity());
  lines.add({}, 3);
  EXPECT_EQ(ink_of(lines.painted()), 0);
}

}  // namespace
}  // namespace illustrate
