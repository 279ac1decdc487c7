#include "visibility/labels/view_labels.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/cpp/cameras.h"
#include "visibility/prices.h"

namespace illustrate {
namespace {

using cameras::one_px;

// Closed silhouettes through these points, each with its surface on its left.
CurveNetwork closed_curves(const std::vector<Points>& curves) {
  CurveNetwork network;
  for (const Points& curve : curves) {
    for (const Vec3& p : curve) network.points.push({p, {}});
    network.points.close_list();
    Strand strand;
    strand.left_layers = 2;
    network.strands.push_back(strand);
  }
  return network;
}

// A square of 100 px, and behind it a triangle whose tip looks out of its right side: between the
// crossings lie 2 `half` px of the square.
CurveNetwork square_before_triangle(double half) {
  const Points square{{-50, -50, 0}, {50, -50, 0}, {50, 50, 0}, {-50, 50, 0}};
  const Points triangle{{0, 6 * half, -1}, {0, -6 * half, -1}, {60, 0, -1}};
  return closed_curves({square, triangle});
}

struct Scene {
  CurveNetwork network;
  Arrangement arrangement;
  std::vector<std::vector<PathArc>> arcs;

  explicit Scene(double half)
      : network(square_before_triangle(half)), arrangement(arrange(network, one_px)) {
    for (const Path& path : arrangement.paths()) arcs.push_back(path_arcs(arrangement, path));
  }

  // Labels of the triangle's two arcs, the longer one first, when its longer arc is said to have
  // this many layers for so many pixels, and the rest none.
  std::vector<int> triangle_labels(int layers, double weight, std::int64_t& repairs) {
    std::vector<std::vector<Evidence>> evidence{std::vector<Evidence>(arcs[0].size()),
                                                std::vector<Evidence>(arcs[1].size())};
    for (Evidence& e : evidence[0]) e = {0, 0, 1000, false};
    for (std::size_t i = 0; i < arcs[1].size(); ++i) {
      const bool is_hidden = arcs[1][i].length_px > 25;
      evidence[1][i] = {is_hidden ? layers : 0, 0, weight, false};
    }
    const ViewProblem view = state_labels(arrangement, arcs, evidence);
    const auto labelled =
        settle_labels(arrangement, arcs, view, least_labels(view.problem, view.start), repairs);
    std::vector<int> result = labelled[1].layers;
    std::sort(result.rbegin(), result.rend());
    return result;
  }
};

TEST(Crossings, OfTwoCoveredCurvesAreNotAskedFor) {
  CurveNetwork network = square_before_triangle(2);
  network.strands[0].sight = Sight::covered;
  EXPECT_EQ(arrange(network, one_px).crossings().size(), 2U);
  network.strands[1].sight = Sight::covered;
  EXPECT_EQ(arrange(network, one_px).crossings().size(), 0U);
}

TEST(Extents, OfALensIsTheShortestWayBetweenItsCrossings) {
  const Scene scene(2);
  ASSERT_EQ(scene.arrangement.crossings().size(), 2U);
  for (const double extent : extents(scene.arrangement, scene.arcs).crossings) {
    EXPECT_NEAR(extent, 4, 1e-3);
  }
}

TEST(Extents, OfACuspReachToTheNextOne) {
  CurveNetwork network;
  network.nodes = {{NodeKind::cusp, {0, 0, 0}}, {NodeKind::cusp, {30, 0, 0}}};
  const std::vector<Points> strands{{{0, 0, 0}, {30, 0, 0}}, {{30, 0, 0}, {30, 40, 0}, {0, 0, 0}}};
  for (const Points& points : strands) {
    for (const Vec3& p : points) network.points.push({p, {}});
    network.points.close_list();
  }
  network.strands.resize(2);
  for (const int s : {0, 1}) {
    network.strands[idx(s)].start_node = s;
    network.strands[idx(s)].end_node = 1 - s;
  }
  network.ties = {{1, 0, 1, 1}, {0, 1, 0, -1}};
  const Arrangement arrangement = arrange(network, one_px);
  const Extents found = extents(arrangement, {path_arcs(arrangement, arrangement.paths()[0])});
  EXPECT_NEAR(found.cusps[0][0], 30, 1e-3);
  EXPECT_NEAR(found.cusps[0][1], 30, 1e-3);
}

TEST(Extents, OfACuspEndWhereThePathGoesUnderCover) {
  CurveNetwork network;
  const double ways[]{0, 30, 42, 90};
  for (const double x : ways) network.nodes.push_back({NodeKind::joint, {x, 0, 0}});
  network.nodes[1].kind = NodeKind::cusp;
  for (int s = 0; s < 3; ++s) {
    network.points.push({network.nodes[idx(s)].position, {}});
    network.points.push({network.nodes[idx(s) + 1].position, {}});
    network.points.close_list();
    network.strands.push_back({Kind::silhouette, 0, s, s + 1});
  }
  network.strands[2].sight = Sight::buried;
  network.ties = {{1, 0, 1, 1}};
  const Arrangement arrangement = arrange(network, one_px);
  const Extents found = extents(arrangement, arcs_of_paths(arrangement));
  EXPECT_NEAR(found.cusps[0][1], 12, 1e-3);
}

TEST(ViewLabels, FollowRaysThatObeyTheRules) {
  Scene scene(2);
  std::int64_t repairs = 0;
  EXPECT_EQ(scene.triangle_labels(2, 100, repairs), (std::vector<int>{2, 0}));
  EXPECT_EQ(repairs, 0);
  EXPECT_EQ(scene.arrangement.live_crossings(), 2);
}

TEST(ViewLabels, RatherHideALineThanShowWhatHides) {
  const CurveNetwork network =
      closed_curves({{{-50, -50, 0}, {50, -50, 0}, {50, 50, 0}, {-50, 50, 0}}});
  const Arrangement arrangement = arrange(network, one_px);
  const std::vector<std::vector<PathArc>> arcs{path_arcs(arrangement, arrangement.paths()[0])};
  const ViewProblem view = state_labels(arrangement, arcs, {{{2, 0, 10, false}}});
  const auto pixels = [&](int label) {
    return static_cast<double>(price(view.problem, {label})) / price_of_pixel;
  };
  EXPECT_EQ(pixels(2), 0);
  EXPECT_EQ(pixels(1), 10);
  EXPECT_EQ(pixels(0), 20 + 10 * prices.shown_share);
}

TEST(ViewLabels, KeepTheRulesWhereARayIsWrong) {
  Scene scene(4);  // a crossing of 8 px costs 40 px, and the least that both could cost is 80
  std::int64_t repairs = 0;
  EXPECT_EQ(scene.triangle_labels(0, 10, repairs), (std::vector<int>{2, 0}));
  EXPECT_EQ(repairs, 0);
}

TEST(ViewLabels, GiveUpThinLensesThatContradictTheRays) {
  Scene scene(0.1);  // 1 px of price at each crossing, below the least
  std::int64_t repairs = 0;
  EXPECT_EQ(scene.triangle_labels(0, 100, repairs), (std::vector<int>{0, 0}));
  EXPECT_EQ(repairs, 2);
  EXPECT_EQ(scene.arrangement.live_crossings(), 0);
}

// One unknown for the square, two for the triangle: it passes behind the square twice.
TEST(ViewLabels, HaveOneUnknownBetweenPlacesWhereTheyChange) {
  const Scene scene(2);
  const std::vector<std::vector<Evidence>> nothing{std::vector<Evidence>(scene.arcs[0].size()),
                                                   std::vector<Evidence>(scene.arcs[1].size())};
  const ViewProblem view = state_labels(scene.arrangement, scene.arcs, nothing);
  EXPECT_EQ(view.problem.unknowns, 3);
  EXPECT_EQ(view.problem.values.size(), 0U);
  EXPECT_EQ(view.problem.differences.size(), 6U);  // two changes, four sides
}

}  // namespace
}  // namespace illustrate
