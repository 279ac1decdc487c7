#include <gtest/gtest.h>

#include <cstring>

#include "core/errors.h"
#include "surface/jets/curvature.h"
#include "tests/cpp/surface_checks.h"

namespace illustrate {
namespace {

using namespace surface_checks;

TEST(Levels, AutomaticSchemeFollowsTheFaces) {
  Counts report;
  EXPECT_EQ(refined({shapes::cube()}, at_level(1), report).triangles.size(), 48U);
  EXPECT_EQ(refined({shapes::icosahedron()}, at_level(1), report).triangles.size(), 80U);
}

TEST(Levels, FirstWhoseMedianEdgeIsShortEnough) {
  SurfaceOptions options;
  for (const auto& [length, level] :
       std::vector<std::pair<double, int>>{{3, 0}, {2, 0}, {1.9, 1}, {.3, 3}}) {
    options.edge_length = length;  // the cube's edges are 2 long
    Counts report;
    refined({shapes::cube()}, options, report);
    EXPECT_EQ(report["level_0"], level);
  }
  Counts report;
  refined({shapes::cube()}, SurfaceOptions{}, report);
  EXPECT_EQ(report["level_0"], 7);  // 2 / 2^9 would be needed: the highest automatic level is 7
  PolygonMesh own = shapes::cube();
  own.edge_length = .6;
  PolygonMesh fixed = shapes::cube();
  fixed.level = 3;
  refined({own, fixed}, SurfaceOptions{}, report);
  EXPECT_EQ(report["level_0"], 2);
  EXPECT_EQ(report["level_1"], 3);
}

TEST(Levels, ShortestEdgesGiveUpFirst) {
  SurfaceOptions options;
  options.edge_length = .05;
  PolygonMesh small = shapes::cube();
  for (Vec3& p : small.positions) p = p / 4 + Vec3(5, 0, 0);
  Counts report;
  refined({shapes::cube(), small}, options, report);
  EXPECT_EQ(report["level_0"], 6);
  EXPECT_EQ(report["level_1"], 4);
  options.triangle_budget = 12 * (1024 + 64);
  refined({shapes::cube(), small}, options, report);
  EXPECT_EQ(report["level_0"], 5);
  EXPECT_EQ(report["level_1"], 3);
  options.triangle_budget = 0;
  refined({shapes::cube(), small}, options, report);
  EXPECT_EQ(report["level_0"] + report["level_1"], 0);
}

TEST(Levels, WrongOptionsAreNamed) {
  const auto message = [](const SurfaceOptions& options) {
    Counts report;
    try {
      refine({sound(shapes::cube())}, options, report);
    } catch (const InvalidInput& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  SurfaceOptions options;
  options.edge_length = -1;
  EXPECT_NE(message(options).find("edge_length"), std::string::npos);
  options = {};
  options.triangle_budget = -1;
  EXPECT_NE(message(options).find("triangle_budget"), std::string::npos);
  options = {};
  options.threads = -1;
  EXPECT_NE(message(options).find("threads"), std::string::npos);
  EXPECT_NE(message(at_level(-2)).find("level"), std::string::npos);
  EXPECT_NE(message(at_level(14)).find("level"), std::string::npos);
  EXPECT_NE(message(at_level(2000000000)).find("level"), std::string::npos);
}

bool same_bits(const Points& a, const Points& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Vec3)) == 0;
}

TEST(Refine, SameBytesForAnyNumberOfThreads) {
  SurfaceOptions one = at_level(3), two = at_level(3);
  one.threads = 1;
  two.threads = 2;
  const Surface a = refined(creased(shapes::torus_mesh(2, 1, 16, 8), 1.5), one);
  const Surface b = refined(creased(shapes::torus_mesh(2, 1, 16, 8), 1.5), two);
  EXPECT_TRUE(same_bits(a.positions, b.positions));
  EXPECT_TRUE(same_bits(a.normals, b.normals));
  EXPECT_TRUE(a.curvature == b.curvature);
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_EQ(a.neighbours, b.neighbours);
  EXPECT_EQ(a.edge_kinds, b.edge_kinds);
  EXPECT_EQ(a.places, b.places);
  EXPECT_TRUE(jet_curvature(a, {3, 1}) == jet_curvature(b, {3, 2}));
}

TEST(Refine, CanBeCancelledAnywhere) {
  const std::vector<SoundMesh> meshes{sound(shapes::cube()), sound(shapes::icosahedron())};
  int reports = 0;
  Counts report;
  const auto count = [&](double, const std::string&) { return ++reports > 0; };
  const Surface surface = refine(meshes, at_level(3), report, Progress(count, "surface"));
  jet_curvature(surface, {}, Progress(count, "curvature"));
  ASSERT_GT(reports, 10);
  for (int stop = 1; stop <= reports; ++stop) {
    int left = stop;
    const Progress progress([&](double, const std::string&) { return --left > 0; }, "surface");
    EXPECT_THROW(
        {
          const Surface part = refine(meshes, at_level(3), report, progress);
          jet_curvature(part, {}, progress);
        },
        Cancelled);
  }
}

TEST(Refine, VertexOfVeryManyFaces) {
  PolygonMesh cone;
  const int n = 70000;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * pi * i / n;
    cone.positions.emplace_back(std::cos(angle), std::sin(angle), 0);
    shapes::add_face(cone, {n, i, (i + 1) % n});
  }
  cone.positions.emplace_back(0, 0, 1);
  Counts report;
  EXPECT_EQ(refined({cone}, at_level(0), report).triangles.size(), static_cast<std::size_t>(n));
  EXPECT_EQ(report["not_subdivided"], 0);

  SoundMesh whole;  // as no sanitized mesh is
  whole.positions = cone.positions;
  whole.face_sizes = cone.face_sizes;
  whole.corner_vertices = cone.corner_vertices;
  for (int v = 0; v <= n; ++v) whole.source_vertices.push_back(v);
  const Surface surface = refine({whole}, at_level(1), report);
  check_surface(surface);
  EXPECT_EQ(report["not_subdivided"], 1);
  EXPECT_EQ(surface.triangles.size(), static_cast<std::size_t>(n));
  EXPECT_FALSE(surface.object_is_smooth[0]);
}

TEST(Refine, NothingGivesNothing) {
  Counts report;
  const Surface surface =
      refined({PolygonMesh{}, shapes::cube(), PolygonMesh{}}, at_level(1), report);
  EXPECT_EQ(surface.object_is_smooth.size(), 3U);
  EXPECT_EQ(surface.objects.front(), 1);
  EXPECT_TRUE(refine({}, at_level(1), report).positions.empty());
}

TEST(Refine, PlacesOfSeveralMeshesFollowEachOther) {
  Counts report;
  const Surface surface =
      refined({shapes::cube(), shapes::icosahedron(), shapes::cube()}, at_level(2), report);
  EXPECT_EQ(*std::max_element(surface.base_faces.begin(), surface.base_faces.end()),
            6 + 20 + 6 - 1);
  EXPECT_EQ(report["triangles"], static_cast<std::int64_t>(surface.triangles.size()));
  EXPECT_EQ(report["vertices"], static_cast<std::int64_t>(surface.positions.size()));
}

TEST(Refine, DegenerateFacesHaveNormals) {
  // All points on a line; all points in one.
  const PolygonMesh line =
      shapes::polygon_mesh({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, {{0, 1, 2, 3}});
  PolygonMesh point = shapes::torus_mesh(0, 0, 6, 6);
  for (const PolygonMesh& mesh : {line, point}) {
    for (const Scheme scheme : {Scheme::catmull_clark, Scheme::loop, Scheme::polygons}) {
      refined(mesh, at_level(1, scheme));
    }
  }
  PolygonMesh huge = shapes::cube();
  for (Vec3& p : huge.positions) p *= 1e120;
  refined(huge, at_level(1));
  for (Vec3& p : huge.positions) p *= 1e-240;
  refined(huge, at_level(1));
}

TEST(SurfacePoint, IsInterpolatedOnTheTrianglesOwnSheet) {
  const Surface klein = refined(shapes::klein_mesh(24, 12), at_level(1));
  for (int t = 0; t < static_cast<int>(klein.triangles.size()); ++t) {
    const SurfacePoint middle{t, 1. / 3, 1. / 3};
    EXPECT_GT(normal_at(klein, middle).dot(area_vector(klein, t)), 0);
    Vec3 sum = Vec3::Zero();
    for (const int v : klein.triangles[index(t)]) sum += klein.positions[index(v)] / 3;
    EXPECT_LT((position_at(klein, middle) - sum).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace illustrate
