// Cages keep together where their parts touch, as a Subdivision modifier keeps them.
#include "mesh/held_places.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/cpp/shapes.h"

namespace illustrate {
namespace {

std::int64_t held_vertices(const SoundMesh& mesh) {
  return std::count(mesh.vertex_sharpness.begin(), mesh.vertex_sharpness.end(), infinitely_sharp);
}

SoundMesh sound(const PolygonMesh& mesh) {
  Counts report;
  return sanitize(mesh, report);
}

// Two cubes that have the vertices in common which lie at the same places.
PolygonMesh touching_cubes(const Vec3& offset) {
  PolygonMesh mesh = shapes::cube();
  const Points first = mesh.positions;
  std::vector<int> numbers;
  for (const Vec3& p : first) {
    const Vec3 place = p + offset;
    const auto same = [&](const Vec3& q) { return (place - q).norm() < 1e-9; };
    const auto found = std::find_if(first.begin(), first.end(), same);
    numbers.push_back(
        static_cast<int>(found == first.end() ? mesh.positions.size() : found - first.begin()));
    if (found == first.end()) mesh.positions.push_back(place);
  }
  for (const int v : shapes::cube().corner_vertices) mesh.corner_vertices.push_back(numbers[v]);
  for (const int size : shapes::cube().face_sizes) mesh.face_sizes.push_back(size);
  return mesh;
}

TEST(HeldPlaces, AreCommonEdgesOfSolids) {
  const SoundMesh mesh = sound(touching_cubes({2, 2, 0}));
  EXPECT_EQ(mesh.edge_sharpness, (std::vector<double>{infinitely_sharp, infinitely_sharp}));
  EXPECT_EQ(held_vertices(mesh), 4);
  const SoundMesh at_a_vertex = sound(touching_cubes({2, 2, 2}));
  EXPECT_TRUE(at_a_vertex.edge_sharpness.empty());
  EXPECT_EQ(held_vertices(at_a_vertex), 2);
}

// A floor of 2 x n squares with a wall on its middle line.
PolygonMesh wall_on_floor(int n) {
  PolygonMesh mesh = shapes::plane(2, n);
  const int first = static_cast<int>(mesh.positions.size());
  for (int j = 0; j <= n; ++j) mesh.positions.push_back(mesh.positions[n + 1 + j] + Vec3::UnitZ());
  for (int j = 0; j < n; ++j)
    shapes::add_face(mesh, {n + 1 + j, n + 2 + j, first + j + 1, first + j});
  return mesh;
}

TEST(HeldPlaces, AreTheFootOfAWallButNotItsMiddle) {
  const SoundMesh mesh = sound(wall_on_floor(3));
  EXPECT_EQ(mesh.seams.size(), 3U);
  EXPECT_EQ(held_vertices(mesh), 4) << "the ends, of floor and wall";
  EXPECT_EQ(std::count(mesh.edge_sharpness.begin(), mesh.edge_sharpness.end(), infinitely_sharp),
            6);
}

TEST(HeldPlaces, AreOfCagesAlone) {
  PolygonMesh mesh = wall_on_floor(3);
  mesh.cage = false;
  EXPECT_EQ(sound(mesh).edge_sharpness.size(), 0U);
  EXPECT_EQ(held_vertices(sound(shapes::cube())), 0);
  EXPECT_EQ(held_vertices(sound(shapes::moebius_mesh(12, 3))), 0);
}

}  // namespace
}  // namespace illustrate
