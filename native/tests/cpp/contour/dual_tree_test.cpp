// The dual search against the scan: the same silhouettes, always, for a small share of the work.
#include <gtest/gtest.h>

#include <random>
#include <set>

#include "contour/network/network.h"
#include "contour/polygon_silhouettes.h"
#include "contour/silhouettes.h"
#include "core/radix_sort.h"
#include "core/sort_unique.h"
#include "pipeline/prepare.h"
#include "tests/cpp/cameras.h"
#include "tests/cpp/shapes.h"

namespace illustrate {
namespace {

using Random = std::mt19937;

Vec3 random_vector(Random& random) {
  std::uniform_real_distribution<double> number(-1, 1);
  return {number(random), number(random), number(random)};
}

std::vector<int> triangles_of(const std::vector<FeatureEdge>& edges) {
  std::vector<int> numbers;
  for (const FeatureEdge& edge : edges) {
    for (const EdgeSide& side : edge.sides) {
      numbers.push_back(side.triangle);
      numbers.push_back(side.corner);
    }
  }
  return numbers;
}

void expect_same(const CurveNetwork& a, const CurveNetwork& b) {
  ASSERT_EQ(a.points.offsets, b.points.offsets);
  ASSERT_EQ(a.nodes.size(), b.nodes.size());
  ASSERT_EQ(a.ties.size(), b.ties.size());
  for (std::size_t i = 0; i < a.points.values.size(); ++i) {
    ASSERT_EQ(a.points.values[i].position, b.points.values[i].position);
    ASSERT_EQ(a.points.values[i].on.triangle, b.points.values[i].on.triangle);
  }
}

// Returns how many triangles and edges carry silhouettes.
std::size_t expect_same_silhouettes(const Surface& surface, const DualSurface& dual,
                                    const Camera& camera) {
  const ContourFunctions functions(surface, camera);
  const SilhouetteSearch found = find_silhouette_triangles(surface, functions, &dual);
  const SilhouetteSearch scanned = find_silhouette_triangles(surface, functions, nullptr);
  EXPECT_EQ(found.triangles, scanned.triangles);
  EXPECT_LE(found.visited, scanned.visited);
  const PolygonSilhouettes edges = polygon_silhouettes(surface, camera, &dual);
  const PolygonSilhouettes all = polygon_silhouettes(surface, camera, nullptr);
  EXPECT_EQ(triangles_of(edges.edges), triangles_of(all.edges));
  EXPECT_LE(edges.edges_visited, all.edges_visited);
  const std::vector<FeatureEdge> features = feature_edges(surface);
  Counts counts;
  const LimitSurface limit(surface);
  const IntersectionCurves none_found;
  expect_same(build_network({surface, limit, features, none_found, &dual}, camera, {}, counts),
              build_network({surface, limit, features, none_found}, camera, {}, counts));
  return found.triangles.size() + edges.edges.size();
}

struct Ball {
  Vec3 centre = Vec3::Zero();
  double radius = 1;
};

Ball ball_of(const Surface& surface) {
  Eigen::AlignedBox3d box;
  for (const Vec3& p : surface.positions) box.extend(p);
  return {box.center(), box.diagonal().norm() / 2};
}

// From all sides and distances, from points of the surface, in the planes of triangles, and along
// the axes; each as a point and as a direction.
std::vector<Camera> cameras_round(const Surface& surface, int count) {
  Random random(7);
  const Ball ball = ball_of(surface);
  std::vector<Vec3> eyes;
  for (const double distance : {0.3, 1.01, 3.0, 100.0}) {
    for (int i = 0; i < count; ++i) {
      eyes.push_back(ball.centre + distance * ball.radius * random_vector(random));
    }
  }
  for (int axis = 0; axis < 3; ++axis) {
    eyes.push_back(ball.centre + 2 * ball.radius * Vec3::Unit(axis));
  }
  for (int i = 0; i < count; ++i) {
    const auto& t = surface.triangles[random() % surface.triangles.size()];
    const Vec3 &a = surface.positions[idx(t[0])], &b = surface.positions[idx(t[1])];
    eyes.insert(eyes.end(), {a, (a + b) / 2, a + 10 * (b - a)});
  }
  std::vector<Camera> cameras;
  for (const Vec3& eye : eyes) {
    if (eye == ball.centre) continue;
    const double near = 1e-3 * ball.radius;
    cameras.push_back(cameras::perspective(eye, ball.centre, near));
    cameras.push_back(cameras::orthographic(eye - ball.centre, ball.radius));
  }
  return cameras;
}

std::size_t expect_search_is_scan(const Surface& surface, int count = 4) {
  const DualSurface dual(surface);
  std::size_t silhouettes = 0;
  for (const Camera& camera : cameras_round(surface, count)) {
    silhouettes += expect_same_silhouettes(surface, dual, camera);
  }
  return silhouettes;
}

Surface surface_of(const std::vector<PolygonMesh>& meshes, Scheme scheme, int level) {
  PrepareOptions options;
  options.field = false;
  options.surface.scheme = scheme;
  options.surface.level = level;
  std::vector<MeshPointer> pointers;
  for (const PolygonMesh& mesh : meshes) pointers.push_back(std::make_shared<PolygonMesh>(mesh));
  return prepare(pointers, options)->surface();
}

PolygonMesh creased_cube() {
  PolygonMesh mesh = shapes::cube();
  mesh.edge_vertices = {{0, 1}, {1, 3}, {3, 2}, {2, 0}};
  mesh.edge_sharpness = {10, 10, 2, 0.5};
  return mesh;
}

PolygonMesh scaled(PolygonMesh mesh, double scale) {
  for (Vec3& p : mesh.positions) p *= scale;
  return mesh;
}

TEST(DualSearch, FindsWhatTheScanFinds) {
  const std::vector<PolygonMesh> meshes{shapes::torus_mesh(1, 0.4, 16, 8),
                                        shapes::klein_mesh(20, 12),
                                        shapes::moebius_mesh(20, 4),
                                        shapes::cube(),
                                        creased_cube(),
                                        shapes::icosphere_mesh(1, 2)};
  for (const PolygonMesh& mesh : meshes) {
    for (const Scheme scheme : {Scheme::catmull_clark, Scheme::loop, Scheme::polygons}) {
      SCOPED_TRACE(testing::Message()
                   << mesh.face_sizes.size() << " faces, scheme " << static_cast<int>(scheme));
      EXPECT_GT(expect_search_is_scan(surface_of({mesh}, scheme, 2)), 0U);
    }
  }
}

TEST(DualSearch, FindsItAtAnyPlaceAndScale) {
  const PolygonMesh torus = shapes::torus_mesh(1, 0.4, 16, 8);
  for (const Scheme scheme : {Scheme::catmull_clark, Scheme::polygons}) {
    for (const double scale : {1e-9, 1e-3, 1e6, 1e12}) {
      EXPECT_GT(expect_search_is_scan(surface_of({scaled(torus, scale)}, scheme, 1)), 0U);
    }
    const Vec3 far(1e6, -3e6, 2e6);
    EXPECT_GT(expect_search_is_scan(surface_of({shapes::moved(torus, far)}, scheme, 1)), 0U);
  }
}

TEST(DualSearch, KeepsObjectsApart) {
  PolygonMesh polygons = shapes::icosphere_mesh(0.2, 2);
  polygons.scheme = Scheme::polygons;
  const Surface surface = surface_of({shapes::torus_mesh(1, 0.4, 16, 8),
                                      {},
                                      shapes::moved(polygons, {1000, 0, 0}),
                                      shapes::moved(shapes::icosphere_mesh(2, 1), {0, 50, 0})},
                                     Scheme::automatic, 2);
  EXPECT_GT(expect_search_is_scan(surface), 0U);
}

TEST(DualSearch, CountsAPlaneSeenEdgeOnAsFront) {
  for (const Scheme scheme : {Scheme::catmull_clark, Scheme::polygons}) {
    const Surface plane = surface_of({shapes::plane(6, 6)}, scheme, 1);
    const DualSurface dual(plane);
    const std::vector<Camera> edge_on{cameras::perspective(Vec3(3, 1, 0), Vec3::Zero()),
                                      cameras::perspective(Vec3(0.5, 0.5, 0), Vec3::Zero()),
                                      cameras::orthographic(Vec3(1, 2, 0), 2)};
    for (const Camera& camera : edge_on) {
      EXPECT_EQ(expect_same_silhouettes(plane, dual, camera), 0U);
    }
    expect_search_is_scan(plane);
  }
}

TEST(DualSearch, HasNothingToFindInNothing) {
  const Surface nothing = surface_of({{}}, Scheme::automatic, 0);
  const DualSurface dual(nothing);
  const Camera camera = cameras::perspective(Vec3(3, 1, 2), Vec3::Zero());
  EXPECT_TRUE(dual.triangles(camera).empty());
  EXPECT_TRUE(dual.edges(camera).empty());
}

// Four times the triangles have twice the silhouette.
TEST(DualSearch, VisitsInProportionToTheSilhouette) {
  const Camera camera = cameras::perspective(Vec3(3, 1, 2), Vec3::Zero());
  double previous = 1e9;
  for (const int n : {64, 128, 256}) {
    const Surface torus = shapes::torus_surface(1, 0.4, 2 * n, n);
    const DualSurface dual(torus);
    const SilhouetteSearch found =
        find_silhouette_triangles(torus, ContourFunctions(torus, camera), &dual);
    const auto visited = static_cast<double>(found.visited);
    EXPECT_LE(visited, 2.5 * static_cast<double>(found.triangles.size()));
    EXPECT_LT(visited, 2.4 * previous);
    EXPECT_EQ(dual.always_count(), 0U);
    previous = visited;
  }
}

TEST(DualSearch, VisitsFewEdgesOfPolygons) {
  const Surface torus = surface_of({shapes::torus_mesh(1, 0.4, 200, 100)}, Scheme::polygons, 0);
  const DualSurface dual(torus);
  for (const Camera& camera : cameras_round(torus, 2)) {
    const PolygonSilhouettes found = polygon_silhouettes(torus, camera, &dual);
    EXPECT_LE(found.edges_visited, 4 * static_cast<int>(found.edges.size()) + 40);
  }
}

// Planes at right angles have no face of the hypercube in common; those of a cube pressed flat have
// none even when they are cut, and are looked at in every view.
TEST(DualSearch, CutsWhatNoFaceHolds) {
  EXPECT_EQ(DualSurface(surface_of({shapes::cube()}, Scheme::polygons, 0)).always_count(), 0U);
  Surface folded = shapes::plain_surface(shapes::cube());
  folded.object_is_smooth = {0};
  for (Vec3& p : folded.positions) p.z() = 0;
  const DualSurface dual(folded);
  EXPECT_GT(dual.always_count(), 0U);
  for (const Camera& camera : cameras_round(folded, 4)) {
    expect_same_silhouettes(folded, dual, camera);
  }
}

// Where the sheets of a surface that cannot be oriented meet, unsigned duals would be opposite.
TEST(DualSearch, TurnsTheDualsOfTheOtherSheet) {
  const Surface klein = surface_of({shapes::klein_mesh(20, 12)}, Scheme::catmull_clark, 2);
  EXPECT_TRUE(std::any_of(klein.flips.begin(), klein.flips.end(),
                          [](std::uint8_t flips) { return flips % 7 != 0; }));
  EXPECT_EQ(DualSurface(klein).always_count(), 0U);
}

TEST(DualSearch, IsTheSameForAnyNumberOfThreads) {
  const Surface torus = shapes::torus_surface(1, 0.4, 128, 64);
  const DualSurface one(torus, 1), four(torus, 4);
  for (const Camera& camera : cameras_round(torus, 4)) {
    EXPECT_EQ(one.triangles(camera), four.triangles(camera));
  }
}

Vec4 random_dual(Random& random) {
  Vec4 dual;
  dual << random_vector(random).normalized(), random_vector(random).x();
  return dual;
}

// Small, middling and large triangles anywhere in the dual space.
std::vector<std::array<Vec4, 3>> random_items(Random& random, int count) {
  std::vector<std::array<Vec4, 3>> items;
  for (int i = 0; i < count; ++i) {
    const Vec4 a = random_dual(random);
    const double size = std::array{1e-6, 0.05, 0.5}[random() % 3];
    items.push_back({a, a + size * random_dual(random), a + size * random_dual(random)});
  }
  return items;
}

TEST(DualTree, FindsWhateverThePlaneCuts) {
  Random random(3);
  const auto corners = random_items(random, 5000);
  std::vector<DualItem> items;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (const auto item = dual_item(static_cast<int>(i), corners[i])) items.push_back(*item);
  }
  EXPECT_GT(items.size(), 4000U);
  const DualTree tree(items, {}, 1);
  for (int view = 0; view < 50; ++view) {
    const Vec4 viewpoint = random_dual(random) * (view + 1);
    std::vector<int> found;
    tree.find(viewpoint, 1e-9, found);
    std::size_t cut = 0;
    for (const DualItem& item : items) {
      int fronts = 0;
      for (const Vec4& corner : corners[idx(item.id)]) fronts += viewpoint.dot(corner) >= 0;
      if (fronts % 3 == 0) continue;
      ++cut;
      EXPECT_EQ(std::count(found.begin(), found.end(), item.id), 1);
    }
    EXPECT_GT(cut, 0U);
    EXPECT_LT(found.size(), items.size() / 2);
  }
}

TEST(DualTree, FindsWhatLiesWithinTheMargin) {
  const Vec4 n(0, 0, 1, -0.5);
  const auto item = dual_item(5, {n, n, n});
  ASSERT_TRUE(item.has_value());
  const DualTree tree({*item}, {9}, 1);
  const auto found = [&](double height, double margin) {
    std::vector<int> ids;
    tree.find(Vec4(0.3, 0.2, 0.5 + height, 1), margin, ids);
    return ids;
  };
  EXPECT_EQ(found(1e-9, 1e-8), (std::vector<int>{9, 5}));
  EXPECT_EQ(found(-1e-9, 1e-8), (std::vector<int>{9, 5}));
  EXPECT_EQ(found(1e-3, 1e-8), std::vector<int>{9});
  EXPECT_EQ(found(std::nan(""), 1e-8), (std::vector<int>{9, 5})) << "when in doubt, look";
}

TEST(DualTree, HasNoPlaceForOppositeOrBrokenCorners) {
  const Vec4 up(0, 0, 1, 0), zero = Vec4::Zero(), broken(0, 0, std::nan(""), 1);
  EXPECT_TRUE(dual_item(0, {up, up, up}));
  EXPECT_FALSE(dual_item(0, {up, -up, up}));
  EXPECT_FALSE(dual_item(0, {up, up, zero}));
  EXPECT_FALSE(dual_item(0, {up, broken, up}));
}

TEST(SortUnique, KeepsOneOfEachInOrder) {
  Random random(2);
  std::vector<int> values{0, 63, 64, 1999, 1999};
  for (int i = 0; i < 300; ++i) values.push_back(static_cast<int>(random() % 2000));
  const std::set<int> expected(values.begin(), values.end());
  sort_unique(values, 2000);
  EXPECT_EQ(values, std::vector<int>(expected.begin(), expected.end()));
}

TEST(RadixSort, SortsAndKeepsTheOrderOfEqualKeys) {
  Random random(1);
  std::vector<std::pair<std::uint64_t, int>> values;
  for (int i = 0; i < 5000; ++i) values.emplace_back(std::uint64_t{random() % 1000} << 20, i);
  auto expected = values;
  std::sort(expected.begin(), expected.end());
  radix_sort(values, 31, [](const auto& value) { return value.first; });
  EXPECT_EQ(values, expected);
}

}  // namespace
}  // namespace illustrate
