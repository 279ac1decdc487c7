#include "visibility/arrangement/touch_images.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/cpp/cameras.h"
#include "visibility/labels/repairs.h"

namespace illustrate {
namespace {

const Camera one_px = cameras::orthographic(Vec3(0, 0, 1), 500);  // a world unit is a pixel

const Points fold{{0, 0, 0}, {1, 0, 0}, {3, -.1, 0}, {3.6, -.08, 0}, {5, -.1, 0}, {20, -4, 0}};
const Points rim{{0, 0, -1},    {1, .05, -1}, {3.2, -.15, -1},
                 {4, -.14, -1}, {6, .2, -1},  {20, 9, -1}};

// A fold, its surface above it, that ends on the rim of that surface; the rim's polyline stands out
// of the fold from 2.3 to 4.6 px behind their joint. There something else may run across both.
CurveNetwork rim_beside_fold(bool turned, bool is_crossed) {
  CurveNetwork network;
  network.nodes = {{NodeKind::joint, fold.front()}};
  const auto add_strand = [&](Kind kind, Points points, int start, int left_layers) {
    const int end = static_cast<int>(network.nodes.size());
    network.nodes.push_back({NodeKind::end, points.back()});
    Strand strand{kind, 0, start, end, left_layers, 2 - left_layers};
    if (turned) {
      std::reverse(points.begin(), points.end());
      std::swap(strand.start_node, strand.end_node);
      std::swap(strand.left_layers, strand.right_layers);
    }
    for (const Vec3& p : points) network.points.push({p, {}});
    network.points.close_list();
    network.strands.push_back(strand);
  };
  add_strand(Kind::silhouette, fold, 0, 2);
  add_strand(Kind::boundary, rim, 0, 1);
  if (!is_crossed) return network;
  network.nodes.push_back({NodeKind::end, Vec3(3.7, 3, 1)});
  add_strand(Kind::boundary, {Vec3(3.7, 3, 1), Vec3(3.7, -3, 1)}, 3, 1);
  return network;
}

// Strand points in world units, from the joint on.
std::vector<Vec2> drawn(const Arrangement& arrangement, int strand) {
  std::vector<Vec2> line;
  for (int i = 0; i < arrangement.point_count(strand); ++i) {
    const Vec2& image = arrangement.image_of(strand, i);
    line.emplace_back(image.x() - 500, 500 - image.y());
  }
  if (line.front().x() > line.back().x()) std::reverse(line.begin(), line.end());
  return line;
}

double height(const std::vector<Vec2>& line, double x) {
  std::size_t i = 1;
  while (line[i].x() < x) ++i;
  const Vec2 along = line[i] - line[i - 1];
  return line[i - 1].y() + along.y() * (x - line[i - 1].x()) / along.x();
}

Arrangement pulled_together(const CurveNetwork& network) {
  Arrangement arrangement = arrange(network, one_px);
  double moved_px = 0;
  EXPECT_EQ(drop_touches(arrangement, moved_px), 2);
  pull_touches_together(arrangement, dropped_crossings(arrangement));
  return arrangement;
}

TEST(TouchImages, DoNotStandOutOfTheFold) {
  for (const bool turned : {false, true}) {
    const CurveNetwork network = rim_beside_fold(turned, false);
    const Arrangement before = arrange(network, one_px), after = pulled_together(network);
    EXPECT_LT(height(drawn(before, 1), 4) - height(drawn(before, 0), 4), -.04);
    for (double x = .05; x < 20; x += .05) {
      EXPECT_GE(height(drawn(after, 1), x) - height(drawn(after, 0), x), -1e-4) << x;
      EXPECT_NEAR(height(drawn(after, 0), x), height(drawn(before, 0), x), .02) << x;
    }
  }
}

TEST(TouchImages, AreMovedNowhereElse) {
  const CurveNetwork network = rim_beside_fold(false, false);
  const Arrangement before = arrange(network, one_px), after = pulled_together(network);
  for (const int p : {0, 1, 4, 5}) {
    EXPECT_EQ(after.image_of(1, p), before.image_of(1, p)) << p;
  }
}

// What hangs out that far is no noise; drawn onto the fold, the other curve would stand out of it.
TEST(TouchImages, StayWhereTheyAreFarOutside) {
  CurveNetwork network = rim_beside_fold(false, false);
  network.points.values[fold.size() + 3].position.y() = -.5;
  const Arrangement before = arrange(network, one_px), after = pulled_together(network);
  EXPECT_EQ(after.image_of(1, 3), before.image_of(1, 3));
}

// Its crossings would no longer lie on the curves.
TEST(TouchImages, StayWhereAnotherCurveCrosses) {
  const CurveNetwork network = rim_beside_fold(false, true);
  const Arrangement before = arrange(network, one_px), after = pulled_together(network);
  ASSERT_EQ(after.live_crossings(), 2);
  for (int c = 0; c < static_cast<int>(after.crossings().size()); ++c) {
    if (!after.is_live(c)) continue;
    EXPECT_LT((after.image_at(after.crossing(c).back) - after.crossing(c).image).norm(), 1e-3);
  }
  EXPECT_EQ(drawn(after, 1), drawn(before, 1));
}

}  // namespace
}  // namespace illustrate
