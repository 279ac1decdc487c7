#include "visibility/labels/repairs.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/cpp/cameras.h"
#include "visibility/labels/path_arcs.h"
#include "visibility/labels/swallowtails.h"

namespace illustrate {
namespace {

const Camera one_px = cameras::orthographic(Vec3(0, 0, 1), 500);  // a world unit is a pixel

// A closed silhouette through these points, cut into two strands at the cusps at its first and its
// last, where it gains these layers.
CurveNetwork closed_through(const Points& points, int first_jump, int second_jump) {
  CurveNetwork network;
  network.nodes = {{NodeKind::cusp, points.front()}, {NodeKind::cusp, points.back()}};
  for (const Vec3& p : points) network.points.push({p, {}});
  network.points.close_list();
  network.points.push({points.back(), {}});
  network.points.push({points.front(), {}});
  network.points.close_list();
  Strand strand;
  strand.left_layers = 2;
  for (const int start : {0, 1}) {
    strand.start_node = start;
    strand.end_node = 1 - start;
    network.strands.push_back(strand);
  }
  network.ties = {{1, 0, 1, first_jump}, {0, 1, 0, second_jump}};
  return network;
}

// A square with a curl in its upper side, in front on its way in, of less than half a pixel if the
// scale is 1.
CurveNetwork curled_square(int first_jump, int second_jump, double scale = 1) {
  const double left = -.2 * scale, right = .1 * scale, up = 50 + .3 * scale, down = 50 - .2 * scale;
  return closed_through({{50, -50, 0},
                         {50, 50, 0},
                         {left, 50, 0},
                         {left, up, -1},
                         {right, up, -1},
                         {right, down, -1},
                         {-50, down, -1},
                         {-50, -50, -1}},
                        first_jump, second_jump);
}

TEST(Twists, OfUnbalancedPathsAreDropped) {
  const CurveNetwork network = curled_square(0, 0);
  Arrangement arrangement = arrange(network, one_px);
  ASSERT_EQ(arrangement.crossings().size(), 1U);
  ASSERT_EQ(std::abs(imbalance(arrangement, arrangement.paths()[0])), 2);
  double moved_px = 0;
  EXPECT_EQ(drop_twists_and_lenses(arrangement, moved_px), 1);
  EXPECT_EQ(imbalance(arrangement, arrangement.paths()[0]), 0);
  EXPECT_NEAR(moved_px, std::hypot(.3, .3), 1e-3);
}

// Beside a pinch point the mesh may curl a contour a little more, but only that explains its sum.
TEST(Twists, OfTwoPixelsAreDroppedWhereNothingElseUnbalancesAPath) {
  const auto dropped = [](int jump, double scale) {
    const CurveNetwork network = curled_square(jump, 0, scale);
    Arrangement arrangement = arrange(network, one_px);
    double moved_px = 0;
    return drop_twists_and_lenses(arrangement, moved_px);
  };
  EXPECT_EQ(dropped(0, 4), 1);
  EXPECT_EQ(dropped(0, 5), 0);
  EXPECT_EQ(dropped(-1, 4), 0);
  EXPECT_EQ(dropped(1, 4), 0);
}

// Two cusps and a crossing that undo each other are the image of a fold, however small.
TEST(Twists, ThatBalanceAPathAreKept) {
  CurveNetwork network = curled_square(0, 0);
  const Arrangement bare = arrange(network, one_px);
  const int half = -imbalance(bare, bare.paths()[0]) / 2;
  network = curled_square(half, half);
  Arrangement arrangement = arrange(network, one_px);
  ASSERT_EQ(imbalance(arrangement, arrangement.paths()[0]), 0);
  double moved_px = 0;
  EXPECT_EQ(drop_twists_and_lenses(arrangement, moved_px), 0);
  EXPECT_TRUE(arrangement.is_live(0));
  EXPECT_EQ(moved_px, 0);
}

// The edge of a square hole with two swallowtails: the one above, of 0.4 px, crosses itself next to
// its tail, the crossing of the one below, of 0.6 px, is lost.
CurveNetwork hole_with_two_swallowtails() {
  const std::vector<Points> strands{
      {{.3, -50, 0}, {50, -50, 0}, {50, 50, 0}, {.5, 49.9, 0}, {-.2, 50.2, 0}},
      {{-.2, 50.2, 0}, {.2, 50.2, -1}},
      {{.2, 50.2, -1}, {-.5, 49.9, -1}, {-50, 50, -1}, {-50, -50, -1}, {-.3, -50, 0}},
      {{-.3, -50, 0}, {.3, -50, 0}}};
  CurveNetwork network;
  for (int s = 0; s < 4; ++s) {
    const int next = (s + 1) % 4;
    network.nodes.push_back({NodeKind::cusp, strands[idx(s)].front()});
    network.ties.push_back({next, s, next, 1});
    for (const Vec3& p : strands[idx(s)]) network.points.push({p, {}});
    network.points.close_list();
    network.strands.push_back({Kind::silhouette, 0, s, next, 0, 2});
  }
  return network;
}

TEST(Swallowtails, ThatCrossThemselvesStay) {
  const CurveNetwork network = hole_with_two_swallowtails();
  Arrangement arrangement = arrange(network, one_px);
  ASSERT_EQ(arrangement.crossings().size(), 1U);
  const Path& path = arrangement.paths()[0];
  ASSERT_EQ(imbalance(arrangement, path), 2);
  double moved_px = 0;
  EXPECT_EQ(collapse_swallowtails(arrangement, moved_px), 1);
  EXPECT_EQ(path.jumps, (std::vector<int>{0, 1, 1, 0}));
  EXPECT_EQ(imbalance(arrangement, path), 0);
  EXPECT_NEAR(moved_px, .6, 1e-3);
}

// A contour along the x axis, its surface above it, and a curve that comes from above, runs through
// it at the origin and leaves with this slope, to cross it again, 0.3 px further on, past a node.
CurveNetwork contour_run_through(double slope) {
  const Vec3 joint(0, 0, 0), past(.2, .2 * slope, 0);
  CurveNetwork network;
  network.nodes = {{NodeKind::joint, joint}, {NodeKind::joint, past}};
  const auto add_strand = [&](Kind kind, const Points& points, int start, int end) {
    for (const Vec3& p : points) network.points.push({p, {}});
    network.points.close_list();
    const auto node = [&](int given, const Vec3& p) {
      if (given != none) return given;
      network.nodes.push_back({NodeKind::end, p});
      return static_cast<int>(network.nodes.size()) - 1;
    };
    Strand strand;
    strand.kind = kind;
    strand.start_node = node(start, points.front());
    strand.end_node = node(end, points.back());
    strand.left_layers = kind == Kind::silhouette ? 2 : 0;
    network.strands.push_back(strand);
  };
  const Vec3 left(-10, 0, 0), right(10, 0, 0), above(-10, 3, 0), behind(.5, -.3 * slope, 0);
  add_strand(Kind::silhouette, {left, joint}, none, 0);
  add_strand(Kind::silhouette, {joint, right}, 0, none);
  add_strand(Kind::intersection, {above, joint}, none, 0);
  add_strand(Kind::intersection, {joint, past}, 0, 1);
  add_strand(Kind::intersection, {past, behind, Vec3(10, -3 * slope, 0)}, 1, none);
  network.ties = {{0, 0, 1, 1}, {0, 2, 3, 1}, {1, 3, 4, 0}};
  return network;
}

TEST(Touches, OfACurveThatLeavesItsSurfaceAreDroppedPastNodes) {
  const CurveNetwork network = contour_run_through(-.25);
  Arrangement arrangement = arrange(network, one_px);
  ASSERT_EQ(arrangement.crossings().size(), 1U);
  double moved_px = 0;
  EXPECT_EQ(drop_touches(arrangement, moved_px), 1);
  EXPECT_FALSE(arrangement.is_live(0));
  EXPECT_NEAR(moved_px, .32, .01);
}

TEST(Touches, OfACurveThatStaysOnItsSurfaceAreNone) {
  const CurveNetwork network = contour_run_through(.25);
  Arrangement arrangement = arrange(network, one_px);
  ASSERT_EQ(arrangement.crossings().size(), 1U);
  double moved_px = 0;
  EXPECT_EQ(drop_touches(arrangement, moved_px), 0);
  EXPECT_TRUE(arrangement.is_live(0));
}

// A contour and a feature curve come from the left to a joint at the origin and to this second
// node, their polylines crossing before that; the curve goes on to the right.
struct Approach : CurveNetwork {
  Approach(NodeKind second, const Vec3& second_at) {
    nodes = {{NodeKind::joint, Vec3::Zero()},
             {second, second_at},
             {NodeKind::end, Vec3(-20, .5, 0)},
             {NodeKind::end, Vec3(-20, -.5, -1)},
             {NodeKind::end, Vec3(20, -3, 0)}};
  }

  void add_strand(Kind kind, const Points& way, int start, int end, int left_layers) {
    for (const Vec3& p : way) points.push({p, {}});
    points.close_list();
    strands.push_back({kind, 0, start, end, left_layers, 0});
  }
  void add_curve(Kind kind, int left_layers) {
    add_strand(kind, {nodes[2].position, Vec3(-.2, -.05, 0), nodes[0].position}, 2, 0, left_layers);
  }
  void add_rest(Kind kind, int from, int left_layers) {
    add_strand(kind, {nodes[idx(from)].position, nodes[4].position}, from, 4, left_layers);
  }
  void add_contour() {
    add_strand(Kind::silhouette,
               {nodes[3].position, Vec3(-.4, -.05, -1), Vec3(-.1, .05, -1), nodes[1].position}, 3,
               1, 2);
  }
};

// A contour that ends on a crease; the crease has a node, where one of its sides turns back, just
// before that or this far along.
CurveNetwork contour_ends_beside_a_node(double link_px, Kind link) {
  Approach network(NodeKind::joint, Vec3(link_px, 0, 0));
  network.add_curve(Kind::crease, 0);
  network.add_strand(link, {network.nodes[0].position, network.nodes[1].position}, 0, 1,
                     link == Kind::silhouette ? 2 : 0);
  network.add_rest(Kind::crease, 1, 0);
  network.add_contour();
  return network;
}

TEST(Touches, OfAContourWithTheCreaseThatItEndsOnAreDroppedPastANode) {
  const auto dropped = [](double link_px, Kind link) {
    const CurveNetwork network = contour_ends_beside_a_node(link_px, link);
    Arrangement arrangement = arrange(network, one_px);
    EXPECT_EQ(arrangement.crossings().size(), 1U);
    double moved_px = 0;
    return drop_touches(arrangement, moved_px);
  };
  EXPECT_EQ(dropped(.3, Kind::crease), 1);
  EXPECT_EQ(dropped(3, Kind::crease), 0) << "farther than a touch";
  EXPECT_EQ(dropped(.3, Kind::silhouette), 0) << "another contour between them";
}

// A contour that has a cusp this far from its end on a boundary.
CurveNetwork contour_ends_behind_a_cusp(double tip_px) {
  Approach network(NodeKind::cusp, Vec3(tip_px, 0, -.5));
  network.add_curve(Kind::boundary, 1);
  network.add_rest(Kind::boundary, 0, 1);
  network.add_contour();
  network.add_strand(Kind::silhouette, {network.nodes[1].position, network.nodes[0].position}, 1, 0,
                     2);
  network.ties = {{1, 2, 3, 1}};
  return network;
}

TEST(Touches, OfAContourThatEndsRightBehindACuspAreDropped) {
  const auto dropped = [](double tip_px) {
    const CurveNetwork network = contour_ends_behind_a_cusp(tip_px);
    Arrangement arrangement = arrange(network, one_px);
    EXPECT_EQ(arrangement.crossings().size(), 1U);
    double moved_px = 0;
    return drop_touches(arrangement, moved_px);
  };
  EXPECT_EQ(dropped(.05), 1);
  EXPECT_EQ(dropped(.5), 0) << "the cusp shows";
}

// Its surface is above the x axis; a fold whose contour comes to a cusp at the origin along the
// axis and leaves again just above, each on its own side. A curve comes over the tip from the left
// and runs through the lower strand, 0.2 px from the tip: the far strand if `ends_far`.
CurveNetwork curve_over_a_tip(bool ends_far) {
  const double far = -1;
  const Vec3 joint(.2, 0, far), tip(0, 0, far / 2), inside(5, .05, far);
  CurveNetwork network;
  network.nodes = {{NodeKind::joint, joint},
                   {NodeKind::cusp, tip},
                   {NodeKind::end, Vec3(10, -.1, far)},
                   {NodeKind::end, Vec3(10, .4, 0)},
                   {NodeKind::end, Vec3(-10, -.5, far)},
                   {NodeKind::end, inside}};
  const auto add_strand = [&](Kind kind, int start, int end) {
    network.points.push({network.nodes[idx(start)].position, {}});
    network.points.push({network.nodes[idx(end)].position, {}});
    network.points.close_list();
    Strand strand;
    strand.kind = kind;
    strand.start_node = start;
    strand.end_node = end;
    (kind == Kind::silhouette ? strand.right_layers : strand.left_layers) = 0;
    if (kind == Kind::silhouette) strand.left_layers = 2;
    network.strands.push_back(strand);
  };
  add_strand(Kind::silhouette, 3, 1);
  add_strand(Kind::silhouette, 1, 0);
  add_strand(Kind::silhouette, 0, 2);
  add_strand(Kind::intersection, 4, 0);
  add_strand(Kind::intersection, 0, 5);
  network.ties = {{1, 0, 1, ends_far ? 1 : -1}, {0, 1, 2, 1}, {0, 3, 4, 1}};
  return network;
}

// The jump of the curve at its joint, once touches have been dropped.
int jump_over_a_tip(bool ends_far) {
  const CurveNetwork network = curve_over_a_tip(ends_far);
  Arrangement arrangement = arrange(network, one_px);
  double moved_px = 0;
  drop_touches(arrangement, moved_px);
  for (const Path& path : arrangement.paths()) {
    if (network.strands[idx(path.strands[0])].kind == Kind::intersection) return path.jumps[1];
  }
  return 0;
}

// Beyond the tip there is one sheet. The curve runs off on the near one, or has passed behind the
// near contour, which its polyline missed.
TEST(Touches, OfACurveThatComesOverTheTipOfACuspAreWithItsNearStrand) {
  EXPECT_EQ(jump_over_a_tip(false), 1);
  EXPECT_EQ(jump_over_a_tip(true), -1);
}

// Two crossings with a contour, a tenth of a pixel across, behind it at the first and in front at
// the second; at its cusps the closed curve gains or loses what the first one changes.
CurveNetwork square_with_a_lens(int jump) {
  CurveNetwork network = closed_through({{50, -50, -1},
                                         {50, 50, -1},
                                         {1, 49.95, -1},
                                         {0, 50.05, -1},
                                         {0, 50.05, 1},
                                         {-1, 49.95, 1},
                                         {-50, 50, 1},
                                         {-50, -50, 0}},
                                        jump, jump);
  const Vec3 start(20, 50, 0), end(-20, 50, 0);
  network.points.push({start, {}});
  network.points.push({end, {}});
  network.points.close_list();
  network.nodes.push_back({NodeKind::end, start});
  network.nodes.push_back({NodeKind::end, end});
  Strand strand;
  strand.left_layers = 2;
  strand.start_node = 2;
  strand.end_node = 3;
  network.strands.push_back(strand);
  return network;
}

TEST(Lenses, ThatContradictThemselvesAreDroppedUnlessTheyBalanceAPath) {
  const auto imbalance_of_closed = [](const Arrangement& arrangement) {
    for (const Path& path : arrangement.paths()) {
      if (path.cyclic) return imbalance(arrangement, path);
    }
    return 99;
  };
  const CurveNetwork plain = square_with_a_lens(0);
  Arrangement arrangement = arrange(plain, one_px);
  ASSERT_EQ(arrangement.crossings().size(), 2U);
  const int change = imbalance_of_closed(arrangement);
  ASSERT_EQ(std::abs(change), 2);
  double moved_px = 0;
  EXPECT_EQ(drop_twists_and_lenses(arrangement, moved_px), 2);
  const CurveNetwork balanced = square_with_a_lens(-change / 2);
  arrangement = arrange(balanced, one_px);
  ASSERT_EQ(imbalance_of_closed(arrangement), 0);
  EXPECT_EQ(drop_twists_and_lenses(arrangement, moved_px), 0);
}

}  // namespace
}  // namespace illustrate
