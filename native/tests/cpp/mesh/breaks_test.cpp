// What is shaded smooth and cannot be.
#include "mesh/breaks.h"

#include "tests/cpp/check_sound.h"
#include "tests/cpp/shapes.h"

namespace illustrate {
namespace {

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

struct Ends {
  double inner = 0.8;
  double length = 4;
  double slant = 0;  // of the cut at its upper end
};

// A straight pipe with a wall, round z, of radius 1.
PolygonMesh pipe(int n, const Ends& ends) {
  PolygonMesh mesh;
  for (const double radius : {1., ends.inner}) {
    for (const double side : {-1., 1.}) {
      for (int i = 0; i < n; ++i) {
        const double a = 2 * pi * i / n, x = radius * std::cos(a);
        const double z = side * ends.length / 2 + (side > 0 ? ends.slant * x : 0);
        mesh.positions.emplace_back(x, radius * std::sin(a), z);
      }
    }
  }
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    shapes::add_face(mesh, {i, j, n + j, n + i});
    shapes::add_face(mesh, {3 * n + i, 3 * n + j, 2 * n + j, 2 * n + i});
    shapes::add_face(mesh, {n + i, n + j, 3 * n + j, 3 * n + i});
    shapes::add_face(mesh, {2 * n + i, 2 * n + j, j, i});
  }
  return mesh;
}

TEST(Breaks, AreTheEndsOfStraightPipes) {
  for (const int n : {8, 12, 16, 24, 32, 64}) {
    EXPECT_EQ(breaks_of(pipe(n, {})), 4 * n) << n;
    EXPECT_EQ(breaks_of(pipe(n, {0.8, 4, 0.8})), 4 * n) << n << " slanted";
    EXPECT_EQ(breaks_of(pipe(n, {0.98, 4, 1.2})), 4 * n) << n << " thin and more slanted";
    EXPECT_EQ(breaks_of(shapes::split_the_same_way(pipe(n, {}))), 4 * n) << n << " triangles";
  }
}

TEST(Breaks, AreEndsOfPipesOfAnySizeAnywhere) {
  for (const double size : {1e-60, 1e-3, 1e3, 1e60}) {
    PolygonMesh small = pipe(16, {});
    const Eigen::AngleAxisd turn(0.7, Vec3(1, 2, 3).normalized());
    for (Vec3& p : small.positions) p = size * (turn * p + Vec3(300, -200, 50));
    EXPECT_EQ(breaks_of(small), 4 * 16) << size;
  }
}

TEST(Breaks, AreNoEndsOfRingsOfLikeSides) {
  EXPECT_EQ(breaks_of(pipe(32, {0.8, 0.2})), 0);
  EXPECT_EQ(breaks_of(pipe(32, {0.8, 0.38})), 0);
  EXPECT_EQ(breaks_of(pipe(32, {0.8, 0.5})), 4 * 32);
}

TEST(Breaks, AreNoEndsOfPipesOfFewSides) {
  for (const int n : {4, 5, 6, 7}) EXPECT_EQ(breaks_of(pipe(n, {})), 0) << n;
}

// A prism of `sides` with a bore of `sides * steps`.
PolygonMesh nut(int sides, int steps) {
  PolygonMesh mesh;
  const int n = sides * steps, half = n + sides;
  const auto add_ring = [&](int count, double radius, double z) {
    for (int i = 0; i < count; ++i)
      mesh.positions.emplace_back(radius * std::cos(2 * pi * i / count),
                                  radius * std::sin(2 * pi * i / count), z);
  };
  for (const double z : {-0.4, 0.4}) {
    add_ring(n, 0.5, z);
    add_ring(sides, 1, z);
  }
  for (int i = 0; i < n; ++i)
    shapes::add_face(mesh, {half + i, half + (i + 1) % n, (i + 1) % n, i});
  for (int i = 0; i < sides; ++i) {
    const int a = n + i, b = n + (i + 1) % sides;
    shapes::add_face(mesh, {a, b, half + b, half + a});
    std::vector<int> lower{b, a}, upper{half + a, half + b};
    for (int k = 0; k <= steps; ++k) {
      lower.push_back(steps * i + k);
      upper.push_back(half + (steps * (i + 1) - k) % n);
    }
    lower.back() %= n;
    shapes::add_face(mesh, lower);
    shapes::add_face(mesh, upper);
  }
  return mesh;
}

TEST(Breaks, AreTheEdgesOfNutsWithARoundBore) {
  for (const int steps : {2, 4, 8}) {
    const int rims = 2 * 6 * steps + 2 * 6;
    EXPECT_EQ(breaks_of(nut(6, steps)), rims + 6) << steps;
  }
  EXPECT_EQ(breaks_of(nut(8, 4)), 2 * 32 + 2 * 8) << "an octagon is round";
  EXPECT_EQ(breaks_of(nut(6, 1)), 0) << "the bore is no rounder than the rest";
}

// A hexagonal head on a round shank.
PolygonMesh bolt(int sides, int shank) {
  PolygonMesh mesh;
  const auto add_ring = [&](int count, double radius, double z) {
    const int first = static_cast<int>(mesh.positions.size());
    for (int i = 0; i < count; ++i)
      mesh.positions.emplace_back(radius * std::cos(2 * pi * i / count),
                                  radius * std::sin(2 * pi * i / count), z);
    return first;
  };
  const int end = add_ring(shank, 0.5, -3), neck = add_ring(shank, 0.5, 0);
  const int under = add_ring(sides, 1, 0), top = add_ring(sides, 1, 0.7);
  std::vector<int> end_face, top_face;
  const int steps = shank / sides;
  for (int i = 0; i < shank; ++i) {
    const int j = (i + 1) % shank;
    shapes::add_face(mesh, {end + i, end + j, neck + j, neck + i});
    end_face.insert(end_face.begin(), end + i);
  }
  for (int i = 0; i < sides; ++i) {
    const int j = (i + 1) % sides;
    shapes::add_face(mesh, {under + i, under + j, top + j, top + i});
    top_face.push_back(top + i);
    std::vector<int> below{under + j, under + i};
    for (int k = 0; k <= steps; ++k) below.push_back(neck + (steps * i + k) % shank);
    shapes::add_face(mesh, below);
  }
  shapes::add_face(mesh, end_face);
  shapes::add_face(mesh, top_face);
  return mesh;
}

TEST(Breaks, AreTheEdgesOfBoltsOnARoundShank) {
  EXPECT_EQ(breaks_of(bolt(6, 24)), 2 * 24 + 3 * 6);
  EXPECT_EQ(breaks_of(bolt(8, 24)), 2 * 24 + 8) << "an octagon is round";
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
