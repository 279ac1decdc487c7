// Hatching curvature of subdivided meshes.
#include <gtest/gtest.h>

#include <limits>

#include "surface/jets/curvature.h"
#include "tests/cpp/surface_checks.h"

namespace illustrate {
namespace {

using namespace surface_checks;
using Mat3 = Eigen::Matrix3d;

Mat3 shape_operator(const Curvature& c, std::size_t v) {
  return c[v].k1 * c[v].w1 * c[v].w1.transpose() + c[v].k2 * c[v].w2 * c[v].w2.transpose();
}

// Triangles on an ellipsoid, spaced unevenly, some valences 4 and 7 among those of the icosahedron.
PolygonMesh irregular_ellipsoid(const Vec3& axes) {
  PolygonMesh mesh = shapes::icosahedron();
  const std::vector<std::array<Triangle, 4>> flips{
      {{{0, 11, 5}, {0, 10, 11}, {0, 10, 5}, {10, 11, 5}}},
      {{{3, 9, 4}, {4, 9, 5}, {3, 9, 5}, {3, 5, 4}}},
      {{{3, 6, 8}, {8, 6, 7}, {3, 6, 7}, {3, 7, 8}}}};
  for (const auto& [a, b, c, d] : flips) {
    for (std::size_t f = 0; f < mesh.corner_vertices.size(); f += 3) {
      const auto corner = mesh.corner_vertices.begin() + static_cast<std::ptrdiff_t>(f);
      const Triangle t{corner[0], corner[1], corner[2]};
      if (t == a) std::copy(c.begin(), c.end(), corner);
      if (t == b) std::copy(d.begin(), d.end(), corner);
    }
  }
  for (Vec3& p : mesh.positions) p += Vec3(.2 * p.y() * p.z(), .15 * p.x(), .1 * p.x() * p.x());
  for (int i = 0; i < 3; ++i) {
    mesh = shapes::split_triangles(mesh);
    for (Vec3& p : mesh.positions) p.normalize();
  }
  for (Vec3& p : mesh.positions) p = p.cwiseProduct(axes);
  return mesh;
}

// Mean and difference of the principal curvatures of an ellipsoid, at the point of it above p.
std::pair<double, double> mean_and_difference(const Vec3& axes, const Vec3& near) {
  const Vec3 p = near / near.cwiseQuotient(axes).norm();
  const double h = 1 / p.cwiseQuotient(axes.cwiseProduct(axes)).norm();
  const double volume = axes.prod();
  const double gauss = std::pow(h, 4) / (volume * volume);
  const double mean =
      -std::pow(h, 3) * (axes.squaredNorm() - p.squaredNorm()) / (2 * volume * volume);
  return {mean, 2 * std::sqrt(std::max(0., mean * mean - gauss))};
}

std::vector<int> valences(const Surface& surface) {
  std::vector<int> result(surface.positions.size(), 0);
  for (const Triangle& t : surface.triangles) {
    for (const int v : t) ++result[index(v)];
  }
  return result;
}

// Relative rms error at the extraordinary vertices, and at all.
std::pair<double, double> ellipsoid_errors(const Surface& surface, const Vec3& axes) {
  const Curvature jet = jet_curvature(surface, {});
  check::curvature(surface, jet);
  const std::vector<int> valence = valences(surface);
  double off[2]{}, size[2]{};
  for (std::size_t v = 0; v < surface.positions.size(); ++v) {
    const auto [mean, difference] = mean_and_difference(axes, surface.positions[v]);
    const double found_difference = std::abs(jet[v].k1 - jet[v].k2);
    const double error = 2 * std::pow((jet[v].k1 + jet[v].k2) / 2 - mean, 2) +
                         std::pow(found_difference - difference, 2) / 2;
    for (int all = valence[v] == 6; all < 2; ++all) {
      off[all] += error;
      size[all] += 2 * mean * mean + difference * difference / 2;
    }
  }
  return {std::sqrt(off[0] / size[0]), std::sqrt(off[1] / size[1])};
}

TEST(ControlJets, ErrorDoesNotGrowWithTheLevel) {
  const Vec3 axes(1, .75, .5);
  const PolygonMesh mesh = irregular_ellipsoid(axes);
  double at_level_0 = 0;
  for (const int level : {0, 1, 2, 3}) {
    const auto [extraordinary, all] = ellipsoid_errors(refined(mesh, at_level(level)), axes);
    if (level == 0) at_level_0 = extraordinary;
    EXPECT_LT(extraordinary, .07) << level;
    EXPECT_LT(extraordinary, 1.2 * at_level_0) << level;
    EXPECT_LT(all, .07) << level;
  }
}

TEST(ControlJets, RoundCagesHaveOneCurvature) {
  for (const int level : {1, 2, 3}) {
    const std::vector<PolygonMesh> cages{shapes::icosphere_mesh(2, 3),
                                         shapes::uv_sphere_mesh(2, 40, 20)};
    for (const PolygonMesh& cage : cages) {  // Loop; Catmull-Clark with triangles at the poles
      const Surface surface = refined(cage, at_level(level));
      const Curvature jet = jet_curvature(surface, {});
      check::curvature(surface, jet);
      for (std::size_t v = 0; v < surface.positions.size(); ++v) {
        const double radius = surface.positions[v].norm();
        EXPECT_NEAR(jet[v].k1 * radius, -1, .08)
            << level << " " << surface.positions[v].transpose();
        EXPECT_NEAR(jet[v].k2 * radius, -1, .08) << level;
      }
    }
  }
}

TEST(ControlJets, CoarseCageIsNotWrappedAround) {
  const Surface surface = refined(shapes::cube(), at_level(4));
  const Curvature jet = jet_curvature(surface, {});
  check::curvature(surface, jet);
  for (std::size_t v = 0; v < surface.positions.size(); ++v) {
    const double radius = surface.positions[v].norm();
    EXPECT_LT(jet[v].k1 * radius, -.5);
    EXPECT_GT(jet[v].k1 * radius, -1.5);
    EXPECT_LT(jet[v].k2 * radius, -.3);
  }
}

// Polygonal caps, creased; walls of quads. Axis z.
PolygonMesh creased_cylinder(int sides, int rows) {
  PolygonMesh mesh;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i < sides; ++i) {
      const double a = 2 * pi * i / sides;
      mesh.positions.emplace_back(std::cos(a), std::sin(a), .25 * j);
    }
  }
  const auto at = [sides](int i, int j) { return j * sides + i % sides; };
  std::vector<int> bottom, top;
  for (int i = 0; i < sides; ++i) {
    for (int j = 0; j < rows; ++j) {
      shapes::add_face(mesh, {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
    bottom.push_back(at(sides - i, 0));
    top.push_back(at(i, rows));
    for (const int j : {0, rows}) {
      mesh.edge_vertices.push_back({at(i, j), at(i + 1, j)});
      mesh.edge_sharpness.push_back(10);
    }
  }
  shapes::add_face(mesh, bottom);
  shapes::add_face(mesh, top);
  return mesh;
}

TEST(ControlJets, OneSidedAtCreases) {
  for (const int level : {1, 2, 3}) {
    const Surface surface = refined(creased_cylinder(48, 6), at_level(level));
    const Curvature jet = jet_curvature(surface, {});
    int caps = 0, walls = 0;
    for (std::size_t v = 0; v < surface.positions.size(); ++v) {
      const Vec3& p = surface.positions[v];
      if (std::abs(surface.normals[v].z()) > .5) {
        ++caps;
        EXPECT_NEAR(jet[v].k1, 0, 1e-9);
      } else {
        ++walls;
        EXPECT_NEAR(jet[v].k1 * std::hypot(p.x(), p.y()), -1, .06) << level << " " << p.transpose();
        EXPECT_NEAR(jet[v].k2, 0, .03);
        EXPECT_NEAR(jet[v].w2.cross(Vec3::UnitZ()).norm(), 0, .05);
      }
    }
    EXPECT_GT(caps, 96);
    EXPECT_GT(walls, 48 * 7);
  }
}

// The largest jump of the shape operator along an edge, signs of the sheets taken into account.
double largest_jump(const Surface& surface, const Curvature& c) {
  double largest = 0;
  for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t) {
    std::array<Mat3, 3> s;
    for (int k = 0; k < 3; ++k) {
      s[index(k)] = surface.corner_sign(t, k) *
                    shape_operator(c, index(surface.triangles[index(t)][index(k)]));
    }
    for (int k = 0; k < 3; ++k) {
      largest = std::max(largest, (s[index(k)] - s[index(next_corner(k))]).norm());
    }
  }
  return largest;
}

TEST(ControlJets, ContinuousAcrossFacesAndSheets) {
  const std::vector<PolygonMesh> cages{irregular_ellipsoid({1, .75, .5}),
                                       shapes::klein_mesh(24, 16), shapes::uv_sphere_mesh(1, 5, 5)};
  for (const PolygonMesh& cage : cages) {
    const Surface coarse = refined(cage, at_level(3)), fine = refined(cage, at_level(4));
    const double jump = largest_jump(coarse, jet_curvature(coarse, {}));
    EXPECT_LT(largest_jump(fine, jet_curvature(fine, {})), .65 * jump);
  }
}

TEST(ControlJets, SheetsOfADoubleCoverAreOneSurface) {
  // A regular mesh: the limit's own curvature is that of a spline.
  const Surface surface = refined(shapes::klein_mesh(96, 64), at_level(1));
  const Curvature jet = jet_curvature(surface, {});
  double largest = 0, size = 0;
  for (std::size_t v = 0; v < surface.positions.size(); ++v) {
    const Mat3 exact = shape_operator(surface.curvature, v);
    largest = std::max(largest, (shape_operator(jet, v) - exact).norm());
    size = std::max(size, exact.norm());
  }
  EXPECT_LT(largest, .15 * size);  // support that ended where the sheets meet: .2
}

TEST(ControlJets, MoreRingsAreSmoother) {
  PolygonMesh mesh = shapes::icosphere_mesh(1, 3);
  for (Vec3& p : mesh.positions) p *= 1 + .02 * std::sin(90 * p.x() + 50 * p.y() + 70 * p.z());
  const Surface surface = refined(mesh, at_level(2));
  double last = std::numeric_limits<double>::infinity();
  for (const int rings : {1, 2, 3, 5}) {
    const Curvature jet = jet_curvature(surface, {rings, 1});
    check::curvature(surface, jet);
    const double jump = largest_jump(surface, jet);
    EXPECT_LT(jump, last) << rings;
    last = jump;
  }
}

TEST(ControlJets, ObjectsDoNotDisturbEachOther) {
  std::vector<PolygonMesh> meshes{shapes::klein_mesh(12, 8), shapes::icosphere_mesh(1, 2),
                                  shapes::cube(), shapes::icosahedron()};
  meshes[1].scheme = Scheme::polygons;
  meshes[2].level = 1;
  meshes[3].level = 0;
  Counts report;
  const Surface all = refined(meshes, at_level(3), report);
  const Curvature one = jet_curvature(all, {3, 1}), two = jet_curvature(all, {3, 2});
  EXPECT_TRUE(one == two);
  Curvature alone;
  for (const PolygonMesh& mesh : meshes) {
    shapes::append(alone, jet_curvature(refined(mesh, at_level(3)), {}));
  }
  EXPECT_TRUE(one == alone);
}

TEST(ControlJets, HolesAndOddFaces) {
  PolygonMesh mesh = shapes::joined(creased_cylinder(5, 2), shapes::tetrahedron());
  mesh.scheme = Scheme::catmull_clark;
  mesh.hole_faces = {0, 3};
  for (const int level : {1, 2, 3}) {
    const Surface surface = refined(mesh, at_level(level));
    check::curvature(surface, jet_curvature(surface, {}));
  }
}

}  // namespace
}  // namespace illustrate
