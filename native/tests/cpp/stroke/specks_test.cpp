#include <gtest/gtest.h>

#include "tests/cpp/stroke/stroke_scene.h"

namespace illustrate {
namespace {

using namespace stroke_scene;

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

}  // namespace
}  // namespace illustrate
