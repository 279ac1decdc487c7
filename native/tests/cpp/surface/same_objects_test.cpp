#include "surface/same_objects.h"

#include <gtest/gtest.h>

#include "tests/cpp/shapes.h"

namespace illustrate {
namespace {

Surface of_quads(PolygonMesh mesh) {
  Surface surface = shapes::plain_surface(mesh);
  for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t) {
    surface.triangle_faces.push_back(t / 2);
  }
  return surface;
}

// Every second quad begins at its next corner, so that its other diagonal splits it.
PolygonMesh turned_quads(PolygonMesh mesh) {
  for (std::size_t c = 0; c < mesh.corner_vertices.size(); c += 8) {
    const auto first = mesh.corner_vertices.begin() + static_cast<std::ptrdiff_t>(c);
    std::rotate(first, first + 1, first + 4);
  }
  return mesh;
}

TEST(SameObjects, WhicheverDiagonalSplitsAQuad) {
  const PolygonMesh mesh = shapes::torus_mesh(1, 0.4, 12, 8);
  const Surface one = of_quads(mesh);
  Surface other = of_quads(turned_quads(mesh));
  for (Vec3& p : other.positions) p *= 2;
  EXPECT_NE(one.triangles, other.triangles);
  EXPECT_TRUE(SameObjects(one, one).any());
  EXPECT_TRUE(SameObjects(one, other).any());
}

TEST(SameObjects, NotOfOtherFacesOrObjects) {
  const PolygonMesh mesh = shapes::torus_mesh(1, 0.4, 12, 8);
  const Surface one = of_quads(mesh);
  PolygonMesh crossed = turned_quads(mesh);
  std::swap(crossed.corner_vertices[5], crossed.corner_vertices[6]);
  EXPECT_FALSE(SameObjects(one, of_quads(crossed)).any());
  Surface two = one, other = of_quads(turned_quads(mesh));
  for (Surface* surface : {&two, &other}) {
    surface->object_is_smooth.push_back(1);
    surface->controls.push_back({std::make_shared<const ControlMesh>(), 0, {}});
  }
  other.objects.back() = 1;
  EXPECT_FALSE(SameObjects(two, other).any());
  other = of_quads(turned_quads(mesh));
  other.triangle_faces.clear();
  EXPECT_FALSE(SameObjects(one, other).any()) << "who knows what is one face";
  EXPECT_FALSE(SameObjects(one, of_quads(shapes::torus_mesh(1, 0.4, 8, 12))).any());
}

TEST(SameObjects, PointsStayWhereTheyAreOnOtherDiagonals) {
  PolygonMesh mesh = shapes::plane(3, 2);
  const Surface one = of_quads(mesh);
  Surface other = of_quads(turned_quads(mesh));
  for (Vec3& p : other.positions) p += Vec3(0, 0, 5);
  ASSERT_NE(one.triangles, other.triangles);
  const SameObjects same(one, other);
  for (int t = 0; t < static_cast<int>(one.triangles.size()); ++t) {
    const SurfacePoint on{t, 0.2, 0.1};
    const Vec3 moved = position_at(one, on) + Vec3(0, 0, 5);
    EXPECT_LT((same.position(on) - moved).norm(), 1e-12);
    EXPECT_LT((position_at(other, same.point(on)) - moved).norm(), 1e-12) << t;
  }
}

// One object after another that has changed: its numbers are others.
TEST(SameObjects, AreFoundBesideOthers) {
  const Surface ring = of_quads(shapes::torus_mesh(1, 0.4, 12, 8));
  const Surface last = shapes::joined(of_quads(shapes::plane(3, 2)), ring);
  const Surface now = shapes::joined(of_quads(shapes::plane(4, 2)), ring);
  const SameObjects same(last, now);
  EXPECT_TRUE(same.any());
  EXPECT_EQ(same.last_vertex(0), none);
  EXPECT_EQ(same.last_triangle(0), none);
  EXPECT_FALSE(same.has({0, 0, 0}));
  const auto v = static_cast<int>(now.positions.size() - last.positions.size());
  const auto t = static_cast<int>(now.triangles.size() - last.triangles.size());
  ASSERT_GT(v, 0);
  EXPECT_EQ(same.last_vertex(now.positions.size() - 1), int(last.positions.size()) - 1);
  EXPECT_EQ(same.last_triangle(now.triangles.size() - 1), int(last.triangles.size()) - 1);
  const int place = static_cast<int>(last.triangles.size()) - 5;
  ASSERT_TRUE(same.has({place, 0, 0}));
  EXPECT_EQ(same.point({place, 0.2, 0.3}).triangle, place + t);
  EXPECT_EQ(same.position({place, 0.2, 0.3}), position_at(last, {place, 0.2, 0.3}));
}

}  // namespace
}  // namespace illustrate
