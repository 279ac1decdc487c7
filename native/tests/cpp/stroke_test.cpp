#include <gtest/gtest.h>

#include <cmath>

#include "core/errors.h"
#include "stroke/chains.h"
#include "stroke/make_strokes.h"
#include "stroke/stroke_path.h"

namespace illustrate {
namespace {

constexpr int size_px = 100;
const double pi = std::acos(-1.0);

// World x, y in [0, 100] are the image's, y up; looks down -z.
Camera flat_camera() {
  Mat4 projection = Mat4::Identity();
  projection(0, 0) = projection(1, 1) = 2.0 / size_px;
  projection(0, 3) = projection(1, 3) = -1;
  projection(2, 2) = -0.01;
  return {projection, Mat4::Identity(), size_px, size_px};
}

// A graph by hand: nodes at image points, arcs as polylines through image points.
struct GraphBuilder {
  LabelledGraph graph;

  int node(NodeKind kind, const Vec2& image) {
    graph.nodes.push_back({kind, image});
    return static_cast<int>(graph.nodes.size()) - 1;
  }

  int arc(const std::vector<Vec2>& image, int start, int end, int invisibility = 0,
          Kind kind = Kind::silhouette, int object = 0) {
    for (const Vec2& p : image) {
      graph.image.push(p);
      graph.points.push({Vec3(p.x(), size_px - p.y(), 0), {}});
    }
    graph.image.close_list();
    graph.points.close_list();
    graph.arcs.push_back({kind, object, 0, start, end, invisibility, 2, 0});
    return static_cast<int>(graph.arcs.size()) - 1;
  }

  // Between two nodes, straight.
  int line(int start, int end, int invisibility = 0, Kind kind = Kind::silhouette, int object = 0) {
    const auto image = [&](int n) { return graph.nodes[static_cast<std::size_t>(n)].image; };
    return arc({image(start), image(end)}, start, end, invisibility, kind, object);
  }
};

std::vector<Vec2> circle(const Vec2& centre, double radius, int count) {
  std::vector<Vec2> points;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * pi * i / count;
    points.push_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  return points;
}

Drawing strokes_of(const LabelledGraph& graph, const StrokeOptions& options = {},
                   const std::vector<double>& width_scale = {},
                   const std::vector<std::uint8_t>& undrawn = {}) {
  return make_strokes(graph, {}, {}, flat_camera(), width_scale, undrawn, options);
}

std::size_t count_of(const Drawing& drawing) { return drawing.kinds.size(); }

Vec2 first_of(const Drawing& drawing, std::size_t stroke) {
  return drawing.image[static_cast<std::size_t>(drawing.offsets[stroke])];
}

Vec2 last_of(const Drawing& drawing, std::size_t stroke) {
  return drawing.image[static_cast<std::size_t>(drawing.offsets[stroke + 1]) - 1];
}

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

TEST(MakeStrokes, DanglingSpecksAreDroppedAndGapsStayClosed) {
  GraphBuilder b;
  const int a = b.node(NodeKind::joint, {10, 50});
  const int c = b.node(NodeKind::joint, {50, 50});
  const int d = b.node(NodeKind::joint, {52, 50});
  const int e = b.node(NodeKind::joint, {90, 50});
  b.line(a, c);
  b.line(c, d, 0, Kind::boundary);
  b.line(d, e);
  b.line(e, b.node(NodeKind::cusp, {92, 50}), 0, Kind::boundary);
  b.arc(circle({50, 80}, 0.3, 20), none, none);
  const Drawing drawing = strokes_of(b.graph);
  ASSERT_EQ(count_of(drawing), 3U);
  EXPECT_EQ(drawing.kinds[2], Kind::boundary);
  EXPECT_EQ(first_of(drawing, 2), Vec2(50, 50));
}

TEST(MakeStrokes, ChainOfDanglingSpecksGoesWhole) {
  GraphBuilder b;
  const int a = b.node(NodeKind::joint, {50, 50});
  const int c = b.node(NodeKind::joint, {52, 50});
  b.line(b.node(NodeKind::joint, {10, 50}), a);
  b.line(a, c, 0, Kind::boundary);
  b.line(c, b.node(NodeKind::joint, {54, 50}), 0, Kind::crease);
  EXPECT_EQ(count_of(strokes_of(b.graph)), 1U);
}

// A swallowtail on an outline: the line from the left passes over itself at the crossing and ends
// at a cusp, `tail_px` on; the line that goes on to the right comes out from under it there.
struct SwallowtailGraph : GraphBuilder {
  explicit SwallowtailGraph(double tail_px, const Vec2& onward = {90, 53}, int object = 0) {
    const int left = node(NodeKind::joint, {10, 50});
    const int right = node(NodeKind::joint, onward);
    const int crossing = node(NodeKind::crossing, {50, 50});
    const int near_cusp = node(NodeKind::cusp, {50 + tail_px, 50});
    const int far_cusp = node(NodeKind::cusp, {50 - tail_px, 50});
    const int front_in = line(left, crossing);
    const int front_out = line(crossing, near_cusp);
    const int folded = line(near_cusp, far_cusp, 1);
    const int back_in = line(far_cusp, crossing, 2, Kind::silhouette, object);
    const int back_out = line(crossing, right, 0, Kind::silhouette, object);
    const auto arcs_of = [&](int n) -> auto& { return graph.nodes[idx(n)].arcs; };
    arcs_of(crossing) = {front_in, front_out, back_in, back_out};
    arcs_of(near_cusp) = {front_out, folded, none, none};
    arcs_of(far_cusp) = {folded, back_in, none, none};
  }
};

TEST(MakeStrokes, OutlineRunsOnPastASwallowtail) {
  const Drawing drawing = strokes_of(SwallowtailGraph(2.5).graph);
  ASSERT_EQ(count_of(drawing), 1U);
  EXPECT_EQ(first_of(drawing, 0), Vec2(10, 50));
  EXPECT_EQ(last_of(drawing, 0), Vec2(90, 53));
  for (std::size_t i = 0; i < drawing.points.size(); ++i) {
    const double x = drawing.image[i].x();
    if (x > 17 && x < 83) {
      EXPECT_FLOAT_EQ(drawing.widths[i], 2.0F) << "thinner at " << x;
    }
  }
  EXPECT_EQ(drawing.image[drawing.points.size() / 2], Vec2(50, 50));
}

// Each line between two swallowtails is shorter than a speck, with its tail too.
TEST(MakeStrokes, OutlineRunsOnPastASeriesOfSwallowtails) {
  GraphBuilder b;
  const auto arcs_of = [&](int n) -> auto& { return b.graph.nodes[idx(n)].arcs; };
  const int left = b.node(NodeKind::joint, {10, 50});
  int last = left;
  for (const double x : {50., 51.5, 53.}) {
    const int crossing = b.node(NodeKind::crossing, {x, 50});
    const int near_cusp = b.node(NodeKind::cusp, {x + 1, 50});
    const int far_cusp = b.node(NodeKind::cusp, {x - 1, 50});
    const int in = b.line(last, crossing), tail = b.line(crossing, near_cusp);
    const int folded = b.line(near_cusp, far_cusp, 1), hidden = b.line(far_cusp, crossing, 2);
    if (last != left) arcs_of(last)[3] = in;
    arcs_of(crossing) = {in, tail, hidden, none};
    arcs_of(near_cusp) = {tail, folded, none, none};
    arcs_of(far_cusp) = {folded, hidden, none, none};
    last = crossing;
  }
  arcs_of(last)[3] = b.line(last, b.node(NodeKind::joint, {90, 50}));
  const Drawing drawing = strokes_of(b.graph);
  ASSERT_EQ(count_of(drawing), 1U);
  EXPECT_EQ(first_of(drawing, 0), Vec2(10, 50));
  EXPECT_EQ(last_of(drawing, 0), Vec2(90, 50));
}

// A hole of two pixels: each of its sides is shorter than a speck, and one of them ends in a tail.
TEST(MakeStrokes, OutlineOfATinyHoleStays) {
  GraphBuilder b;
  const int left = b.node(NodeKind::joint, {10, 50}), right = b.node(NodeKind::joint, {90, 50});
  const int from = b.node(NodeKind::joint, {49, 50}), to = b.node(NodeKind::joint, {51, 50});
  const int corner = b.node(NodeKind::crossing, {51, 48});
  b.line(left, from);
  b.line(from, to);
  b.line(to, right);
  const int side = b.line(from, corner);
  const int tail = b.line(corner, b.node(NodeKind::cusp, {51.5, 47.5}));
  const int hidden = b.line(b.node(NodeKind::cusp, {51.2, 47}), corner, 2);
  const int other_side = b.line(corner, to);
  b.graph.nodes[idx(corner)].arcs = {side, tail, hidden, other_side};
  const Drawing drawing = strokes_of(b.graph);
  ASSERT_EQ(count_of(drawing), 2U);
  EXPECT_EQ(first_of(drawing, 1), Vec2(49, 50));
  EXPECT_EQ(last_of(drawing, 1), Vec2(51, 50));
}

TEST(MakeStrokes, TailsThatAreLongOrTurnAwayOrBelongToOthersStay) {
  for (const SwallowtailGraph& b : {SwallowtailGraph(3.5), SwallowtailGraph(2.5, {10, 60}),
                                    SwallowtailGraph(2.5, {90, 53}, 1)}) {
    const Drawing drawing = strokes_of(b.graph);
    ASSERT_EQ(count_of(drawing), 2U);
    EXPECT_EQ(last_of(drawing, 0), b.graph.nodes[3].image) << "the cusp";
    EXPECT_EQ(first_of(drawing, 1), Vec2(50, 50));
  }
}

// Two lines across the image, this far apart, and one that passes behind both.
TEST(MakeStrokes, WhatIsSeenInASlitIsASpeck) {
  const auto count = [](double slit, double unit_px = 1) {
    GraphBuilder b;
    b.graph.unit_px = unit_px;
    std::array<int, 2> crossings;
    for (const std::size_t k : {0, 1}) {
      const double y = k == 0 ? 50 : 50 + slit;
      crossings[k] = b.node(NodeKind::crossing, {50, y});
      const int in = b.line(b.node(NodeKind::joint, {10, y}), crossings[k]);
      const int out = b.line(crossings[k], b.node(NodeKind::joint, {90, y}));
      b.graph.nodes[idx(crossings[k])].arcs = {in, out, none, none};
    }
    const int before = b.line(b.node(NodeKind::joint, {50, 10}), crossings[0], 2);
    const int within = b.line(crossings[0], crossings[1]);
    const int behind = b.line(crossings[1], b.node(NodeKind::joint, {50, 90}), 2);
    b.graph.nodes[idx(crossings[0])].arcs[2] = before;
    b.graph.nodes[idx(crossings[0])].arcs[3] = within;
    b.graph.nodes[idx(crossings[1])].arcs[2] = within;
    b.graph.nodes[idx(crossings[1])].arcs[3] = behind;
    return count_of(strokes_of(b.graph));
  };
  EXPECT_EQ(count(.5), 2U);
  EXPECT_EQ(count(1.5), 3U);
  EXPECT_EQ(count(1.5, 2), 2U) << "less than a unit";
}

TEST(MakeStrokes, FreeEndsThatFaceEachOtherAreOneLine) {
  const auto count = [](const Vec2& end, const Vec2& far, double depth, double unit_px = 1) {
    GraphBuilder b;
    b.graph.unit_px = unit_px;
    b.line(b.node(NodeKind::cusp, {10, 50}), b.node(NodeKind::cusp, {50, 50}));
    b.line(b.node(NodeKind::joint, end), b.node(NodeKind::cusp, far));
    for (std::size_t i = 2; i < 4; ++i) b.graph.points.values[i].position.z() -= depth;
    return count_of(strokes_of(b.graph));
  };
  EXPECT_EQ(count({50.8, 50.2}, {90, 52}, 0), 1U);
  EXPECT_EQ(count({51.3, 50}, {90, 52}, 0), 2U) << "a gap that is seen";
  EXPECT_EQ(count({51.3, 50}, {90, 52}, 0, 1.5), 1U) << "less than a unit";
  EXPECT_EQ(count({50.8, 50.2}, {90, 52}, 0, 0.5), 2U) << "more than a unit";
  EXPECT_EQ(count({50.8, 50.2}, {50.8, 90}, 0), 2U) << "a corner";
  EXPECT_EQ(count({50.8, 50.2}, {90, 52}, 30), 2U) << "one behind the other";
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
    EXPECT_NEAR(drawing.widths[i], x < 50 ? 1.4 : 0.6, 1e-6);
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
    EXPECT_NEAR(drawing.widths[i], 1 + 0.4 * swelling, 1e-5) << light;
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
