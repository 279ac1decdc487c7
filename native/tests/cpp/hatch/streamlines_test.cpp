#include <gtest/gtest.h>

#include "hatch/streamlines/cut_streamlines.h"
#include "hatch/streamlines/merge_streamlines.h"
#include "hatch/streamlines/place_curves.h"
#include "hatch/streamlines/relax_streamlines.h"
#include "hatch/streamlines/thin_streamlines.h"
#include "surface/locate.h"
#include "tests/cpp/hatch/hatch_scene.h"

namespace illustrate {
namespace {

using namespace hatching;

// The square [-1, 1]^2, 100 px per unit, seen straight from the front, with a cross along the axes:
// column 120 + 100 x, row 120 - 100 y.
struct Sheet {
  Scene scene = scene_of(shapes::plain_surface(shapes::plane(13, 11)),
                         cameras::orthographic(Vec3::UnitZ(), 1.2, 240),
                         [](const Vec3&) { return Vec3::UnitX(); });
  HatchView view() const { return {scene.view(), scene.options}; }

  SurfacePoint under(double column, double row) const {
    const Vec3 place((column - 120) / 100, (120 - row) / 100, 0);
    for (int t = 0; t < static_cast<int>(scene.surface.triangles.size()); ++t) {
      const SurfacePoint on = locate(scene.surface, t, place);
      if (std::min({on.b1, on.b2, 1 - on.b1 - on.b2}) >= -1e-12) return on;
    }
    ADD_FAILURE() << "no place at " << column << ", " << row;
    return {0, 0, 0};
  }

  // A streamline along a row.
  Streamline line(const HatchView& view, double row, double from, double to) const {
    Streamline line{{}, 0, 8};
    for (double column = from; column <= to; column += 4) {
      line.nodes.push_back(view.node(under(column, row), Vec3::UnitX()));
    }
    return line;
  }
};

std::vector<double> rows_of(const StreamlineSet& set) {
  std::vector<double> rows;
  for (const Streamline& line : set.streamlines) {
    double sum = 0;
    for (const StreamlineNode& node : line.nodes) {
      sum += node.image.y();
      EXPECT_NEAR(node.image.y(), line.nodes[0].image.y(), 0.05) << "straight lines stay so";
    }
    rows.push_back(sum / static_cast<double>(line.nodes.size()));
  }
  std::sort(rows.begin(), rows.end());
  return rows;
}

TEST(RelaxStreamlines, MovesALineBetweenItsNeighbours) {
  const Sheet sheet;
  const HatchView view = sheet.view();
  StreamlineSet set(view);
  for (const double row : {100, 106, 116, 124}) set.add(sheet.line(view, row, 60, 180));
  relax_streamlines(set, view, 80, 1);
  const std::vector<double> rows = rows_of(set);
  ASSERT_EQ(rows.size(), 4U);
  for (std::size_t i = 1; i < 4; ++i) EXPECT_NEAR(rows[i] - rows[i - 1], 8, 0.1);
}

TEST(RelaxStreamlines, KeepsToTheFieldAndIsTheSameOnAllThreads) {
  const Sheet sheet;
  const HatchView view = sheet.view();
  const auto relaxed = [&](int threads) {
    StreamlineSet set(view);
    set.add(sheet.line(view, 100, 40, 200));
    set.add(sheet.line(view, 110, 40, 90));
    set.add(sheet.line(view, 105, 120, 200));
    relax_streamlines(set, view, 6, threads);
    return set;
  };
  const StreamlineSet one = relaxed(1), three = relaxed(3);
  for (std::size_t s = 0; s < one.streamlines.size(); ++s) {
    const auto& nodes = one.streamlines[s].nodes;
    for (std::size_t i = 1; i < nodes.size(); ++i) {
      const Vec2 run = nodes[i].image - nodes[i - 1].image;
      EXPECT_LT(std::abs(run.y()), 0.1 * std::abs(run.x()));
      EXPECT_EQ(nodes[i].image, three.streamlines[s].nodes[i].image);
    }
  }
}

double greatest_bend(const Streamline& line) {
  double bend = 0;
  for (std::size_t i = 2; i < line.nodes.size(); ++i) {
    const Vec2 a = line.nodes[i - 1].image - line.nodes[i - 2].image;
    const Vec2 b = line.nodes[i].image - line.nodes[i - 1].image;
    bend = std::max(bend, std::abs(std::atan2(cross(a, b), a.dot(b))));
  }
  return bend;
}

TEST(StraightenJoined, TakesTheKinksOutOfBridgesAndMovesNothingElse) {
  const Sheet sheet;
  const HatchView view = sheet.view();
  StreamlineSet set(view);
  set.add(sheet.line(view, 100, 40, 100));
  set.add(sheet.line(view, 103, 120, 200));
  set.add(sheet.line(view, 122, 40, 200));
  merge_streamlines(set, view);
  const Streamlines before = set.streamlines;
  ASSERT_EQ(before.size(), 2U);
  straighten_joined(set, view, 2, 1);
  EXPECT_LT(greatest_bend(set.streamlines[0]), 0.7 * greatest_bend(before[0]));
  for (std::size_t i = 0; i < before[1].nodes.size(); ++i) {
    EXPECT_EQ(set.streamlines[1].nodes[i].image, before[1].nodes[i].image);
  }
  const Streamlines once = set.streamlines;
  straighten_joined(set, view, 2, 1);
  EXPECT_EQ(greatest_bend(set.streamlines[0]), greatest_bend(once[0])) << "joins are forgotten";
}

std::size_t lines_after_merging(Sheet& sheet, double row, double from) {
  const HatchView view = sheet.view();
  StreamlineSet set(view);
  set.add(sheet.line(view, 100, 40, 100));
  set.add(sheet.line(view, row, from, 200));
  merge_streamlines(set, view);
  for (const Streamline& line : set.streamlines) {
    for (std::size_t i = 1; i < line.nodes.size(); ++i) {
      EXPECT_NEAR((line.nodes[i].image - line.nodes[i - 1].image).norm(), 4, 0.4);
      EXPECT_GT(line.nodes[i].tangent.dot(line.nodes[i - 1].tangent), 0.9);
    }
  }
  return set.streamlines.size();
}

TEST(MergeStreamlines, JoinsEndsThatFaceEachOther) {
  Sheet sheet;
  EXPECT_EQ(lines_after_merging(sheet, 100, 116), 1U);
  EXPECT_EQ(lines_after_merging(sheet, 103, 120), 1U);
  EXPECT_EQ(lines_after_merging(sheet, 105, 116), 2U) << "too far aside";
  EXPECT_EQ(lines_after_merging(sheet, 100, 130), 2U) << "too far along";
  sheet.scene.add_arc(Kind::crease, {Vec3(-0.1, -1, 0), Vec3(-0.1, 1, 0)});
  EXPECT_EQ(lines_after_merging(sheet, 100, 116), 2U) << "a crease between";
}

TEST(CutStreamlines, TheShorterOfTwoCloseOnesGoes) {
  const Sheet sheet;
  const HatchView view = sheet.view();
  StreamlineSet set(view);
  set.add(sheet.line(view, 100, 40, 200));
  set.add(sheet.line(view, 103, 80, 140));
  set.add(sheet.line(view, 105, 150, 198));
  cut_streamlines(set, view, 0.5, 1.5);
  const std::vector<double> rows = rows_of(set);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_NEAR(rows[0], 100, 1e-6);
  EXPECT_NEAR(rows[1], 105, 1e-6);
}

TEST(CutStreamlines, CutsWhereNoHatchMayRun) {
  Sheet sheet;
  for (int cell = 0; cell < 240 * 240; ++cell) {
    if (cell % 240 >= 100 && cell % 240 < 120) sheet.scene.tone.level[cell] = Tone::highlight;
  }
  const HatchView view = sheet.view();
  StreamlineSet set(view);
  set.add(sheet.line(view, 100, 40, 200));
  cut_streamlines(set, view, 0.5, 1.5);
  ASSERT_EQ(set.streamlines.size(), 2U);
  for (const Streamline& line : set.streamlines) {
    for (const StreamlineNode& node : line.nodes) {
      EXPECT_TRUE(node.image.x() < 100 || node.image.x() >= 120);
    }
  }
}

TEST(MergeStreamlines, ShortEndsGiveUpLessThanLongOnes) {
  const Sheet sheet;
  const HatchView view = sheet.view();
  StreamlineSet set(view);
  set.add(sheet.line(view, 100, 40, 100));
  set.add(sheet.line(view, 103.6, 102, 106));
  merge_streamlines(set, view);
  ASSERT_EQ(set.streamlines.size(), 1U);
  const auto& nodes = set.streamlines[0].nodes;
  EXPECT_NEAR(nodes.front().image.x(), 40, 1e-6);
  EXPECT_NEAR(nodes.back().image.x(), 106, 1e-6);
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    const Vec2 run = nodes[i].image - nodes[i - 1].image;
    EXPECT_LT(std::abs(run.y()), 0.25 * run.x()) << "no kinks";
  }
}

TEST(ThinStreamlines, ShortOnesGoWhereTheGapIsNarrow) {
  Sheet sheet;
  const auto rows_left = [&](double apart, double from, double to) {
    const HatchView view = sheet.view();
    StreamlineSet set(view);
    set.add(sheet.line(view, 100, 40, 200));
    set.add(sheet.line(view, 100 + apart, from, to));
    set.add(sheet.line(view, 100 + 2 * apart, 40, 200));
    thin_streamlines(set, view, 1.1);
    return set.streamlines.size();
  };
  EXPECT_EQ(rows_left(6.7, 60, 180), 3U) << "long ones stay";
  EXPECT_EQ(rows_left(6.7, 100, 144), 2U);
  EXPECT_EQ(rows_left(8.4, 100, 108), 2U) << "the shorter, the wider the gap may be";
  EXPECT_EQ(rows_left(8.4, 100, 132), 3U);
  EXPECT_EQ(rows_left(9, 100, 108), 3U) << "the gap would be empty";
  sheet.scene.add_arc(Kind::crease, {Vec3(-1, 0.16, 0), Vec3(1, 0.16, 0)});
  EXPECT_EQ(rows_left(6.7, 100, 144), 3U) << "a curve between";
}

TEST(PlaceCurves, ThinsAndFillsCurvesAndKeepsThemApart) {
  const Sheet sheet;
  const HatchView view = sheet.view();
  Ragged<SurfacePoint> curves;
  for (double column = 40; column <= 200; column += 1) curves.push(sheet.under(column, 100));
  curves.close_list();
  for (double column = 40; column <= 200; column += 40) curves.push(sheet.under(column, 120));
  curves.close_list();
  for (double column = 40; column <= 200; column += 1) curves.push(sheet.under(column, 104));
  curves.close_list();
  StreamlineSet set(view);
  place_curves(set, view, curves, {}, {});
  ASSERT_EQ(set.streamlines.size(), 2U) << "the third is too near to the first";
  for (const Streamline& line : set.streamlines) {
    EXPECT_NEAR(length_of(line.nodes), 160, 1e-3);
    for (std::size_t i = 1; i < line.nodes.size(); ++i) {
      const double gap = (line.nodes[i].image - line.nodes[i - 1].image).norm();
      EXPECT_GT(gap, 0.9);
      EXPECT_LT(gap, 6.5);
    }
  }
}

}  // namespace
}  // namespace illustrate
