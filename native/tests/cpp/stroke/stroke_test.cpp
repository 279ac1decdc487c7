#include <gtest/gtest.h>

#include <cmath>

#include "core/errors.h"
#include "stroke/chains.h"
#include "stroke/stroke_path.h"
#include "tests/cpp/stroke/stroke_scene.h"

namespace illustrate {
namespace {

using namespace stroke_scene;

// A front line from left to right over a back line that is hidden by two layers above it.
struct CrossingGraph : GraphBuilder {
  CrossingGraph() {
    const int left = node(NodeKind::joint, {10, 50});
    const int right = node(NodeKind::joint, {90, 50});
    const int low = node(NodeKind::joint, {50, 90});
    const int high = node(NodeKind::joint, {50, 10});
    const int crossing = node(NodeKind::crossing, {50, 50});
    const int front_in = line(left, crossing);
    const int back_in = line(low, crossing);
    const int front_out = line(crossing, right);
    const int back_out = line(crossing, high, 2);
    graph.nodes[static_cast<std::size_t>(crossing)].arcs = {front_in, front_out, back_in, back_out};
  }
};

TEST(MakeStrokes, FrontCurveIsNotBrokenAtCrossing) {
  const Drawing drawing = strokes_of(CrossingGraph().graph);
  ASSERT_EQ(count_of(drawing), 2U);
  EXPECT_EQ(first_of(drawing, 0), Vec2(10, 50));
  EXPECT_EQ(last_of(drawing, 0), Vec2(90, 50));
  EXPECT_EQ(first_of(drawing, 1), Vec2(50, 90));
  EXPECT_EQ(last_of(drawing, 1), Vec2(50, 50));
}

TEST(MakeStrokes, HiddenLinesAreDrawnInTheirRangeAndThinner) {
  StrokeOptions options;
  options.hidden_lines = {{1, 2}};
  const Drawing drawing = strokes_of(CrossingGraph().graph, options);
  ASSERT_EQ(count_of(drawing), 3U);
  EXPECT_EQ(drawing.invisibility, (std::vector<int>{0, 0, 2}));
  const auto hidden = static_cast<std::size_t>(drawing.offsets[2]);
  EXPECT_FLOAT_EQ(drawing.widths[hidden], 1.0F);
  options.hidden_lines = {{3, 9}};
  EXPECT_EQ(count_of(strokes_of(CrossingGraph().graph, options)), 2U);
}

TEST(MakeStrokes, BackCurveGoesOnWhereNothingIsHidden) {
  CrossingGraph crossing;
  crossing.graph.arcs[3].invisibility = 0;
  EXPECT_EQ(count_of(strokes_of(crossing.graph)), 2U);
}

TEST(MakeStrokes, SmallestTurnGoesOnAtJoints) {
  GraphBuilder b;
  const int middle = b.node(NodeKind::joint, {50, 50});
  b.line(b.node(NodeKind::joint, {50, 10}), middle);
  b.line(middle, b.node(NodeKind::joint, {90, 55}));
  b.line(middle, b.node(NodeKind::joint, {10, 50}));
  const Drawing drawing = strokes_of(b.graph);
  ASSERT_EQ(count_of(drawing), 2U);
  EXPECT_EQ(last_of(drawing, 0), Vec2(50, 50));
  EXPECT_EQ(first_of(drawing, 1), Vec2(10, 50));
  EXPECT_EQ(last_of(drawing, 1), Vec2(90, 55));
}

TEST(MakeStrokes, KindAndObjectAreNotMixed) {
  for (const bool same_kind : {false, true}) {
    GraphBuilder b;
    const int middle = b.node(NodeKind::joint, {50, 50});
    b.line(b.node(NodeKind::end, {10, 50}), middle);
    b.line(middle, b.node(NodeKind::end, {90, 50}), 0,
           same_kind ? Kind::silhouette : Kind::boundary, same_kind ? 1 : 0);
    EXPECT_EQ(count_of(strokes_of(b.graph)), 2U);
  }
}

TEST(MakeStrokes, ClosedChainIsOneClosedStroke) {
  GraphBuilder b;
  const int left = b.node(NodeKind::joint, {10, 50});
  const int right = b.node(NodeKind::joint, {90, 50});
  b.arc({{10, 50}, {50, 10}, {90, 50}}, left, right);
  b.arc({{10, 50}, {50, 90}, {90, 50}}, left, right);
  const Drawing drawing = strokes_of(b.graph);
  ASSERT_EQ(count_of(drawing), 1U);
  EXPECT_EQ(drawing.closed[0], 1);
  EXPECT_EQ(drawing.points.size(), 4U);
}

TEST(MakeStrokes, LoopThroughOneNodeCloses) {
  GraphBuilder b;
  const int joint = b.node(NodeKind::joint, {10, 50});
  b.arc({{10, 50}, {50, 10}, {90, 50}, {50, 90}, {10, 50}}, joint, joint);
  const Drawing drawing = strokes_of(b.graph);
  ASSERT_EQ(count_of(drawing), 1U);
  EXPECT_EQ(drawing.closed[0], 1);
  EXPECT_EQ(drawing.points.size(), 4U);
}

TEST(MakeStrokes, KindsAreDrawnWhenAskedForAndSortedByKind) {
  GraphBuilder b;
  const std::vector<Kind> kinds{Kind::seam,         Kind::flat_outline, Kind::material, Kind::mark,
                                Kind::intersection, Kind::crease,       Kind::boundary};
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    b.arc(circle({50, 50}, 5 + 5.0 * static_cast<double>(i), 40), none, none, 0, kinds[i]);
  }
  EXPECT_EQ(strokes_of(b.graph).kinds,
            (std::vector<Kind>{Kind::boundary, Kind::crease, Kind::intersection}));
  StrokeOptions options;
  options.marks = options.materials = options.flat_outlines = true;
  EXPECT_EQ(strokes_of(b.graph, options).kinds,
            (std::vector<Kind>{Kind::boundary, Kind::crease, Kind::intersection, Kind::mark,
                               Kind::material, Kind::flat_outline}));
}

TEST(MakeStrokes, ObjectsCanBeLeftUndrawnAndScaled) {
  GraphBuilder b;
  b.arc(circle({30, 50}, 10, 40), none, none, 0, Kind::silhouette, 0);
  b.arc(circle({70, 50}, 10, 40), none, none, 0, Kind::silhouette, 1);
  const Drawing drawing = strokes_of(b.graph, {}, {1, 3}, {1, 0});
  ASSERT_EQ(drawing.objects, std::vector<int>{1});
  for (const float width : drawing.widths) EXPECT_FLOAT_EQ(width, 6.0F);
}

TEST(MakeStrokes, CuspEndsThinOutAndJointsDoNot) {
  GraphBuilder b;
  const int cusp = b.node(NodeKind::cusp, {90, 50});
  const int joint = b.node(NodeKind::joint, {10, 50});
  b.line(joint, cusp);
  b.line(joint, b.node(NodeKind::joint, {10, 10}), 0, Kind::boundary);
  const Drawing drawing = strokes_of(b.graph);
  ASSERT_EQ(count_of(drawing), 2U);
  const auto end = static_cast<std::size_t>(drawing.offsets[1]);
  EXPECT_FLOAT_EQ(drawing.widths[0], 2.0F);
  EXPECT_LT(drawing.widths[end - 1], 0.5F);
  EXPECT_FLOAT_EQ(drawing.widths[end - 4], 2.0F);
  EXPECT_NEAR(drawing.image[end - 4].x(), 84, 1e-9);
}

TEST(MakeStrokes, ClosedStrokeIsCutAtFrame) {
  GraphBuilder b;
  b.arc(circle({50, 50}, 60, 400), none, none);
  const Drawing drawing = strokes_of(b.graph);
  ASSERT_EQ(count_of(drawing), 4U);
  for (std::size_t s = 0; s < 4; ++s) {
    EXPECT_EQ(drawing.closed[s], 0);
    for (const Vec2& end : {first_of(drawing, s), last_of(drawing, s)}) {
      const double to_frame = std::min({end.x(), end.y(), size_px - end.x(), size_px - end.y()});
      EXPECT_NEAR(to_frame, 0, 1e-12);
    }
  }
}

TEST(MakeStrokes, ClosedStrokeCutOnceStaysOnePiece) {
  GraphBuilder b;
  b.arc(circle({90, 50}, 20, 400), none, none);
  EXPECT_EQ(count_of(strokes_of(b.graph)), 1U);
  EXPECT_EQ(count_of(strokes_of(GraphBuilder().graph)), 0U);
}

TEST(MakeStrokes, WhatIsOutsideOrNotFiniteGivesNothing) {
  GraphBuilder b;
  b.arc(circle({-50, 50}, 20, 40), none, none);
  b.arc({{NAN, 50}, {50, NAN}, {NAN, 10}}, b.node(NodeKind::end, {0, 0}),
        b.node(NodeKind::end, {0, 0}));
  EXPECT_EQ(count_of(strokes_of(b.graph)), 0U);
}

// Brightness 0 on the left half, 1 on the right.
ToneMap half_lit() {
  ToneMap tone;
  tone.width = tone.height = size_px;
  tone.level.assign(size_px * size_px, Tone::midtone);
  tone.band.assign(size_px * size_px, Band::nothing);
  for (int i = 0; i < size_px * size_px; ++i) {
    tone.brightness.push_back(i % size_px < size_px / 2 ? 0.0F : 1.0F);
  }
  return tone;
}

TEST(MakeStrokes, HatchesSwellInTheDarkAndThinOut) {
  Hatches hatches;
  for (int i = 0; i <= 80; ++i) hatches.curves.push({Vec3::Zero(), {}, Vec2(10.0 + i, 30)});
  hatches.curves.close_list();
  hatches.kinds = {Kind::cross_hatch};
  hatches.objects = {0};
  const Drawing drawing = make_strokes({}, hatches, half_lit(), flat_camera(), {}, {}, {});
  ASSERT_EQ(count_of(drawing), 1U);
  for (std::size_t i = 0; i < drawing.image.size(); ++i) {
    const double x = drawing.image[i].x();
    if (x < 16 || x > 84) continue;
    EXPECT_NEAR(drawing.widths[i], x < 50 ? 1.5 : 0.5, 1e-6);
  }
  EXPECT_LT(drawing.widths.front(), 0.3F);
  EXPECT_LT(drawing.widths.back(), 0.3F);
}

// Light that grows from 0 to 1 from the left to the right, shadow below .25, highlight above .75.
TEST(MakeStrokes, WidthFollowsTheLightWithinEachLevel) {
  ToneMap tone = half_lit();
  tone.shadow_threshold = 0.25;
  tone.highlight_threshold = 0.75;
  for (int i = 0; i < size_px * size_px; ++i) {
    tone.brightness[static_cast<std::size_t>(i)] =
        (static_cast<float>(i % size_px) + 0.5F) / size_px;
  }
  Hatches hatches;
  for (int i = 0; i <= 98; ++i) hatches.curves.push({Vec3::Zero(), {}, Vec2(0.5 + i, 30)});
  hatches.curves.close_list();
  hatches.objects = {0};
  StrokeOptions options;
  options.taper_px = 0;
  options.simplify_px = 0;
  hatches.kinds = {Kind::undercut};
  for (const float width : make_strokes({}, hatches, tone, flat_camera(), {}, {}, options).widths) {
    EXPECT_GE(width, 1) << "undercuts stay dark in the light";
  }
  hatches.kinds = {Kind::cross_hatch};
  const Drawing drawing = make_strokes({}, hatches, tone, flat_camera(), {}, {}, options);
  ASSERT_EQ(count_of(drawing), 1U);
  for (std::size_t i = 0; i < drawing.image.size(); ++i) {
    const double light = drawing.image[i].x() / size_px;
    const double swelling = light <= 0.25   ? 1 - light / 0.25
                            : light <= 0.75 ? -(light - 0.25) / 0.5
                                            : -1.0;
    EXPECT_NEAR(drawing.widths[i], 1 + 0.5 * swelling, 1e-5) << light;
  }
}

TEST(StrokeOptions, WrongFieldIsNamed) {
  StrokeOptions options;
  options.speck_px = NAN;
  try {
    validate(options);
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_NE(std::string(error.what()).find("speck_px"), std::string::npos);
  }
  options = {};
  options.hidden_lines = {{3, 1}};
  EXPECT_THROW(validate(options), InvalidInput);
  options = {};
  options.hatch_width_by_light = 1.5;
  EXPECT_THROW(validate(options), InvalidInput);
}

}  // namespace
}  // namespace illustrate
