#include "control/straight_creases.h"

#include <gtest/gtest.h>

#include <numeric>

#include "surface/planes/plane_faces.h"
#include "tests/cpp/shapes.h"

namespace illustrate {
namespace {

// A box with a corner more on each of its upright edges, so high.
SoundMesh box(double height, double lean = 0) {
  Points positions;
  for (const double z : {0., height, 1.}) {
    const double out = z == height ? lean : 0;
    for (const auto& [x, y] : {std::array{0., 0.}, {1., 0.}, {1., 1.}, {0., 1.}})
      positions.emplace_back(x + out * (2 * x - 1), y + out * (2 * y - 1), z);
  }
  std::vector<std::vector<int>> faces{{3, 2, 1, 0}, {8, 9, 10, 11}};
  for (const int ring : {0, 4})
    for (int k = 0; k < 4; ++k)
      faces.push_back({ring + k, ring + (k + 1) % 4, ring + 4 + (k + 1) % 4, ring + 4 + k});
  PolygonMesh mesh = shapes::polygon_mesh(std::move(positions), faces);
  mesh.crease_angle_deg = 30;
  mesh.cage = false;
  Counts report;
  SoundMesh sound = sanitize(mesh, report);
  find_plane_faces(sound, 0, 0, 1);
  return sound;
}

// Which of the twelve vertices are held.
std::vector<int> held(SoundMesh mesh) {
  hold_straight_creases(mesh);
  std::vector<int> result;
  for (int v = 0; v < static_cast<int>(mesh.vertex_sharpness.size()); ++v)
    if (mesh.vertex_sharpness[idx(v)] >= infinitely_sharp) result.push_back(v);
  return result;
}

TEST(StraightCreases, AreHeldWhereTheyWouldSlide) {
  EXPECT_EQ(held(box(.2)), (std::vector{4, 5, 6, 7}));
  EXPECT_EQ(held(box(.9)), (std::vector{4, 5, 6, 7}));
}

TEST(StraightCreases, OfLikeEdgesStayAsTheyAre) { EXPECT_TRUE(held(box(.5)).empty()); }

TEST(StraightCreases, AreNoneWhereTheyBend) { EXPECT_TRUE(held(box(.2, .01)).empty()); }

}  // namespace
}  // namespace illustrate
