// Silhouettes of rough surfaces, such as scans are: their limit surface has folds smaller than
// their triangles.
#include <gtest/gtest.h>

#include "contour/exact/exact_silhouettes.h"
#include "contour/network/network.h"
#include "contour/network/unseen.h"
#include "tests/cpp/cameras.h"
#include "tests/cpp/check_graph.h"
#include "tests/cpp/surface_checks.h"
#include "visibility/label_network.h"

namespace illustrate {
namespace {

using namespace surface_checks;

// A sphere whose vertices move in and out by up to `height`, the same on every machine.
PolygonMesh rough_sphere(int level, double height) {
  PolygonMesh mesh = shapes::icosphere_mesh(1, level);
  std::uint32_t state = 12345;
  for (Vec3& p : mesh.positions) {
    state = state * 1664525U + 1013904223U;
    p *= 1 + height * (state / 4294967296. - .5);
  }
  return mesh;
}

std::vector<Camera> views() {
  std::vector<Camera> cameras;
  for (const Vec3& direction : {Vec3(3, .4, 1), Vec3(-1, 2.5, .7), Vec3(.3, -2, -2)}) {
    cameras.push_back(cameras::perspective(3 * direction.normalized(), Vec3::Zero()));
    cameras.push_back(cameras::orthographic(direction, 1.2));
  }
  return cameras;
}

TEST(RoughSilhouettes, NeedFewRepairs) {
  const Surface surface = refined(rough_sphere(5, .01), at_level(0));
  const Bvh bvh(surface.positions, surface.triangles);
  const LimitSurface limit(surface);
  const std::vector<FeatureEdge> features = feature_edges(surface);
  Counts counts;
  std::size_t nodes = 0;
  for (const Camera& camera : views()) {
    const CurveNetwork network =
        build_network({surface, limit, features, IntersectionCurves()}, camera, {}, counts);
    const LabelledGraph graph = label_network(network, surface, bvh, camera, counts);
    check_graph(graph);
    nodes += graph.nodes.size();
  }
  EXPECT_GT(nodes, 1000U);
  EXPECT_LT(50 * counts["unbalanced_loops"], counts["loops"]);
  EXPECT_LT(10 * counts["repairs"], static_cast<std::int64_t>(nodes));
}

Silhouettes exact(const Surface& surface, const Camera& camera, Counts& counts, int threads = 1,
                  bool leave_out_unseen = false) {
  const ContourFunctions functions(surface, camera);
  LinearSilhouettes linear = linear_silhouettes(surface, functions);
  if (leave_out_unseen) {
    const Unseen unseen(surface, camera, Unseen::Evidence::certain, threads);
    counts["unseen_chains"] += leave_out_unseen_chains(unseen, linear);
    mark_unseen_segments(unseen, linear);
  }
  return exact_silhouettes(surface, LimitSurface(surface), functions, camera, linear,
                           Exactness::where_needed, counts, {}, threads);
}

Surface level_0(const std::vector<PolygonMesh>& meshes) {
  Counts report;
  return refined(meshes, at_level(0), report);
}

const Camera from_above = cameras::orthographic(Vec3(.02, .01, 1), 4);

TEST(RoughSilhouettes, AreTheSameAtAnyNumberOfThreads) {
  const Surface surface = level_0({rough_sphere(4, .05), rough_sphere(5, .01)});
  Counts counts;
  const Silhouettes one = exact(surface, from_above, counts);
  EXPECT_GT(counts["troubled_triangles"], 0);
  for (const int threads : {2, 5}) {
    const Silhouettes many = exact(surface, from_above, counts, threads);
    EXPECT_EQ(many.chains.offsets, one.chains.offsets);
    for (std::size_t i = 0; i < one.chains.values.size(); ++i) {
      EXPECT_EQ(many.chains.values[i].position, one.chains.values[i].position);
    }
  }
}

TEST(RoughSilhouettes, DoNotDependOnWhatDoesNotMeetThem) {
  const PolygonMesh left = rough_sphere(4, .05), right = shapes::moved(left, Vec3(2.5, .1, 0));
  Counts of_both, of_each;
  const Silhouettes both = exact(level_0({left, right}), from_above, of_both);
  std::size_t chains = 0;
  for (const PolygonMesh& mesh : {left, right}) {
    chains += exact(level_0({mesh}), from_above, of_each).chains.size();
  }
  EXPECT_EQ(both.chains.size(), chains);
  EXPECT_GT(of_both["troubled_triangles"], 0);
  EXPECT_EQ(of_both["troubled_triangles"], of_each["troubled_triangles"]);
  EXPECT_EQ(of_both["evaluations"], of_each["evaluations"]);
}

// A sphere that is half under a plate.
TEST(RoughSilhouettes, AreMadeExactWhereTheyMayBeSeen) {
  const PolygonMesh plate = shapes::polygon_mesh(
      {{0, -1.5, 1.5}, {1.5, -1.5, 1.5}, {1.5, 1.5, 1.5}, {0, 1.5, 1.5}}, {{0, 1, 2, 3}});
  const Surface surface = level_0({rough_sphere(5, .02), plate});
  Counts all, seen;
  const Silhouettes whole = exact(surface, from_above, all);
  const Silhouettes part = exact(surface, from_above, seen, 1, true);
  EXPECT_LT(10 * seen["evaluations"], 7 * all["evaluations"]);
  const auto cusps = [](const Silhouettes& found, double sign) {
    return std::count_if(
        found.chains.values.begin(), found.chains.values.end(),
        [sign](const ChainPoint& p) { return p.cusp_jump != 0 && sign * p.position.x() > .2; });
  };
  EXPECT_GT(cusps(whole, -1), 10);
  EXPECT_EQ(cusps(part, -1), cusps(whole, -1));
  EXPECT_GT(cusps(whole, 1), 10);
  EXPECT_EQ(cusps(part, 1), 0);
}

// A chain that is left out may share a triangle's surroundings with one that is not.
TEST(RoughSilhouettes, CloseAlsoWhereChainsBesideThemAreLeftOut) {
  const Camera near_by = cameras::orthographic(Vec3(.02, .01, 1), 2);
  Counts counts;
  for (double edge = -.5; edge < .9; edge += .05) {
    const PolygonMesh plate = shapes::polygon_mesh(
        {{edge, -1.5, 1.5}, {1.5, -1.5, 1.5}, {1.5, 1.5, 1.5}, {edge, 1.5, 1.5}}, {{0, 1, 2, 3}});
    const Surface surface = level_0({rough_sphere(5, .08), plate});
    const Silhouettes found = exact(surface, near_by, counts, 1, true);
    EXPECT_EQ(std::count(found.closed.begin(), found.closed.end(), std::uint8_t{0}), 0);
  }
  EXPECT_GT(counts["unseen_chains"], 10);
  EXPECT_GT(counts["troubled_triangles"], 10);
}

}  // namespace
}  // namespace illustrate
