// Edges shaded smooth that turn too far to be curves.
#include "control/folds.h"

#include "control/keep_to_mesh.h"
#include "surface/refine.h"
#include "tests/cpp/check_sound.h"
#include "tests/cpp/shapes.h"

namespace illustrate {
namespace {

SoundMesh mended(PolygonMesh mesh) {
  mesh.cage = false;
  mesh.boundary = BoundaryRule::edges;
  mesh.crease_angle_deg = 30;
  Counts report;
  return sanitize(mesh, report);
}

Surface surface_of(const SoundMesh& mesh) {
  Counts report;
  return refine({mesh}, {}, report);
}

// Half its width is 1, and the normal of each corner goes on from the middle.
PolygonMesh smooth_cube() {
  PolygonMesh mesh = shapes::cube();
  Vec3 middle = Vec3::Zero();
  for (const Vec3& p : mesh.positions) middle += p / 8;
  for (Vec3& p : mesh.positions) p = (p - middle).cwiseSign();
  for (const int v : mesh.corner_vertices) mesh.corner_normals.push_back(mesh.positions[idx(v)]);
  return mesh;
}

// A prism of n sides round z, all of it shaded smooth round the axis, open at the ends.
PolygonMesh tube(int n) {
  PolygonMesh mesh;
  for (const double z : {-1., 1.})
    for (int i = 0; i < n; ++i)
      mesh.positions.emplace_back(std::cos(2 * pi * i / n), std::sin(2 * pi * i / n), z);
  for (int i = 0; i < n; ++i) shapes::add_face(mesh, {i, (i + 1) % n, n + (i + 1) % n, n + i});
  for (const int v : mesh.corner_vertices) {
    const Vec3& p = mesh.positions[idx(v)];
    mesh.corner_normals.emplace_back(p.x(), p.y(), 0);
  }
  return mesh;
}

// A square tube along z, 2 wide, with chamfers of width w whose normals continue the flat sides.
PolygonMesh chamfered_tube(double w) {
  PolygonMesh mesh;
  Points normals;
  for (const double z : {-1., 1.}) {
    for (int k = 0; k < 4; ++k) {
      const Eigen::Matrix3d turn = Eigen::AngleAxisd(k * pi / 2, Vec3::UnitZ()).matrix();
      mesh.positions.push_back(turn * Vec3(1, 1 - w, z));
      mesh.positions.push_back(turn * Vec3(1 - w, 1, z));
      normals.push_back(turn * Vec3::UnitX());
      normals.push_back(turn * Vec3::UnitY());
    }
  }
  for (int i = 0; i < 8; ++i) shapes::add_face(mesh, {i, (i + 1) % 8, 8 + (i + 1) % 8, 8 + i});
  for (const int v : mesh.corner_vertices) mesh.corner_normals.push_back(normals[idx(v)]);
  return mesh;
}

// Shaded smooth: at each vertex the mean of the normals of the faces around.
PolygonMesh with_mean_normals(PolygonMesh mesh) {
  Points sums(mesh.positions.size(), Vec3::Zero());
  const int* corner = mesh.corner_vertices.data();
  for (const int size : mesh.face_sizes) {
    Vec3 area = Vec3::Zero();
    for (int k = 0; k < size; ++k)
      area += mesh.positions[idx(corner[k])].cross(mesh.positions[idx(corner[(k + 1) % size])]);
    for (int k = 0; k < size; ++k) sums[idx(corner[k])] += area.normalized();
    corner += size;
  }
  for (const int v : mesh.corner_vertices) mesh.corner_normals.push_back(sums[idx(v)]);
  return mesh;
}

int fold_count(const PolygonMesh& mesh) {
  const auto folded = fold(mended(mesh));
  return folded ? static_cast<int>(folded->soft.edge_vertices.size()) : 0;
}

// So many smooth cubes in a block; twelve folds each.
SoundMesh cubes(int count) {
  PolygonMesh all = smooth_cube();
  all.corner_normals.clear();
  for (int i = 1; i < count; ++i) {
    const PolygonMesh one = shapes::moved(smooth_cube(), 3. * Vec3(i % 12, i / 12 % 12, i / 144));
    const int first = static_cast<int>(all.positions.size());
    all.positions.insert(all.positions.end(), one.positions.begin(), one.positions.end());
    shapes::append(all.face_sizes, one.face_sizes);
    for (const int v : one.corner_vertices) all.corner_vertices.push_back(first + v);
  }
  while (all.corner_normals.size() < all.corner_vertices.size()) {
    const Points normals = smooth_cube().corner_normals;
    all.corner_normals.insert(all.corner_normals.end(), normals.begin(), normals.end());
  }
  return mended(all);
}

TEST(Folds, AreNoneWhereThereAreTooMany) {
  EXPECT_TRUE(fold(cubes(1600)).has_value());
  EXPECT_FALSE(fold(cubes(1700)).has_value());
}

TEST(Folds, AreWhatTurnsTooFarForACurve) {
  EXPECT_EQ(fold_count(smooth_cube()), 12);
  EXPECT_EQ(fold_count(tube(4)), 4);
  EXPECT_EQ(fold_count(chamfered_tube(.3)), 8);
  for (const int n : {6, 8, 12}) EXPECT_EQ(fold_count(tube(n)), 0) << n;
  EXPECT_EQ(fold_count(shapes::icosahedron()), 0);
  EXPECT_EQ(fold_count(shapes::uv_sphere_mesh(1, 8, 4)), 0);
}

// A moulding round a regular polygon of n sides: from the inside out less and less flat.
PolygonMesh moulding(int n) {
  const std::vector<Vec2> profile{{1, 0}, {1.2, .02}, {1.4, .1}, {1.5, .3}, {1.5, .8}};
  PolygonMesh mesh;
  for (const Vec2& p : profile)
    for (int i = 0; i < n; ++i)
      mesh.positions.emplace_back(p.x() * std::cos(2 * pi * i / n),
                                  p.x() * std::sin(2 * pi * i / n), p.y());
  for (int j = 0; j + 1 < static_cast<int>(profile.size()); ++j)
    for (int i = 0; i < n; ++i) {
      const int next = (i + 1) % n;
      shapes::add_face(mesh, {j * n + i, (j + 1) * n + i, (j + 1) * n + next, j * n + next});
    }
  return with_mean_normals(mesh);
}

// Its inner faces turn by 11 degrees at the corners of a square, and the strips they are pieces of
// by 90.
TEST(Folds, AreMitres) {
  EXPECT_EQ(fold_count(moulding(4)), 16);
  EXPECT_EQ(fold_count(moulding(8)), 0);
}

// Squares in a row, each turned by so many degrees against the one before.
PolygonMesh bent_strip(const std::vector<double>& turns_deg) {
  PolygonMesh mesh;
  Vec2 here = Vec2::Zero();
  double direction = 0;
  const auto add_pair = [&] {
    for (const double y : {0., 1.}) mesh.positions.emplace_back(here.x(), y, here.y());
  };
  add_pair();
  for (const double turn : turns_deg) {
    direction += turn * pi / 180;
    here += Vec2(std::cos(direction), std::sin(direction));
    add_pair();
    const int v = static_cast<int>(mesh.positions.size());
    shapes::add_face(mesh, {v - 4, v - 2, v - 1, v - 3});
  }
  return with_mean_normals(mesh);
}

TEST(Folds, AreBendsThatNoCurveGoesOnThrough) {
  EXPECT_EQ(fold_count(bent_strip({0, 0, 55, 0, 0})), 1);
  EXPECT_EQ(fold_count(bent_strip({0, 0, 55, -55, 0, 0})), 2);
  EXPECT_EQ(fold_count(bent_strip({0, 55, 55, 55, 0})), 0) << "an arc";
  EXPECT_EQ(fold_count(bent_strip({0, 25, 50, 50, 25, 0})), 0) << "an arc with its ends";
  EXPECT_EQ(fold_count(bent_strip({0, 0, 30, 0, 0})), 0) << "hardly a bend";
}

// Stairs below a roof, all of it shaded smooth. Where the roof meets the first riser it turns by 55
// degrees, less than a fold: it is one since the smooth surface would miss its ends.
TEST(Folds, AreWhatTheSmoothSurfaceMisses) {
  const std::vector<Vec2> profile{{0, 0},   {4, 0},   {4, .7},  {3, .7}, {3, 1.4},
                                  {2, 1.4}, {2, 2.1}, {1, 2.8}, {0, 2.1}};
  const int n = 9;
  PolygonMesh mesh;
  std::vector<int> front, back;
  for (const double y : {-1., 1.})
    for (const Vec2& p : profile) mesh.positions.emplace_back(p.x(), y, p.y());
  for (int i = 0; i < n; ++i) {
    shapes::add_face(mesh, {(i + 1) % n, i, i + n, (i + 1) % n + n});
    front.push_back(i);
    back.insert(back.begin(), i + n);
  }
  shapes::add_face(mesh, front);
  shapes::add_face(mesh, back);
  double nearest = 1e300;
  for (const Vec3& p : surface_of(mended(with_mean_normals(mesh))).positions)
    nearest = std::min(nearest, (p - Vec3(2, 0, 2.1)).norm());
  EXPECT_LT(nearest, .05);
}

// Far below a pixel rounding is as good as none.
TEST(Folds, TooSmallToBeSeenStaySmooth) {
  PolygonMesh far = shapes::cube();
  for (Vec3& p : far.positions) p = p * 1e-3 + Vec3(100, 0, 0);
  PolygonMesh mesh = shapes::joined(shapes::cube(), far);
  for (std::size_t c = 0; c < mesh.corner_vertices.size(); ++c)
    mesh.corner_normals.push_back(Vec3(1, 2, 3));
  EXPECT_EQ(fold_count(mesh), 12);
}

// How far points are from the sides of |x|, |y| <= 1 cut at x + y <= 2 - w; in the units of the
// form, which is nearly 3.5 across: two pixels of 1400 are .005.
double off_chamfered(const Vec3& p, double w) {
  const double x = std::abs(p.x()), y = std::abs(p.y());
  return std::abs(std::max({x - 1, y - 1, (x + y - 2 + w) / std::sqrt(2.)}));
}

TEST(Folds, KeepToTheMesh) {
  double corner = 1e300;
  for (const Vec3& p : surface_of(mended(smooth_cube())).positions) {
    EXPECT_LT(std::abs(p.cwiseAbs().maxCoeff() - 1), .003);
    corner = std::min(corner, (p - Vec3(1, 1, 1)).norm());
  }
  EXPECT_LT(corner, .005);
  for (const Vec3& p : surface_of(mended(chamfered_tube(.3))).positions)
    EXPECT_LT(off_chamfered(p, .3), .003);
}

TEST(Folds, FlatFacesStayFlat) {
  const Surface surface = surface_of(mended(chamfered_tube(.3)));
  for (std::size_t v = 0; v < surface.positions.size(); ++v) {
    const Vec3& p = surface.positions[v];
    if (std::abs(p.y()) > .6 || p.x() < .9) continue;
    EXPECT_GT(surface.normals[v].x(), 1 - 1e-9);
    EXPECT_NEAR(p.x(), 1, 1e-9);
  }
}

TEST(Folds, AreNoCreases) {
  for (const EdgeKind kind : surface_of(mended(smooth_cube())).feature_kinds)
    EXPECT_EQ(kind, EdgeKind::flat_outline);
}

// From a curve to a fold there is no jump. (Below 50 degrees the boundary has no corner here.)
TEST(Folds, GrowSteadily) {
  const auto farthest_corner = [](double degrees) {
    const double a = degrees * pi / 180;
    PolygonMesh roof = shapes::polygon_mesh({{-std::cos(a / 2), -1, -std::sin(a / 2)},
                                             {0, -1, 0},
                                             {std::cos(a / 2), -1, -std::sin(a / 2)},
                                             {-std::cos(a / 2), 1, -std::sin(a / 2)},
                                             {0, 1, 0},
                                             {std::cos(a / 2), 1, -std::sin(a / 2)}},
                                            {{0, 1, 4, 3}, {1, 2, 5, 4}});
    for (const int v : roof.corner_vertices) {
      const double x = roof.positions[idx(v)].x();
      roof.corner_normals.emplace_back(x * std::tan(a / 2), 0, 1);
    }
    roof.level = 4;
    double highest = -1;
    for (const Vec3& p : surface_of(mended(roof)).positions) highest = std::max(highest, p.z());
    return highest;
  };
  double last = farthest_corner(50.5);
  for (double degrees = 51; degrees < 85; degrees += .5) {
    const double now = farthest_corner(degrees);
    EXPECT_NEAR(now, last, .02) << degrees;
    last = now;
  }
  EXPECT_NEAR(last, 0, .003);
}

TEST(Folds, OfADoubleCoverAreAlike) {
  PolygonMesh strip = shapes::moebius_mesh(5, 1);
  for (std::size_t c = 0; c < strip.corner_vertices.size(); ++c)
    strip.corner_normals.push_back(Vec3(0, 0, 1));
  const SoundMesh mesh = mended(strip);
  const auto kept = keep_to_mesh(mesh, Scheme::catmull_clark);
  ASSERT_TRUE(kept);
  check_sound(kept->mesh);
  for (std::size_t v = 0; v < kept->mesh.positions.size(); ++v)
    EXPECT_EQ(kept->mesh.positions[v], kept->mesh.positions[idx(kept->mesh.twin_vertices[v])]);
}

}  // namespace
}  // namespace illustrate
