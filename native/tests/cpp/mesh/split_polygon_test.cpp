// Faces that come to a vertex twice: no area is lost, no hole closed.
#include "mesh/split_polygon.h"

#include "tests/cpp/check_sound.h"
#include "tests/cpp/shapes.h"

namespace illustrate {
namespace {

// Twice the area vector.
Vec3 area_of(Span<const int> polygon, const Points& positions) {
  Vec3 area = Vec3::Zero();
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
    area += (positions[polygon[k]] - positions[polygon[0]])
                .cross(positions[polygon[k + 1]] - positions[polygon[0]]);
  return area;
}

Vec3 area_of(const std::vector<int>& polygon, const Points& positions) {
  return area_of({polygon.data(), polygon.size()}, positions);
}

Ragged<int> split(const std::vector<int>& face, const Points& positions) {
  std::size_t looks = 100'000;
  return split_polygon({face.data(), face.size()}, positions, looks);
}

// The parts have different corners, and lie on each other nowhere: the sizes of their areas add up
// to `expected`, twice the area that is covered.
std::vector<std::size_t> part_sizes(const std::vector<int>& face, const Points& positions,
                                    double expected) {
  const Ragged<int> parts = split(face, positions);
  std::vector<std::size_t> sizes;
  double area = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    EXPECT_EQ(std::set<int>(parts[i].begin(), parts[i].end()).size(), parts[i].size());
    sizes.push_back(parts[i].size());
    area += area_of(parts[i], positions).norm();
  }
  EXPECT_NEAR(area, expected, 1e-12 * (1 + expected));
  std::sort(sizes.begin(), sizes.end());
  return sizes;
}

using Sizes = std::vector<std::size_t>;

// A square of side 6, then squares of side 1 with corners (x, y) .. (x + 1, y + 1).
Points squares(const std::vector<Vec2>& corners) {
  Points positions{{0, 0, 0}, {6, 0, 0}, {6, 6, 0}, {0, 6, 0}};
  for (const Vec2& c : corners)
    for (const Vec2& step : {Vec2(0, 0), Vec2(0, 1), Vec2(1, 1), Vec2(1, 0)})
      positions.emplace_back(c.x() + step.x(), c.y() + step.y(), 0);
  return positions;
}

TEST(SplitPolygon, LobesBecomeFaces) {
  // Two triangles and a quad that meet in vertex 0, each seen from its front.
  const Points positions{{0, 0, 0},  {1, 0, 0},   {1, 1, 0},  {0, 1, 0},
                         {-1, 0, 0}, {-1, -1, 0}, {0, -2, 0}, {2, -2, 0}};
  EXPECT_EQ(part_sizes({0, 1, 2, 0, 3, 4, 5, 0, 6, 7}, positions, 1 + 2 + 4), Sizes({3, 3, 4}));
}

TEST(SplitPolygon, FigureEightBecomesTwoFacesOfOppositeWinding) {
  const Points positions{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, 1, 0}};
  const std::vector<int> face{0, 1, 2, 0, 3, 4};
  EXPECT_NEAR(area_of(face, positions).norm(), 0, 1e-12);
  EXPECT_EQ(part_sizes(face, positions, 2), Sizes({3, 3}));
}

TEST(SplitPolygon, SpikesVanish) {
  const Points positions = squares({{2, 2}});
  EXPECT_EQ(part_sizes({0, 1, 2, 4, 2, 3}, positions, 72), Sizes({4}));
  EXPECT_EQ(part_sizes({0, 1, 2, 4, 5, 4, 2, 3}, positions, 72), Sizes({4}));
  EXPECT_EQ(part_sizes({4, 5, 6, 5}, positions, 0), Sizes());
}

TEST(SplitPolygon, BridgedHoleStaysOpen) {
  const Points positions = squares({{2, 2}});
  EXPECT_EQ(part_sizes({0, 1, 2, 3, 0, 4, 5, 6, 7, 4}, positions, 72 - 2).size(), 2U);
  // The same, begun elsewhere, and seen from behind.
  std::vector<int> face{5, 6, 7, 4, 0, 1, 2, 3, 0, 4};
  EXPECT_EQ(part_sizes(face, positions, 72 - 2).size(), 2U);
  std::reverse(face.begin(), face.end());
  EXPECT_EQ(part_sizes(face, positions, 72 - 2).size(), 2U);
}

TEST(SplitPolygon, HoleThatTouchesItsOutlineStaysOpen) {
  Points positions = squares({});
  positions.emplace_back(1, 2, 0);
  positions.emplace_back(2, 1, 0);
  EXPECT_EQ(part_sizes({0, 1, 2, 3, 0, 4, 5}, positions, 72 - 3).size(), 2U);
}

TEST(SplitPolygon, ManyHolesStayOpenInAnyPlane) {
  Points positions = squares({{1, 1}, {3, 1}, {1, 3}, {3, 4}});
  // A bridge from each corner of the outline to a hole of its own.
  const std::vector<int> face{0, 4,  5,  6,  7,  4,  0, 1, 8,  9,  10, 11, 8,  1,
                              2, 18, 19, 16, 17, 18, 2, 3, 12, 13, 14, 15, 12, 3};
  const double expected = 72 - 8;
  const Sizes sizes = part_sizes(face, positions, expected);
  EXPECT_GE(sizes.size(), 2U);
  const Eigen::AngleAxisd turn(1.1, Vec3(3, -1, 2).normalized());
  for (Vec3& p : positions) p = turn * p;
  part_sizes(face, positions, expected);
  for (Vec3& p : positions) p *= 0x1p-300;
  const Ragged<int> parts = split(face, positions);
  for (Vec3& p : positions) p *= 0x1p300;
  double area = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) area += area_of(parts[i], positions).norm();
  EXPECT_NEAR(area, expected, 1e-9);
}

TEST(SplitPolygon, WithoutLooksLoopsAreTakenAsTheyAre) {
  const Points positions = squares({{2, 2}});
  const std::vector<int> face{0, 1, 2, 3, 0, 4, 5, 6, 7, 4};
  std::size_t looks = 0;
  const Ragged<int> parts = split_polygon({face.data(), face.size()}, positions, looks);
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].size(), 4U);
  EXPECT_EQ(parts[1].size(), 4U);
}

TEST(SplitPolygon, HopelessFacesBecomeSomething) {
  const Points positions = squares({{2, 2}});
  std::vector<int> face;
  for (int i = 0; i < 60000; ++i) face.push_back(i % 3);
  EXPECT_EQ(split(face, positions).size(), 20000U);
  for (std::size_t i = 0; i < face.size(); ++i)
    face[i] = static_cast<int>((i * i * 7 + i / 5) % 8) ^ static_cast<int>(i & 1);
  face.erase(std::unique(face.begin(), face.end()), face.end());
  face.push_back(8);
  const Ragged<int> parts = split(face, squares({{2, 2}, {4, 4}}));
  EXPECT_GT(parts.size(), 1000U);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    EXPECT_GE(parts[i].size(), 3U);
    EXPECT_EQ(std::set<int>(parts[i].begin(), parts[i].end()).size(), parts[i].size());
  }
}

TEST(SplitPolygon, RingIsKeptByTheMesh) {
  PolygonMesh mesh;
  mesh.positions = squares({{2, 2}});
  shapes::add_face(mesh, {0, 1, 2, 3, 0, 4, 5, 6, 7, 4});
  const Mended mended = mend(mesh);
  EXPECT_EQ(mended.report.at("split_faces"), 1);
  EXPECT_EQ(mended.report.at("kept_faces"), 1);
  EXPECT_EQ(mended.report.at("open_edges"), 8);
  EXPECT_EQ(mended.report.at("parts"), 1);
  EXPECT_EQ(mended.mesh.source_faces, std::vector<int>({0, 0}));
}

TEST(SplitPolygon, WeldingMayMakeARing) {
  // The bridge has two sides that lie on each other.
  PolygonMesh mesh;
  mesh.positions = squares({{2, 2}});
  mesh.positions.push_back(mesh.positions[0]);
  mesh.positions.push_back(mesh.positions[4]);
  shapes::add_face(mesh, {0, 1, 2, 3, 8, 9, 5, 6, 7, 4});
  const Mended mended = mend(mesh);
  EXPECT_EQ(mended.report.at("welded_vertices"), 2);
  EXPECT_EQ(mended.report.at("split_faces"), 1);
  EXPECT_EQ(mended.report.at("open_edges"), 8);
}

TEST(SplitPolygon, MaterialsAndHolesFollowTheParts) {
  PolygonMesh mesh;
  mesh.positions = squares({{2, 2}});
  shapes::add_face(mesh, {0, 1, 2, 3, 0, 4, 5, 6, 7, 4});
  shapes::add_face(mesh, {4, 7, 6, 5});
  mesh.face_materials = {3, 5};
  mesh.hole_faces = {0};
  const SoundMesh sound = mend(mesh).mesh;
  EXPECT_EQ(sound.face_materials, std::vector<int>({3, 3, 5}));
  EXPECT_EQ(sound.holes, std::vector<std::uint8_t>({1, 1, 0}));
}

}  // namespace
}  // namespace illustrate
