// What is shaded smooth and cannot be.
#include "mesh/breaks.h"

#include "tests/cpp/check_sound.h"
#include "tests/cpp/shapes.h"

namespace illustrate {
namespace {

using shapes::pi;

struct Shaded {
  SoundMesh mesh;
  Counts report;
};

// With the same normal at all corners of a vertex: the mean of its faces', as Blender shades what
// nobody has marked.
PolygonMesh smooth(PolygonMesh mesh) {
  mesh.cage = false;
  mesh.crease_angle_deg = 30;
  Points normals(mesh.positions.size(), Vec3::Zero());
  const int* corner = mesh.corner_vertices.data();
  for (const int size : mesh.face_sizes) {
    const Points& p = mesh.positions;
    const Vec3 normal =
        (p[corner[1]] - p[corner[0]]).cross(p[corner[2]] - p[corner[0]]).normalized();
    for (int k = 0; k < size; ++k, ++corner) normals[*corner] += normal;
  }
  for (const int v : mesh.corner_vertices) mesh.corner_normals.push_back(normals[v]);
  return mesh;
}

Shaded shaded(const PolygonMesh& mesh) {
  Shaded result;
  result.mesh = sanitize(mesh, result.report);
  return result;
}

std::int64_t breaks_of(const PolygonMesh& mesh) { return shaded(smooth(mesh)).report.at("breaks"); }

// Half a drum: its straight wall, at x = 0, meets the lids and the round side at right angles.
PolygonMesh half_drum(int n) {
  PolygonMesh mesh;
  std::vector<int> top, bottom;
  for (int i = 0; i <= n; ++i) {
    const double a = pi * i / n - pi / 2;
    mesh.positions.emplace_back(std::cos(a), std::sin(a), -1);
    mesh.positions.emplace_back(std::cos(a), std::sin(a), 1);
    const int next = 2 * ((i + 1) % (n + 1));
    shapes::add_face(mesh, {2 * i, next, next + 1, 2 * i + 1});
    top.push_back(2 * i + 1);
    bottom.insert(bottom.begin(), 2 * i);
  }
  shapes::add_face(mesh, top);
  shapes::add_face(mesh, bottom);
  return mesh;
}

TEST(Breaks, AreRimsThatAreFinerThanTheyTurn) {
  EXPECT_EQ(breaks_of(shapes::drum(32)), 64);
  EXPECT_EQ(breaks_of(shapes::drum(12)), 24);
  EXPECT_EQ(breaks_of(shapes::drum(8)), 0);
  EXPECT_EQ(breaks_of(shapes::cube()), 0);
}

TEST(Breaks, AreSharpAndShadedAsIfTheyWereMarked) {
  const Shaded drum = shaded(smooth(shapes::drum(32)));
  EXPECT_EQ(drum.report.at("normal_creases"), 64);
  EXPECT_EQ(drum.report.at("angle_creases"), 0);
  EXPECT_EQ(drum.report.at("corners"), 0);
  EXPECT_EQ(drum.report.at("tips"), 0);
  ASSERT_EQ(drum.mesh.edge_sharpness.size(), 64U);
  std::size_t corner = 0;
  for (const int size : drum.mesh.face_sizes) {
    for (int k = 0; k < size; ++k, ++corner) {
      const Vec3& p = drum.mesh.positions[drum.mesh.corner_vertices[corner]];
      const Vec3 expected = size == 4 ? Vec3(p.x(), p.y(), 0) : Vec3(0, 0, p.z());
      EXPECT_LT((drum.mesh.corner_normals[corner] - expected).norm(), 1e-12);
    }
  }
}

// Rings of a few sides are round, however fine they are along their core.
TEST(Breaks, AreNoSidesOfACurve) {
  EXPECT_EQ(breaks_of(shapes::torus_mesh(1, 0.3, 48, 6)), 0);
  EXPECT_EQ(breaks_of(shapes::torus_mesh(1, 0.3, 48, 5)), 0);
  EXPECT_EQ(breaks_of(shapes::torus_mesh(1, 0.3, 48, 4)), 0);
}

// Rims of the upper and the lower lid as edges that are sharp.
PolygonMesh with_sharp_lids(PolygonMesh mesh) {
  const int n = static_cast<int>(mesh.positions.size()) / 2;
  for (int i = 0; i < 2 * n; ++i) {
    mesh.edge_vertices.push_back({i, (i + 2) % (2 * n)});
    mesh.edge_sharpness.push_back(infinitely_sharp);
  }
  return mesh;
}

// As those of a cube, whose edges all go on round it, they stay smooth where diagonals are added.
TEST(Breaks, AreNotAddedByDiagonals) {
  EXPECT_EQ(breaks_of(shapes::split_the_same_way(shapes::torus_mesh(1, 0.3, 48, 4))), 0);
  EXPECT_EQ(breaks_of(shapes::split_the_same_way(shapes::cube())), 0);
}

// A block with a step: of its two sides of six corners nothing goes on as round a tube.
TEST(Breaks, AreTheEdgesOfBlocksThatAreNoTubes) {
  PolygonMesh block;
  const std::vector<Vec2> side{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  for (const double y : {0., 1.})
    for (const Vec2& p : side) block.positions.emplace_back(p.x(), y, p.y());
  for (int i = 0; i < 6; ++i) shapes::add_face(block, {i, (i + 1) % 6, 6 + (i + 1) % 6, 6 + i});
  shapes::add_face(block, {5, 4, 3, 2, 1, 0});
  shapes::add_face(block, {6, 7, 8, 9, 10, 11});
  EXPECT_EQ(breaks_of(block), 18);
}

TEST(Breaks, GoOnStraightBetweenOthersAndCreases) {
  EXPECT_EQ(breaks_of(half_drum(16)), 2 * 16 + 2 + 2);
  EXPECT_EQ(breaks_of(with_sharp_lids(half_drum(16))), 2);
  EXPECT_EQ(breaks_of(half_drum(4)), 2 * 4 + 2 + 2) << "corners hold it";
  EXPECT_EQ(breaks_of(with_sharp_lids(shapes::drum(4))), 0);
}

TEST(Breaks, AreNotOfCages) {
  PolygonMesh drum = smooth(shapes::drum(32));
  drum.cage = true;
  EXPECT_EQ(shaded(drum).report.at("breaks"), 0);
}

TEST(Breaks, AreNotWhatIsSharpAlready) {
  EXPECT_EQ(breaks_of(with_sharp_lids(shapes::drum(32))), 0);
  PolygonMesh flat = shapes::drum(32);
  flat.cage = false;
  flat.crease_angle_deg = 30;
  EXPECT_EQ(shaded(flat).report.at("breaks"), 0);
}

}  // namespace
}  // namespace illustrate
