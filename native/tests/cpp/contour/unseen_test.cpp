#include "contour/network/unseen.h"

#include <gtest/gtest.h>

#include <numeric>

#include "contour/network/network.h"
#include "tests/cpp/cameras.h"
#include "tests/cpp/check_graph.h"
#include "tests/cpp/shapes.h"
#include "visibility/label_network.h"
#include "visibility/labels/label_pile.h"

namespace illustrate {
namespace {

// A square of half a side's length, facing the cameras of these tests.
Surface plate(double half) {
  return shapes::plain_surface(shapes::polygon_mesh(
      {{-half, -half, 0}, {half, -half, 0}, {half, half, 0}, {-half, half, 0}}, {{0, 1, 2, 3}}));
}

// What stands far round and below a small thing.
Surface far_ground() {
  Surface ground = plate(1000);
  for (Vec3& p : ground.positions) p.z() -= 500;
  return ground;
}

constexpr auto certain = Unseen::Evidence::certain;

// 250 px to a unit, the origin at (500, 500).
const Camera seen_from_above = cameras::orthographic(Vec3::UnitZ(), 2);

TEST(OcclusionMap, HidesWhatIsBehindAllRound) {
  const Surface surface = plate(1);
  const OcclusionMap map(surface, render_visible(surface, seen_from_above, 1, {}, 1), 2);
  const double depth = seen_from_above.depth(Vec3::Zero());
  const auto hides = [&](double x, double y, double behind) {
    return map.hides(Vec2(x, y), Vec2(x, y), depth + behind);
  };
  EXPECT_TRUE(hides(500, 500, 1));
  EXPECT_FALSE(hides(500, 500, 0)) << "the plate itself";
  EXPECT_FALSE(hides(500, 500, -1)) << "in front";
  EXPECT_TRUE(hides(253.5, 500, 1));
  EXPECT_FALSE(hides(250.5, 500, 1)) << "nothing is seen 2 px to the left";
  EXPECT_FALSE(hides(100, 500, 1));
  EXPECT_FALSE(hides(-5, 500, 1));
  EXPECT_FALSE(map.hides(Vec2(400, 400), Vec2(500, 500), depth + 1)) << "too much to look at";
  EXPECT_FALSE(map.with_more_reach(6).hides(Vec2(257.5, 500), Vec2(257.5, 500), depth + 1));
  EXPECT_TRUE(map.with_more_reach(6).hides(Vec2(259.5, 500), Vec2(259.5, 500), depth + 1));
}

// What stands round a small thing says nothing of what that hides: its walls are flat, and hide
// what is behind them by a few pixels.
TEST(OcclusionMap, FlatThingsHideWhatIsCloseBehindThemInHugeScenes) {
  const auto polygons = [](Surface surface) {
    surface.object_is_smooth.assign(surface.object_is_smooth.size(), 0);
    return surface;
  };
  for (const Surface& surface :
       {polygons(plate(1)), polygons(shapes::joined(plate(1), far_ground()))}) {
    const VisibleImage image = render_visible(surface, seen_from_above, 1, {}, 1);
    const double depth = seen_from_above.depth(Vec3::Zero());
    for (const OcclusionMap& map :
         {OcclusionMap(surface, image, 2), OcclusionMap(surface, image, seen_from_above)}) {
      EXPECT_TRUE(map.hides(Vec2(500, 500), Vec2(500, 500), depth + 0.02));
      EXPECT_FALSE(map.hides(Vec2(500, 500), Vec2(500, 500), depth));
    }
  }
}

// A curved surface does so as far as its own size asks for.
TEST(OcclusionMap, CurvedThingsHideWhatIsCloseBehindThemInHugeScenes) {
  const auto gap = [](const Surface& surface) {
    const OcclusionMap map(surface, render_visible(surface, seen_from_above, 1, {}, 1), 2);
    const double depth = seen_from_above.depth(Vec3::UnitZ());
    double behind = 0;
    while (!map.hides(Vec2(500, 500), Vec2(500, 500), depth + behind)) behind += 0.01;
    return behind;
  };
  const Surface ball = shapes::sphere_surface(1, 2);
  EXPECT_LT(gap(ball), 0.05);
  EXPECT_LT(gap(shapes::joined(ball, far_ground())), 0.05 * ball.diagonal + 0.02);
}

// One strand from far left of the plate to under its middle.
CurveNetwork line_under_plate(double from) {
  CurveNetwork network;
  network.nodes = {{NodeKind::end, Vec3(from, 0, -1)}, {NodeKind::end, Vec3(0, 0, -1)}};
  for (const NetworkNode& node : network.nodes) network.points.push({node.position, {0, 0, 0}});
  network.points.close_list();
  Strand strand;
  strand.start_node = 0;
  strand.end_node = 1;
  network.strands.push_back(strand);
  return network;
}

double start_px(const CurveNetwork& network, std::size_t strand) {
  return seen_from_above.project(network.points[strand].front().position).xy.x();
}

TEST(Unseen, StrandsAreCutALittleBeyondWhatHidesThem) {
  const Surface surface = plate(1);
  const Unseen unseen(surface, seen_from_above, certain, 1);
  const CurveNetwork cut = cut_at_unseen(unseen, line_under_plate(-1.9));
  ASSERT_EQ(cut.strands.size(), 2U) << "covered stretches of a few pixels are no strands";
  EXPECT_EQ(cut.strands[0].sight, Sight::possible);
  EXPECT_EQ(cut.strands[1].sight, Sight::buried);
  const double edge = 250, piece = 4;
  EXPECT_GE(start_px(cut, 1), edge + 8);
  EXPECT_LE(start_px(cut, 1), edge + 8 + 1 + piece);
  EXPECT_EQ(cut.strands[0].start_node, 0);
  EXPECT_EQ(cut.strands[0].end_node, cut.strands[1].start_node);
  EXPECT_EQ(cut.strands[1].end_node, 1);
  EXPECT_EQ(cut.points[0].back().position, cut.points[1].front().position);
  EXPECT_EQ(cut.nodes[idx(cut.strands[0].end_node)].kind, NodeKind::joint);
}

TEST(Unseen, StrandsAlongAnEdgeAreCovered) {
  const Surface surface = plate(1);
  CurveNetwork network = line_under_plate(-1.9);
  for (std::size_t i = 0; i < 2; ++i) {
    Vec3& p = network.nodes[i].position;
    p.y() = 1 - 5. / 250;
    network.points.values[i].position = p;
  }
  const CurveNetwork cut = cut_at_unseen(Unseen(surface, seen_from_above, certain, 1), network);
  ASSERT_EQ(cut.strands.size(), 2U);
  EXPECT_EQ(cut.strands[1].sight, Sight::covered);
}

TEST(Unseen, StrandsAreCutBeyondTheFrame) {
  const Surface surface = plate(0.1);
  const CurveNetwork cut =
      cut_at_unseen(Unseen(surface, seen_from_above, certain, 1), line_under_plate(-100));
  ASSERT_GE(cut.strands.size(), 2U);
  EXPECT_EQ(cut.strands[0].sight, Sight::beyond_frame);
  EXPECT_EQ(cut.strands[1].sight, Sight::possible);
  EXPECT_LE(start_px(cut, 1), 0);
}

// Balls in a block, so that most of each is behind others.
Surface block_of_balls(int side) {
  Surface surface = shapes::sphere_surface(1, 2);
  for (int i = 1; i < side * side * side; ++i) {
    const int row = i / side % side, layer = i / side / side;
    const Vec3 centre(i % side, row, layer);
    surface = shapes::joined(std::move(surface), shapes::sphere_surface(1, 2, 2.2 * centre));
  }
  return surface;
}

double seen_length(const LabelledGraph& graph, int object) {
  double length = 0;
  for (std::size_t a = 0; a < graph.arcs.size(); ++a) {
    if (graph.arcs[a].object != object || graph.arcs[a].invisibility > 0) continue;
    for (std::size_t i = 1; i < graph.image[a].size(); ++i) {
      length += (graph.image[a][i] - graph.image[a][i - 1]).norm();
    }
  }
  return length;
}

class BlockOfBalls : public testing::Test {
 protected:
  LabelledGraph label(const CurveNetwork& of, Counts& found) const {
    LabelledGraph graph = label_network(of, surface, bvh, camera, found);
    check_graph(graph);
    return graph;
  }

  // (objects) px
  static std::vector<double> seen_lengths(const LabelledGraph& graph) {
    std::vector<double> lengths;
    for (int object = 0; object < side * side * side; ++object) {
      lengths.push_back(seen_length(graph, object));
    }
    return lengths;
  }

  static constexpr int side = 4;
  Counts counts;
  const Surface surface = block_of_balls(side);
  const Camera camera = cameras::perspective(Vec3(-12, -15, 13), Vec3(3, 3, 3));
  const Bvh bvh{surface.positions, surface.triangles};
  const CurveNetwork network =
      build_network({surface, LimitSurface(surface), {}, {}}, camera, {}, counts);
};

TEST_F(BlockOfBalls, HasTheSameLinesWithoutWhatIsUnseen) {
  const CurveNetwork cut = cut_at_unseen(Unseen(surface, camera, certain, 1), network);
  Counts whole_counts, cut_counts;
  const std::vector<double> whole = seen_lengths(label(network, whole_counts));
  const std::vector<double> seen = seen_lengths(label(cut, cut_counts));
  EXPECT_LT(2 * cut_counts["crossings"], whole_counts["crossings"]);
  EXPECT_LE(cut_counts["repairs"], whole_counts["repairs"]);
  for (std::size_t i = 0; i < whole.size(); ++i) EXPECT_NEAR(seen[i], whole[i], 0.5) << i;
  EXPECT_GT(std::accumulate(seen.begin(), seen.end(), 0.), 1000);
}

TEST_F(BlockOfBalls, HasNearlyTheSameLinesAsAPile) {
  const LabelledGraph pile = label_pile(network, surface, camera, 1);
  check_graph(pile);
  const std::vector<double> sampled = seen_lengths(pile);
  const std::vector<double> settled = seen_lengths(label(network, counts));
  EXPECT_EQ(counts["sampled_views"], 0);
  double off = 0;
  for (std::size_t i = 0; i < settled.size(); ++i) off += std::abs(sampled[i] - settled[i]);
  EXPECT_LT(off, 0.02 * std::accumulate(settled.begin(), settled.end(), 0.));
}

TEST_F(BlockOfBalls, IsSampledWhereCurvesAreMissing) {
  CurveNetwork incomplete = network;
  incomplete.is_incomplete = true;
  label(incomplete, counts);
  EXPECT_EQ(counts["sampled_views"], 1);
}

TEST(Unseen, ChainsWithinWallsAreLeftOut) {
  const Surface surface =
      shapes::joined(plate(1), shapes::joined(shapes::sphere_surface(0.3, 2, Vec3(0, 0, -1)),
                                              shapes::sphere_surface(0.3, 2, Vec3(1, 0, -1))));
  const ContourFunctions functions(surface, seen_from_above);
  LinearSilhouettes found = linear_silhouettes(surface, functions);
  ASSERT_EQ(found.chains.size(), 2U);
  EXPECT_EQ(leave_out_unseen_chains(Unseen(surface, seen_from_above, certain, 1), found), 1);
  for (std::size_t c = 0; c < 2; ++c) {
    EXPECT_EQ(found.is_left_out(c), found.chains[c].front().position.x() < 0.6);
  }
}

}  // namespace
}  // namespace illustrate
