#include "pipeline/rough_lines.h"

#include <gtest/gtest.h>

#include "pipeline/draw.h"
#include "tests/cpp/blocks.h"
#include "tests/cpp/cameras.h"
#include "tests/cpp/shapes.h"

namespace illustrate {
namespace {

std::shared_ptr<const Prepared> prepared_of(PolygonMesh mesh, Scheme scheme, int level) {
  PrepareOptions options;
  options.field = false;
  options.surface.scheme = scheme;
  options.surface.level = level;
  return prepare({std::make_shared<PolygonMesh>(std::move(mesh))}, options);
}

TEST(RoughLines, OfASphereAreTheCircleOfTangents) {
  const auto sphere = prepared_of(shapes::uv_sphere_mesh(1, 48, 24), Scheme::catmull_clark, 1);
  const auto lines = rough_silhouettes(*sphere, cameras::perspective({0, 0, 3}, Vec3::Zero()));
  ASSERT_GT(lines.size(), 40U);
  const double radius = sphere->surface().positions[0].norm();  // of the limit
  for (const Segment& segment : lines) {
    for (const auto& end : segment) EXPECT_NEAR(end.z(), radius * radius / 3, 0.01);
  }
}

TEST(RoughLines, AreWhereTheExactSearchFindsThem) {
  const auto torus = prepared_of(shapes::torus_mesh(1, 0.4, 24, 16), Scheme::catmull_clark, 1);
  const Camera camera = cameras::perspective({3, -4, 2}, Vec3::Zero());
  const auto triangles = silhouette_triangles(*torus, camera, true);
  const auto lines = rough_silhouettes(*torus, camera);
  ASSERT_EQ(lines.size(), triangles.size());
  const Surface& surface = torus->surface();
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const Triangle& corners = surface.triangles[idx(triangles[i])];
    const double size =
        (surface.positions[idx(corners[0])] - surface.positions[idx(corners[1])]).norm();
    for (const auto& end : lines[i]) {
      EXPECT_LT((end.cast<double>() - surface.positions[idx(corners[0])]).norm(), 3 * size);
    }
  }
}

TEST(RoughLines, OfFacesAreEdgesBetweenFrontAndBack) {
  PolygonMesh cube = shapes::cube();
  cube.crease_angle_deg = 180;
  const auto prepared = prepared_of(cube, Scheme::polygons, 0);
  EXPECT_EQ(rough_silhouettes(*prepared, cameras::perspective({0.1, 0.2, 5}, {0, 0, 0})).size(),
            4U);
  EXPECT_EQ(rough_silhouettes(*prepared, cameras::perspective({5, 4, 3}, {0, 0, 0})).size(), 6U);
}

TEST(RoughLines, CreasesAndIntersectionsAreInEveryView) {
  PolygonMesh cube = shapes::cube();
  cube.crease_angle_deg = 30;
  const std::size_t creases = rough_features(*prepared_of(cube, Scheme::polygons, 0)).size();
  EXPECT_EQ(creases % 12, 0U);
  EXPECT_GT(creases, 0U);
  PolygonMesh two = shapes::joined(cube, shapes::moved(cube, {0.5, 0.5, 0.5}));
  EXPECT_GT(rough_features(*prepared_of(two, Scheme::polygons, 0)).size(), 2 * creases);
}

// Of all rough features in the plane z = 0; creases are there once for each side.
double length_in_plane(const std::vector<PolygonMesh>& meshes) {
  float length = 0;
  for (const Segment& s : rough_features(*blocks::prepared(meshes))) {
    if (std::abs(s[0].z()) + std::abs(s[1].z()) < 1e-5F) length += (s[1] - s[0]).norm();
  }
  return static_cast<double>(length) / 2;
}

// A block that stands over the rim of a slab, their tops in one plane.
TEST(RoughLines, HaveNoneWithinAFaceOfAnotherPart) {
  const PolygonMesh slab = blocks::block(Vec3(-2, -2, -1), Vec3(2, 2, 0));
  const PolygonMesh within = blocks::block(Vec3(-0.5, -0.5, -0.7), Vec3(0.5, 0.5, 0));
  const PolygonMesh over = blocks::block(Vec3(1.2, -0.5, -0.7), Vec3(2.5, 0.5, 0));
  EXPECT_NEAR(length_in_plane({slab}), 16, 1e-4);
  EXPECT_NEAR(length_in_plane({slab, within}), 16, 1e-4);
  for (const auto& meshes : {std::vector<PolygonMesh>{slab, over}, {over, slab}})
    EXPECT_NEAR(length_in_plane(meshes), 16 - 1 + 0.5 + 0.5 + 1, 1e-3);
}

}  // namespace
}  // namespace illustrate
