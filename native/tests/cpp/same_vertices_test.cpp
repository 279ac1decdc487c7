#include "surface/same_vertices.h"

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

TEST(SameVertices, WhicheverDiagonalSplitsAQuad) {
  const PolygonMesh mesh = shapes::torus_mesh(1, 0.4, 12, 8);
  const Surface one = of_quads(mesh);
  Surface other = of_quads(turned_quads(mesh));
  for (Vec3& p : other.positions) p *= 2;
  EXPECT_NE(one.triangles, other.triangles);
  EXPECT_TRUE(has_same_vertices(one, one));
  EXPECT_TRUE(has_same_vertices(one, other));
}

TEST(SameVertices, NotOfOtherFacesOrObjects) {
  const PolygonMesh mesh = shapes::torus_mesh(1, 0.4, 12, 8);
  const Surface one = of_quads(mesh);
  PolygonMesh crossed = turned_quads(mesh);
  std::swap(crossed.corner_vertices[5], crossed.corner_vertices[6]);
  EXPECT_FALSE(has_same_vertices(one, of_quads(crossed)));
  Surface other = of_quads(turned_quads(mesh));
  other.objects.back() = 1;
  EXPECT_FALSE(has_same_vertices(one, other));
  other = of_quads(turned_quads(mesh));
  other.triangle_faces.clear();
  EXPECT_FALSE(has_same_vertices(one, other)) << "who knows what is one face";
  EXPECT_FALSE(has_same_vertices(one, of_quads(shapes::torus_mesh(1, 0.4, 8, 12))));
}

}  // namespace
}  // namespace illustrate
