// Silhouettes of rough surfaces, such as scans are: their limit surface has folds smaller than
// their triangles.
#include <gtest/gtest.h>

#include "cameras.h"
#include "check_graph.h"
#include "contour/network.h"
#include "surface_checks.h"
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

}  // namespace
}  // namespace illustrate
