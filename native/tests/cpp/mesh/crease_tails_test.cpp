// Creases that fade out below the crease angle.
#include "mesh/crease_tails.h"

#include <gtest/gtest.h>

#include "mesh/sanitize.h"
#include "tests/cpp/shapes.h"

namespace illustrate {
namespace {

constexpr int rows = 10;

// A roof whose ridge along y turns by 180 degrees at y = 0 and by less and less up to y = rows,
// where it is flat: the ridge's edge of row i turns by 2 atan(1 - (i + 1/2) / rows).
PolygonMesh fading_roof(double bend_deg = 0, int bend_row = rows) {
  PolygonMesh mesh;
  for (int i = 0; i <= rows; ++i) {
    const double turned = i > bend_row ? std::tan(bend_deg * pi / 180) * (i - bend_row) : 0;
    for (const int side : {-1, 0, 1}) {
      const double steepness = 1 - static_cast<double>(i) / rows;
      mesh.positions.emplace_back(2 * side + turned, i, -2 * steepness * std::abs(side));
    }
  }
  for (int i = 0; i < rows; ++i) {
    for (const int k : {3 * i, 3 * i + 1}) shapes::add_face(mesh, {k, k + 1, k + 4, k + 3});
  }
  mesh.cage = false;
  mesh.crease_angle_deg = 30;
  return mesh;
}

std::int64_t count(const PolygonMesh& mesh, const char* name) {
  Counts report;
  sanitize(mesh, report);
  return report.at(name);
}

TEST(CreaseTails, GoOnWhereCreasesFadeOut) {
  EXPECT_EQ(count(fading_roof(), "angle_creases"), 7);
  EXPECT_EQ(count(fading_roof(), "crease_tails"), 2) << "28 and 17 degrees; the last turns by 6";
}

TEST(CreaseTails, DoNotDependOnPlaceAndSize) {
  for (const double size : {1e-60, 1e-3, 1e60}) {
    PolygonMesh far = fading_roof();
    const Eigen::AngleAxisd turn(0.7, Vec3(1, 2, 3).normalized());
    for (Vec3& p : far.positions) p = size * (turn * p + Vec3(30, -20, 50));
    EXPECT_EQ(count(far, "crease_tails"), 2) << size;
  }
}

TEST(CreaseTails, NeedALineOfThreeEdges) {
  PolygonMesh mesh = fading_roof();
  mesh.crease_angle_deg = 29;
  for (const int first : {4, 5}) {
    PolygonMesh cut = mesh;
    cut.face_sizes.erase(cut.face_sizes.begin(), cut.face_sizes.begin() + 2 * first);
    cut.corner_vertices.erase(cut.corner_vertices.begin(), cut.corner_vertices.begin() + 8 * first);
    EXPECT_EQ(count(cut, "angle_creases"), 7 - first);
    EXPECT_EQ(count(cut, "crease_tails"), first == 4 ? 2 : 0);
  }
}

TEST(CreaseTails, AreNoLongerThanTheirLine) {
  PolygonMesh mesh = fading_roof();
  for (Vec3& p : mesh.positions) p.z() *= 0.4;
  EXPECT_EQ(count(mesh, "angle_creases"), 3);
  EXPECT_EQ(count(mesh, "crease_tails"), 3) << "of five edges that turn by 29 to 11 degrees";
}

TEST(CreaseTails, GoStraightOn) {
  EXPECT_EQ(count(fading_roof(15, 8), "crease_tails"), 2);
  EXPECT_EQ(count(fading_roof(50, 8), "crease_tails"), 1);
}

TEST(CreaseTails, AreOfMeshesThatAreShadedFlatOnly) {
  PolygonMesh cage = fading_roof();
  cage.cage = true;
  EXPECT_EQ(count(cage, "crease_tails"), 0);
  PolygonMesh soft = fading_roof();
  soft.crease_angle_deg = 31;
  EXPECT_EQ(count(soft, "crease_tails"), 0) << "who raises it wants fewer edges";
  PolygonMesh smooth = fading_roof();
  smooth.corner_normals.assign(smooth.corner_vertices.size(), Vec3::UnitZ());
  EXPECT_EQ(count(smooth, "crease_tails"), 0);
}

TEST(CreaseTails, EndInCorners) {
  PolygonMesh mesh = fading_roof();
  const std::int64_t with_end = count(mesh, "corners");
  for (Vec3& p : mesh.positions) p.z() = 0;
  EXPECT_EQ(with_end, count(mesh, "corners") + 1);
}

}  // namespace
}  // namespace illustrate
