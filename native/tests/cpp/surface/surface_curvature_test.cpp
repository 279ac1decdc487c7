#include <gtest/gtest.h>

#include <functional>

#include "surface/jets/curvature.h"
#include "tests/cpp/surface_checks.h"

namespace illustrate {
namespace {

using namespace surface_checks;

// rms of the relative error over both curvatures.
double jet_error(const Surface& surface,
                 const std::function<std::pair<double, double>(const Vec3&)>& exact) {
  const Curvature jet = jet_curvature(surface, {});
  check::curvature(surface, jet);
  double off = 0, size = 0;
  for (std::size_t v = 0; v < surface.positions.size(); ++v) {
    const auto [k1, k2] = exact(surface.positions[v]);
    off += std::pow(jet[v].k1 - k1, 2) + std::pow(jet[v].k2 - k2, 2);
    size += k1 * k1 + k2 * k2;
  }
  return std::sqrt(off / size);
}

// Of the ellipsoid with half axes a, at p on it, with outward normal.
std::pair<double, double> ellipsoid_curvature(const Vec3& a, const Vec3& p) {
  const Vec3 g = p.cwiseQuotient(a.cwiseProduct(a));
  const double h = 1 / g.norm();
  const double gauss = std::pow(h, 4) / std::pow(a.prod(), 2);
  const double mean =
      -std::pow(h, 3) * (a.squaredNorm() - p.squaredNorm()) / (2 * std::pow(a.prod(), 2));
  const double root = std::sqrt(std::max(0., mean * mean - gauss));
  return {mean - root, mean + root};
}

TEST(Jet, SphereAndEllipsoid) {
  const Surface sphere = refined(shapes::icosphere_mesh(1, 4), at_level(0, Scheme::polygons));
  EXPECT_LT(jet_error(sphere, [](const Vec3&) { return std::make_pair(-1., -1.); }), 5e-4);
  const Vec3 axes(1, .75, .5);
  double last = 0;
  for (const int level : {3, 4, 5}) {
    PolygonMesh mesh = shapes::icosphere_mesh(1, level);
    for (Vec3& p : mesh.positions) p = p.cwiseProduct(axes);
    const double error = jet_error(refined(mesh, at_level(0, Scheme::polygons)),
                                   [&](const Vec3& p) { return ellipsoid_curvature(axes, p); });
    if (last > 0) {
      EXPECT_LT(error, last / 8);
    }
    last = error;
  }
  EXPECT_LT(last, 1e-4);
}

TEST(Jet, DirectionsOfPolygonsAreThoseOfTheSmoothSurface) {
  // A monkey saddle on a sheared grid, whose angle-weighted normals are off.
  PolygonMesh mesh = shapes::plane(40, 40);
  for (Vec3& p : mesh.positions) {
    const double x = .8 * p.x() + .2 * std::sin(5 * p.y()), y = .8 * p.y();
    p = Vec3(x, y, x * x * x - 3 * x * y * y);
  }
  const Surface surface = refined(mesh, at_level(0, Scheme::polygons));
  const Curvature jet = jet_curvature(surface, {});
  double worst = 0, worst_normal = 0;
  for (std::size_t v = 0; v < surface.positions.size(); ++v) {
    const Vec3& p = surface.positions[v];
    if (std::abs(p.x()) > .5 || std::abs(p.y()) > .5) continue;
    const Vec3 normal =
        Vec3(3 * (p.y() * p.y() - p.x() * p.x()), 6 * p.x() * p.y(), 1).normalized();
    worst_normal = std::max(worst_normal, (normal - surface.normals[v]).norm());
    worst = std::max({worst, std::abs(jet[v].w1.dot(normal)), std::abs(jet[v].w2.dot(normal))});
  }
  EXPECT_LT(worst, 1e-3);
  EXPECT_LT(worst, worst_normal / 3);
}

TEST(Jet, OneSidedAtCreasesAndBoundaries) {
  // Half a cylinder of radius 1 that ends in a flat floor along a crease.
  PolygonMesh mesh = shapes::height_field(24, 12, [](double, double) { return 0; });
  for (Vec3& p : mesh.positions) {
    if (p.x() > 0)
      p = Vec3(std::sin(p.x()), p.y(), .5 + std::cos(p.x()) - 1 + p.x() * 0);
    else
      p = Vec3(p.x(), p.y(), .5 + p.x());
  }
  for (int j = 0; j < 12; ++j) {
    mesh.edge_vertices.push_back({12 * 13 + j, 12 * 13 + j + 1});
    mesh.edge_sharpness.push_back(10);
  }
  const Surface surface = refined(mesh, at_level(0, Scheme::polygons));
  int flat = 0, round = 0;
  for (const Edge& e : surface.feature_edges) {
    const std::size_t v = index(e[0]);
    if (std::abs(surface.positions[v].x()) > 1e-9) continue;
    flat += std::abs(surface.curvature[v].k1) < 1e-6;
    round += std::abs(surface.curvature[v].k1 + 1) < .05;
  }
  EXPECT_GE(flat, 12);
  EXPECT_GE(round, 12);
}

TEST(Principal, SignAndOrder) {
  // z = x^2 - 2 y^2 with a sheared parametrisation: curvatures 2 and -4.
  const Vec3 du(1, 0, 0), dv(1, 1, 0), duu(0, 0, 2), duv(0, 0, 2), dvv(0, 0, -2);
  const PrincipalCurvature k = principal_curvature(du, dv, duu, duv, dvv, Vec3::UnitZ());
  EXPECT_NEAR(k.k1, -4, 1e-12);
  EXPECT_NEAR(k.k2, 2, 1e-12);
  EXPECT_NEAR(std::abs(k.w1.y()), 1, 1e-12);
  EXPECT_NEAR(std::abs(k.w2.x()), 1, 1e-12);
}

// The sign of what rounding leaves of it would tell of cusps.
TEST(PrincipalCurvature, OfWhatIsFlatIsExactlyNone) {
  LimitPoint p{Vec3::Zero(),       .1 * Vec3::UnitX(), .1 * Vec3::UnitY(),
               Vec3(.1, 0, 1e-12), Vec3(0, 0, -1e-12), Vec3(0, .1, -1e-12)};
  EXPECT_EQ(principal_curvature(p, Vec3::UnitZ()).k1, 0);
  EXPECT_EQ(principal_curvature(p, Vec3::UnitZ()).k2, 0);
  p.duu.z() = 1e-6;
  EXPECT_NEAR(principal_curvature(p, Vec3::UnitZ()).k1, 1e-4, 1e-12);
  EXPECT_EQ(principal_curvature(p, Vec3::UnitZ()).k2, 0);
}

}  // namespace
}  // namespace illustrate
