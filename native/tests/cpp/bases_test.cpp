#include "visibility/bases.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "cameras.h"
#include "visibility/repairs.h"

namespace illustrate {
namespace {

const Camera one_px = cameras::orthographic(Vec3(0, 0, 1), 500);  // a world unit is a pixel

// Two squares that overlap, the first one in front.
CurveNetwork overlapping_squares(double overlap_px = 50) {
  CurveNetwork network;
  for (const double shift : {0., 100 - overlap_px}) {
    for (const Vec2& p : {Vec2(0, 0), Vec2(100, 0), Vec2(100, 100), Vec2(0, 100)}) {
      network.points.push({Vec3(p.x() + shift, p.y() + shift, -shift), {}});
    }
    network.points.close_list();
    Strand strand;
    strand.left_layers = 2;
    network.strands.push_back(strand);
  }
  return network;
}

LabelledPath path_with(const Arrangement& arrangement, std::size_t p, int base, double weight) {
  LabelledPath path;
  path.labels = relative_labels(arrangement, arrangement.paths[p]);
  std::vector<Evidence> evidence;
  for (const PathArc& arc : path.labels.arcs) evidence.push_back({base + arc.offset, 0, weight});
  int lowest = 0;
  for (const PathArc& arc : path.labels.arcs) lowest = std::min(lowest, arc.offset);
  for (Evidence& e : evidence) e.layers -= lowest;
  EXPECT_TRUE(choose_base(evidence, true, path));
  return path;
}

std::vector<int> smallest_labels(double front_weight, double back_weight) {
  const CurveNetwork network = overlapping_squares();
  const Arrangement arrangement = arrange(network, one_px);
  EXPECT_EQ(arrangement.crossings.size(), 2U);
  std::vector<LabelledPath> paths{path_with(arrangement, 0, 1, front_weight),
                                  path_with(arrangement, 1, 0, back_weight)};
  EXPECT_TRUE(settle_bases(arrangement, paths).empty());
  std::vector<int> result;
  for (const LabelledPath& path : paths) {
    result.push_back(*std::min_element(path.along.begin(), path.along.end()));
  }
  return result;
}

// The back square has one layer less than the front one where they cross. Whichever the rays are
// less sure of moves.
TEST(Bases, OfPathsThatRaysSayLittleOfYield) {
  EXPECT_EQ(smallest_labels(15, .5), (std::vector<int>{1, 1}));
  EXPECT_EQ(smallest_labels(.5, 15), (std::vector<int>{0, 0}));
}

// A path that had to be broken follows rays alone: it does not talk others out of theirs.
TEST(Bases, StayWhereABrokenPathContradictsThem) {
  const CurveNetwork network = overlapping_squares();
  const Arrangement arrangement = arrange(network, one_px);
  std::vector<LabelledPath> paths{path_with(arrangement, 0, 1, 15),
                                  path_with(arrangement, 1, 0, 15)};
  paths[0].costs.clear();
  const std::vector<int> before = paths[1].along;
  EXPECT_FALSE(settle_bases(arrangement, paths).empty());
  EXPECT_EQ(paths[1].along, before);
}

// Its crossings go before long stretches of line do, where corners just touch.
TEST(Bases, StayWhereAThinLensContradictsThem) {
  const CurveNetwork network = overlapping_squares(.05);
  Arrangement arrangement = arrange(network, one_px);
  std::vector<LabelledPath> paths{path_with(arrangement, 0, 1, 15),
                                  path_with(arrangement, 1, 0, 15)};
  const std::vector<int> wrong = settle_bases(arrangement, paths);
  EXPECT_EQ(wrong, (std::vector<int>{0, 1}));
  EXPECT_EQ(paths[0].along, (std::vector<int>{1, 1}));
  double moved_px = 0;
  EXPECT_EQ(drop_lenses(arrangement, wrong, moved_px), 2);
}

// Where rays miss a layer on one arc or meet one too many on the other, they have missed one.
TEST(Bases, AreTheHigherOnesWhereRaysDisagree) {
  const CurveNetwork network = overlapping_squares();
  const Arrangement arrangement = arrange(network, one_px);
  LabelledPath path;
  path.labels = relative_labels(arrangement, arrangement.paths[1]);
  const std::vector<Evidence> evidence(path.labels.arcs.size(), {1, 0, 10});
  ASSERT_TRUE(choose_base(evidence, true, path));
  EXPECT_EQ(*std::min_element(path.along.begin(), path.along.end()), 1);
}

TEST(Bases, AreNoneWhereThePathRunsAlongTheOutsideWithTwoLabels) {
  const CurveNetwork network = overlapping_squares();
  Arrangement arrangement = arrange(network, one_px);
  arrangement.outline[1] = {{1, 0, .1}, {1, 0, .9}, {1, 1, .5}, {1, 2, .1}, {1, 2, .9}, {1, 3, .5}};
  LabelledPath path;
  path.labels = relative_labels(arrangement, arrangement.paths[1]);
  ASSERT_EQ(path.labels.arcs.size(), 2U);
  EXPECT_FALSE(choose_base(outline_evidence(arrangement, path.labels.arcs), true, path));
}

// The labels of a path of two long arcs, of one layer each as rays have it, and a short one between
// them where the rules ask for two layers less: along them, then at their starts and ends.
std::vector<std::vector<int>> with_a_negative_stretch(double long_px, bool cyclic,
                                                      std::size_t first) {
  LabelledPath path;
  std::vector<Evidence> evidence;
  for (std::size_t i = 0; i < 3; ++i) {
    const bool is_short = (first + i) % 3 == 1;
    PathArc arc{};
    arc.offset = is_short ? -2 : 0;
    path.labels.arcs.push_back(arc);
    evidence.push_back({is_short ? 0 : 1, 0, is_short ? .5 : long_px});
  }
  EXPECT_TRUE(choose_base(evidence, cyclic, path));
  return {path.along, path.at_start, path.at_end};
}

// Long stretches that a base contradicts only because a short one must not be negative.
TEST(Bases, AreCutWhereASpeckWouldLiftALongPath) {
  using Labels = std::vector<std::vector<int>>;
  EXPECT_EQ(with_a_negative_stretch(200, false, 0), (Labels{{1, 0, 1}, {1, 0, 2}, {2, 0, 1}}));
  EXPECT_EQ(with_a_negative_stretch(200, true, 1), (Labels{{0, 1, 1}, {0, 2, 1}, {0, 1, 2}}));
  EXPECT_EQ(with_a_negative_stretch(200, false, 1), (Labels{{0, 1, 1}, {0, 2, 1}, {0, 1, 1}}));
  EXPECT_EQ(with_a_negative_stretch(20, true, 0), (Labels(3, {2, 0, 2})));
}

// What rays say of a boundary of 18 px behind a plate that has a slot of this width at its middle.
Evidence behind_a_slotted_plate(double slot_px) {
  CurveNetwork network;
  network.nodes = {{NodeKind::end, Vec3(-9, 0, 0)}, {NodeKind::end, Vec3(9, 0, 0)}};
  for (const NetworkNode& node : network.nodes) network.points.push({node.position, {}});
  network.points.close_list();
  network.strands.push_back({Kind::boundary, 0, 0, 1, 1, 0});
  Surface surface;
  surface.diagonal = 200;
  for (const double side : {-1., 1.}) {
    const int first = static_cast<int>(surface.positions.size());
    const double near = side * slot_px / 2, far = side * (slot_px / 2 + 40);
    for (const Vec2& p : {Vec2(near, -40), Vec2(far, -40), Vec2(far, 40), Vec2(near, 40)}) {
      surface.positions.emplace_back(p.x(), p.y(), 50);
    }
    surface.triangles.push_back({first, first + 1, first + 2});
    surface.triangles.push_back({first, first + 2, first + 3});
  }
  const Arrangement arrangement = arrange(network, one_px);
  const Bvh bvh(surface.positions, surface.triangles);
  LayerRays rays(surface, bvh, one_px);
  KnownEvidence known;
  std::vector<Evidence> evidence{{0, 0, 0}};
  ask_rays(arrangement, relative_labels(arrangement, arrangement.paths[0]).arcs, rays, known,
           evidence);
  return evidence.front();
}

TEST(Evidence, OneRayThatMeetsNothingIsNotBelievedAlone) {
  const Evidence hidden = behind_a_slotted_plate(2), free = behind_a_slotted_plate(30);
  EXPECT_EQ(hidden.layers, 1);
  EXPECT_FALSE(hidden.beside_nothing);
  EXPECT_NEAR(hidden.weight, 18, 1e-3);
  EXPECT_EQ(free.layers, 0);
  EXPECT_TRUE(free.beside_nothing);
  EXPECT_NEAR(free.weight, 18 + 3 * 18, 1e-3);
}

}  // namespace
}  // namespace illustrate
