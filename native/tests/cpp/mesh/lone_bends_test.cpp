// Bends of flat faces below the crease angle: of roofs and ramps, but no samples of curves.
#include "mesh/lone_bends.h"

#include <gtest/gtest.h>

#include "mesh/sanitize.h"
#include "tests/cpp/shapes.h"

namespace illustrate {
namespace {

PolygonMesh flat(PolygonMesh mesh) {
  mesh.cage = false;
  mesh.crease_angle_deg = 30;
  return mesh;
}

std::int64_t bends_of(const PolygonMesh& mesh) {
  Counts report;
  sanitize(mesh, report);
  return report.at("lone_bends");
}

double slope(double degrees) { return std::tan(degrees * pi / 180); }

// A side profile (x, z), counterclockwise, drawn out along y: two faces and a wall for each edge.
PolygonMesh extruded(const std::vector<Vec2>& profile, double length = 2) {
  PolygonMesh mesh;
  const int n = static_cast<int>(profile.size());
  for (const double y : {0., length})
    for (const Vec2& p : profile) mesh.positions.emplace_back(p.x(), y, p.y());
  std::vector<int> front, back;
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    shapes::add_face(mesh, {j, i, n + i, n + j});
    front.push_back(i);
    back.insert(back.begin(), n + i);
  }
  shapes::add_face(mesh, front);
  shapes::add_face(mesh, back);
  return flat(mesh);
}

// Its two sides turn by so much.
PolygonMesh roof(double degrees) {
  return extruded({{-1, -0.6}, {1, -0.6}, {1, 0}, {0, slope(degrees / 2)}, {-1, 0}});
}

TEST(LoneBends, AreBendsOfLowRoofs) {
  for (const double degrees : {9., 12., 20., 29.}) EXPECT_EQ(bends_of(roof(degrees)), 1);
  EXPECT_EQ(bends_of(roof(6)), 0) << "hardly seen";
  EXPECT_EQ(bends_of(roof(40)), 0) << "sharp by its angle";
}

TEST(LoneBends, AreSharp) {
  Counts report;
  const SoundMesh sound = sanitize(roof(12), report);
  EXPECT_EQ(report.at("angle_creases"), 14);
  EXPECT_EQ(sound.edge_sharpness.size(), 15U);
}

PolygonMesh in_triangles(const PolygonMesh& mesh) {
  PolygonMesh result;
  result.positions = mesh.positions;
  const int* corner = mesh.corner_vertices.data();
  for (const int size : mesh.face_sizes) {
    for (int k = 2; k < size; ++k) shapes::add_face(result, {corner[0], corner[k - 1], corner[k]});
    corner += size;
  }
  return flat(result);
}

TEST(LoneBends, DoNotDependOnHowFacesAreCutNorOnPlaceAndSize) {
  for (const double size : {1e-60, 1e-3, 1e60}) {
    PolygonMesh far = in_triangles(roof(12));
    const Eigen::AngleAxisd turn(0.7, Vec3(1, 2, 3).normalized());
    for (Vec3& p : far.positions) p = size * (turn * p + Vec3(30, -20, 50));
    EXPECT_EQ(bends_of(far), 1) << size;
  }
}

TEST(LoneBends, AreTheHipsOfARoof) {
  PolygonMesh house;
  const double h = slope(10);
  house.positions = {{-2, -1, 0}, {2, -1, 0}, {2, 1, 0}, {-2, 1, 0}, {-1, 0, h}, {1, 0, h}};
  for (const double x : {-2., 2.})
    for (const double y : {-1., 1.}) house.positions.emplace_back(x, y, -1);
  shapes::add_face(house, {0, 1, 5, 4});
  shapes::add_face(house, {2, 3, 4, 5});
  shapes::add_face(house, {1, 2, 5});
  shapes::add_face(house, {3, 0, 4});
  shapes::add_face(house, {6, 8, 1, 0});
  shapes::add_face(house, {8, 9, 2, 1});
  shapes::add_face(house, {9, 7, 3, 2});
  shapes::add_face(house, {7, 6, 0, 3});
  shapes::add_face(house, {6, 7, 9, 8});
  EXPECT_EQ(bends_of(flat(house)), 5);
}

TEST(LoneBends, AreTheEndsOfRamps) {
  const double h = slope(14);
  EXPECT_EQ(bends_of(extruded({{-2, -1}, {2, -1}, {2, h}, {0.5, h}, {-0.5, 0}, {-2, 0}})), 2);
}

// A block whose upper edge is rounded by so many faces.
PolygonMesh rounded_block(int steps, double radius) {
  std::vector<Vec2> profile{{-1, -1}, {1, -1}};
  for (int i = 0; i <= steps; ++i) {
    const double a = pi / 2 * i / steps;
    profile.emplace_back(1 - radius + radius * std::cos(a), radius * std::sin(a));
  }
  profile.emplace_back(-1, radius);
  return extruded(profile);
}

TEST(LoneBends, AreNoSamplesOfCurves) {
  for (const int n : {16, 24, 32, 64}) EXPECT_EQ(bends_of(flat(shapes::drum(n))), 0) << n;
  for (const int steps : {4, 8, 16}) {
    EXPECT_EQ(bends_of(rounded_block(steps, 0.2)), 0) << steps;
    EXPECT_EQ(bends_of(rounded_block(steps, 1)), 0) << steps;
  }
  for (const int n : {16, 32, 64})
    EXPECT_EQ(bends_of(flat(shapes::uv_sphere_mesh(1, n, n / 2))), 0) << n;
  for (const int level : {1, 2, 3})
    EXPECT_EQ(bends_of(flat(shapes::icosphere_mesh(1, level))), 0) << level;
  EXPECT_EQ(bends_of(flat(shapes::torus_mesh(1, 0.3, 32, 24))), 0);
}

TEST(LoneBends, AreNoWavesOfAField) {
  for (const int n : {6, 12, 40}) {
    const auto height = [](double x, double y) {
      return 0.05 * std::sin(9 * x + 2 * y) * std::cos(7 * y);
    };
    const PolygonMesh field = shapes::height_field(n, n, height);
    EXPECT_EQ(bends_of(flat(field)), 0) << n;
    EXPECT_EQ(bends_of(flat(shapes::split_the_same_way(field))), 0) << n;
  }
}

TEST(LoneBends, AreNotOfCagesNorAboveAGivenAngle) {
  PolygonMesh mesh = roof(12);
  mesh.crease_angle_deg = 40;
  EXPECT_EQ(bends_of(mesh), 0);
  mesh = roof(12);
  mesh.cage = true;
  EXPECT_EQ(bends_of(mesh), 0);
}

}  // namespace
}  // namespace illustrate
