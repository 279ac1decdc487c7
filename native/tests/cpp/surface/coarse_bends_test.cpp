#include "surface/subdivision/coarse_bends.h"

#include <gtest/gtest.h>

#include <cmath>

#include "surface/refine.h"
#include "tests/cpp/shapes.h"

namespace illustrate {
namespace {

SoundMesh sound_cage(const PolygonMesh& mesh) {
  Counts report;
  return sanitize(mesh, report);
}

// A coarse tube of n sides and radius 1, closed by no caps.
PolygonMesh coarse_tube(int n) {
  PolygonMesh mesh;
  for (const double z : {-1., 1.})
    for (int i = 0; i < n; ++i)
      mesh.positions.emplace_back(std::cos(2 * pi * i / n), std::sin(2 * pi * i / n), z);
  for (int i = 0; i < n; ++i) shapes::add_face(mesh, {i, (i + 1) % n, n + (i + 1) % n, n + i});
  return mesh;
}

// Each level quarters how far chords are from their arcs; an arc's sagitta is an eighth of chord
// times angle.
TEST(CoarseBends, AskForTheLevelWhoseChordsAreShort) {
  constexpr double median = .01;
  for (const int n : {8, 16, 32}) {
    const double chord = 2 * std::sin(pi / n), sagitta = chord * 2 * pi / n / 8;
    for (const double longest : {.5, .1, .02}) {
      const double levels = std::log2(sagitta / (longest / 8)) / 2;
      const int expected = std::max(0, static_cast<int>(std::ceil(levels)));
      EXPECT_EQ(level_for_coarse_bends(sound_cage(coarse_tube(n)), median, longest, 7), expected)
          << n << " sides, " << longest;
    }
  }
}

TEST(CoarseBends, AreNoneInAMeshOfOneSizeNorInFlatOrSharpOnes) {
  const double edge = 2 * std::sin(pi / 8);
  EXPECT_EQ(level_for_coarse_bends(sound_cage(coarse_tube(8)), edge, .01, 7), 0);
  EXPECT_EQ(level_for_coarse_bends(sound_cage(shapes::plane(3, 3)), .001, .01, 7), 0);
  PolygonMesh cube = shapes::cube();
  cube.crease_angle_deg = 30;
  EXPECT_EQ(level_for_coarse_bends(sound_cage(cube), .001, .01, 7), 0);
  EXPECT_EQ(level_for_coarse_bends(sound_cage(coarse_tube(8)), .001, 1e-9, 3), 3) << "the highest";
}

// A square tube that is no cage folds at its edges.
TEST(CoarseBends, OfFoldsAskForOneLevel) {
  PolygonMesh mesh = coarse_tube(4);
  EXPECT_GT(level_for_coarse_bends(sound_cage(mesh), .001, .01, 7), 3);
  mesh.cage = false;
  EXPECT_EQ(level_for_coarse_bends(sound_cage(mesh), .001, .01, 7), 1);
}

// A rounding between two walls: its strips are narrow, and as long as the walls.
PolygonMesh rounded_wall(int strips) {
  std::vector<Vec2> outline{{-4, 1}};
  for (int i = 0; i <= strips; ++i) {
    const double angle = pi / 2 * i / strips;
    outline.emplace_back(std::sin(angle), std::cos(angle));
  }
  outline.emplace_back(1, -4);
  PolygonMesh mesh;
  for (const Vec2& p : outline) {
    for (const double y : {0., 6.}) mesh.positions.emplace_back(p.x(), y, p.y());
  }
  for (int i = 0; i + 1 < static_cast<int>(outline.size()); ++i)
    shapes::add_face(mesh, {2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1});
  return mesh;
}

// The limit of what is no cage would slide along the strips, so it is kept to its vertices; but not
// where the strips are too short to be seen.
TEST(CoarseBends, AlongARoundingAskForOneLevel) {
  PolygonMesh mesh = rounded_wall(12);
  EXPECT_EQ(level_for_coarse_bends(sound_cage(mesh), .2, 1, 7), 0);
  mesh.cage = false;
  EXPECT_EQ(level_for_coarse_bends(sound_cage(mesh), .2, 1, 7), 1);
  EXPECT_EQ(level_for_coarse_bends(sound_cage(mesh), .2, 7, 7), 0);
}

std::int64_t level_beside(const PolygonMesh& mesh, int budget) {
  PolygonMesh all = shapes::joined(shapes::icosphere_mesh(.1, 4), shapes::moved(mesh, {3, 0, 0}));
  SurfaceOptions options;
  options.edge_length = .05;
  options.triangle_budget = budget;
  Counts report;
  refine({sound_cage(all)}, options, report);
  return report["level_0"];
}

// The fine sphere alone needs no level: its edges are of .01.
TEST(CoarseBends, MakeTheLevelOfAMeshThatIsFineElsewhere) {
  EXPECT_EQ(level_beside(shapes::icosphere_mesh(.1, 4), 1'000'000), 0);
  EXPECT_EQ(level_beside(shapes::icosphere_mesh(1, 0), 1'000'000), 2);
  EXPECT_EQ(level_beside(shapes::icosphere_mesh(1, 0), 30'000), 1) << "as the budget allows";
}

}  // namespace
}  // namespace illustrate
