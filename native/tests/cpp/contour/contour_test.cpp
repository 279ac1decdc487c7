#include <gtest/gtest.h>

#include "contour/exact/exact_silhouettes.h"
#include "contour/network/network.h"
#include "contour/silhouettes.h"
#include "tests/cpp/cameras.h"
#include "tests/cpp/shapes.h"

namespace illustrate {
namespace {

LinearSilhouettes silhouettes_of(const Surface& surface, const Camera& camera) {
  return linear_silhouettes(surface, ContourFunctions(surface, camera));
}

// Of a surface without a limit all cusps are linear.
std::int64_t cusps_of(const Surface& surface, const Camera& camera) {
  const ContourFunctions functions(surface, camera);
  Counts counts;
  return exact_silhouettes(surface, LimitSurface(surface), functions, camera,
                           linear_silhouettes(surface, functions), Exactness::where_needed, counts)
      .cusps;
}

// Closed chains never leave through an open edge; open ones end where no smooth neighbour is.
void check_silhouettes(const Surface& surface, const LinearSilhouettes& found) {
  std::vector<int> segments(surface.triangles.size(), 0);
  for (std::size_t c = 0; c < found.chains.size(); ++c) {
    const Span<const EdgePoint> chain = found.chains[c];
    const std::size_t count = chain.size() - (found.closed[c] ? 0 : 1);
    for (std::size_t i = 0; i < count; ++i) {
      if (chain[i].edge != none) ++segments[idx(chain[i].on.triangle)];
    }
    if (found.closed[c]) continue;
    for (const EdgePoint* tip : {&chain.front(), &chain.back()}) {
      EXPECT_NE(surface.edge_kinds[idx(tip->on.triangle)][idx(tip->edge)], EdgeKind::smooth);
    }
  }
  for (const int t : found.triangles) EXPECT_EQ(segments[idx(t)], 1);
}

TEST(Silhouettes, OfASphereAreOneClosedChainWithoutCusps) {
  const Surface sphere = shapes::sphere_surface(1, 4);
  const Camera camera = cameras::perspective(Vec3(3, 1, 2), Vec3::Zero());
  const LinearSilhouettes found = silhouettes_of(sphere, camera);
  check_silhouettes(sphere, found);
  ASSERT_EQ(found.chains.size(), 1U);
  EXPECT_TRUE(found.closed[0]);
  EXPECT_EQ(cusps_of(sphere, camera), 0);
}

// The true normal of a torus with R = 1 at (or beside) p.
Vec3 torus_normal(const Vec3& p) {
  const Vec3 core = Vec3(p.x(), p.y(), 0).normalized();
  return (p - core).normalized();
}

TEST(Silhouettes, ConvergeToTheContourOfATorus) {
  double previous = 1;
  for (const int n : {32, 64, 128}) {
    const Surface torus = shapes::torus_surface(1, 0.4, 2 * n, n);
    const Camera camera = cameras::perspective(Vec3(3, 1, 2), Vec3::Zero());
    const LinearSilhouettes found = silhouettes_of(torus, camera);
    double worst = 0;
    for (const EdgePoint& p : found.chains.values) {
      const Vec3 view = camera.to_eye(p.position).normalized();
      worst = std::max(worst, std::abs(torus_normal(p.position).dot(view)));
    }
    EXPECT_LT(worst, previous / 3);
    previous = worst;
  }
}

TEST(Silhouettes, RunWithTheFrontOnTheLeft) {
  const Surface sphere = shapes::sphere_surface(1, 4);
  const Camera camera = cameras::orthographic(Vec3(0, -1, 0), 2);
  const LinearSilhouettes found = silhouettes_of(sphere, camera);
  double twice_area = 0;
  const Span<const EdgePoint> chain = found.chains[0];
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const Vec2 a = camera.project(chain[i].position).xy;
    const Vec2 b = camera.project(chain[(i + 1) % chain.size()].position).xy;
    twice_area += a.x() * b.y() - a.y() * b.x();
  }
  EXPECT_LT(twice_area, 0) << "counter-clockwise as seen, clockwise with y down";
}

// r < b^2/a: no cusp on the inner loop; above: four (method, section 4). R = 1, orthographic, b =
// |axis . view|.
TEST(Silhouettes, TorusHasTheCuspsOfItsRegime) {
  const Surface torus = shapes::torus_surface(1, 0.4, 256, 128);
  const auto cusps = [&](double b) {
    const Vec3 direction(std::sqrt(1 - b * b), 0.013, b);
    const Camera camera = cameras::orthographic(direction, 2);
    const LinearSilhouettes found = silhouettes_of(torus, camera);
    check_silhouettes(torus, found);
    EXPECT_EQ(found.chains.size(), 2U);
    return cusps_of(torus, camera);
  };
  EXPECT_EQ(cusps(0.9), 0);
  EXPECT_EQ(cusps(0.75), 0);
  EXPECT_EQ(cusps(0.55), 4);
  EXPECT_EQ(cusps(0.3), 4);
}

CurveNetwork network_of(const Surface& surface, const Camera& camera) {
  Counts counts;
  return build_network(
      {surface, LimitSurface(surface), feature_edges(surface), IntersectionCurves()}, camera, {},
      counts);
}

// Each node is met by as many strand ends as its kind says, ties join an end to a start.
void check_network(const CurveNetwork& network) {
  ASSERT_EQ(network.points.size(), network.strands.size());
  std::vector<int> degree(network.nodes.size(), 0);
  for (std::size_t s = 0; s < network.strands.size(); ++s) {
    const Strand& strand = network.strands[s];
    ASSERT_GE(network.points[s].size(), 2U);
    EXPECT_GE(strand.left_layers, strand.right_layers);
    if (strand.closed()) continue;
    ++degree[idx(strand.start_node)];
    ++degree[idx(strand.end_node)];
    EXPECT_EQ(network.points[s].front().position, network.nodes[idx(strand.start_node)].position);
    EXPECT_EQ(network.points[s].back().position, network.nodes[idx(strand.end_node)].position);
  }
  for (std::size_t n = 0; n < network.nodes.size(); ++n) {
    const NodeKind kind = network.nodes[n].kind;
    EXPECT_TRUE(kind == NodeKind::cusp    ? degree[n] == 2
                : kind == NodeKind::joint ? degree[n] > 1
                                          : degree[n] == 1);
  }
  for (const Tie& tie : network.ties) {
    EXPECT_EQ(network.strands[idx(tie.a)].end_node, tie.node);
    EXPECT_EQ(network.strands[idx(tie.b)].start_node, tie.node);
  }
}

TEST(Network, AnOpenSheetEndsItsSilhouetteOnTheBoundary) {
  const auto wave = [](double x, double) { return 0.4 * std::sin(4 * x); };
  const Surface sheet = shapes::plain_surface(shapes::height_field(40, 40, wave));
  const CurveNetwork network = network_of(sheet, cameras::orthographic(Vec3(1, 0.1, 0.3), 2));
  check_network(network);
  int silhouettes = 0, boundaries = 0;
  for (const Strand& strand : network.strands) {
    silhouettes += strand.kind == Kind::silhouette;
    boundaries += strand.kind == Kind::boundary;
    if (strand.kind == Kind::silhouette) {
      EXPECT_EQ(network.nodes[idx(strand.start_node)].kind, NodeKind::joint);
    }
  }
  EXPECT_GT(silhouettes, 0);
  EXPECT_GT(boundaries, 2);
}

TEST(Network, AFrontFacingDiscHidesOnItsInside) {
  const Surface disc = shapes::plain_surface(shapes::plane(4, 4));
  const CurveNetwork network = network_of(disc, cameras::orthographic(Vec3(0.1, 0.2, 1), 2));
  check_network(network);
  ASSERT_EQ(network.strands.size(), 1U);
  EXPECT_TRUE(network.strands[0].closed());
  EXPECT_EQ(network.strands[0].left_layers, 1);
  EXPECT_EQ(network.strands[0].right_layers, 0);
}

TEST(Network, PolygonObjectsHaveTheirOwnEdgesAsSilhouettes) {
  Surface cube = shapes::plain_surface(shapes::cube());
  cube.object_is_smooth = {0};
  const CurveNetwork network = network_of(cube, cameras::perspective(Vec3(4, 5, 6), Vec3::Zero()));
  check_network(network);
  EXPECT_EQ(network.strands.size(), 6U) << "the outline of a cube seen at a corner";
}

TEST(Network, IsCutAtTheNearPlane) {
  const Surface torus = shapes::torus_surface(1, 0.4, 64, 32);
  const Camera camera = cameras::perspective(Vec3(1.2, -0.5, 0.2), Vec3(0, 1, 0), 0.05);
  const CurveNetwork network = network_of(torus, camera);
  check_network(network);
  for (const CurvePoint& p : network.points.values) EXPECT_GE(camera.near_distance(p.position), 0);
}

}  // namespace
}  // namespace illustrate
