#include "contour/shape/curvature_curves.h"

#include <gtest/gtest.h>

#include "tests/cpp/cameras.h"
#include "tests/cpp/contour/curvature_curve_checks.h"
#include "tests/cpp/shapes.h"

namespace illustrate {
namespace {

using curvature_lines::check_curves;
using curvature_lines::crest;
using curvature_lines::everything;
using curvature_lines::ridges_and_valleys;
using curvature_lines::wave;

constexpr double torus_core = 1, torus_tube = 0.4;

FreeLines curves_of(const Surface& surface, const Camera& camera,
                    const CurvatureCurveOptions& options) {
  const CurvatureDerivative derivative = curvature_derivative(surface, surface.curvature, 1);
  return curvature_curves(surface, derivative, {}, camera, options);
}

// --- ridges and valleys --------------------------------------------------------------------------

Surface with_jets(Surface surface) {
  surface.curvature = jet_curvature(surface, {});
  return surface;
}

Surface wave_surface(int n) {
  Surface surface =
      shapes::plain_surface(shapes::height_field(n, n, [](double x, double) { return wave(x); }));
  for (std::size_t v = 0; v < surface.positions.size(); ++v) {
    const double x = surface.positions[v].x();
    surface.normals[v] = Vec3(0.4 * std::sin(4 * (x - crest)), 0, 1).normalized();
  }
  return with_jets(std::move(surface));
}

struct WaveLines {
  int ridges = 0, valleys = 0;
  double off = 0;  // the farthest from the crests and troughs
};

WaveLines wave_lines(int n, const Vec3& direction) {
  const Surface surface = wave_surface(n);
  const FreeLines found =
      curves_of(surface, cameras::orthographic(direction, 2), ridges_and_valleys(3));
  check_curves(surface, found);
  WaveLines result;
  for (std::size_t c = 0; c < found.lines.curves.size(); ++c) {
    const Span<const ZeroPoint> line = found.lines.curves[c];
    ++(line.front().ridge ? result.ridges : result.valleys);
    for (const ZeroPoint& p : line) {
      EXPECT_EQ(p.ridge, line.front().ridge);
      if (std::abs(p.position.y()) > 0.8) continue;
      const double half_waves = 4 * (p.position.x() - crest) / pi;
      result.off = std::max(result.off, std::abs(half_waves - std::round(half_waves)) * pi / 4);
    }
    EXPECT_NEAR((line.back().position - line.front().position).norm(), 2, 1e-2) << "side to side";
  }
  return result;
}

// One crest, and a trough on either side of it.
TEST(RidgesAndValleys, OfAWaveAreItsCrestsAndTroughs) {
  const WaveLines found = wave_lines(80, Vec3(0.1, 0.2, 1));
  EXPECT_EQ(found.ridges, 1);
  EXPECT_EQ(found.valleys, 2);
  EXPECT_LT(found.off, 0.01);
  EXPECT_LT(found.off, 0.6 * wave_lines(20, Vec3(0.1, 0.2, 1)).off);
}

TEST(RidgesAndValleys, AreEachOtherFromBehind) {
  const WaveLines before = wave_lines(40, Vec3(0.1, 0.2, 1));
  const WaveLines behind = wave_lines(40, Vec3(0.1, 0.2, -1));
  EXPECT_EQ(before.ridges, behind.valleys);
  EXPECT_EQ(before.valleys, behind.ridges);
}

Surface ellipsoid(const Vec3& axes, int level) {
  PolygonMesh mesh = shapes::icosphere_mesh(1, level);
  for (Vec3& p : mesh.positions) p = p.cwiseProduct(axes);
  Surface surface = shapes::plain_surface(mesh);
  for (std::size_t v = 0; v < surface.positions.size(); ++v) {
    surface.normals[v] = surface.positions[v].cwiseQuotient(axes.cwiseProduct(axes)).normalized();
  }
  return with_jets(std::move(surface));
}

// The farthest that a ridge of the ellipsoid strays from the planes of symmetry.
double farthest_from_symmetry(int level) {
  const Surface surface = ellipsoid(Vec3(3, 2, 1), level);
  const Camera camera = cameras::orthographic(Vec3(1, 2, 3), 4);
  const FreeLines found = curves_of(surface, camera, ridges_and_valleys(2));
  check_curves(surface, found);
  double farthest = 0;
  bool rim = false;
  for (std::size_t c = 0; c < found.lines.curves.size(); ++c) {
    double height = 0;
    for (const ZeroPoint& p : found.lines.curves[c]) {
      EXPECT_TRUE(p.ridge || p.unseen) << "an ellipsoid has no valleys";
      farthest = std::max(farthest, p.position.cwiseAbs().minCoeff());
      height = std::max(height, std::abs(p.position.z()));
    }
    rim = rim || (found.lines.closed[c] && height < 0.1);
  }
  EXPECT_TRUE(rim) << "the rim in the plane of the two longer axes is one closed line";
  return farthest;
}

TEST(RidgesAndValleys, OfAnEllipsoidLieInItsPlanesOfSymmetry) {
  const double coarse = farthest_from_symmetry(4), fine = farthest_from_symmetry(5);
  EXPECT_LT(coarse, 0.06);
  EXPECT_LT(fine, 0.6 * coarse);
}

TEST(CurvatureCurves, ASphereHasNone) {
  const Surface sphere = shapes::sphere_surface(1, 4);
  const Camera camera = cameras::perspective(Vec3(3, 1, 2), Vec3::Zero());
  EXPECT_TRUE(curves_of(sphere, camera, everything(1e-3)).lines.curves.empty());
  EXPECT_TRUE(curves_of(with_jets(sphere), camera, everything(1)).lines.curves.empty());
}

TEST(CurvatureCurves, APlaneHasNone) {
  const Surface plane = with_jets(shapes::plain_surface(shapes::plane(20, 20)));
  const Camera camera = cameras::perspective(Vec3(1, 1, 2), Vec3::Zero());
  EXPECT_TRUE(curves_of(plane, camera, everything(1e-3)).lines.curves.empty());
}

// --- suggestive contours -------------------------------------------------------------------------

// The radial curvature of the torus, positive where it bulges, at angles u round the axis and v
// round the tube; `step` from there towards the eye.
double radial_curvature(double u, double v, const Camera& camera, double step) {
  const auto frame = [](double a, double b, Vec3& around, Vec3& up) {
    const Vec3 out{std::cos(a), std::sin(a), 0};
    around = Vec3(-std::sin(a), std::cos(a), 0);
    up = -out * std::sin(b) + Vec3::UnitZ() * std::cos(b);
  };
  const auto at = [&](double a, double b, double& x, double& y) {
    Vec3 around, up;
    frame(a, b, around, up);
    const Vec3 view = camera.to_eye(shapes::torus_point(torus_core, torus_tube, a, b));
    x = view.dot(around);
    y = view.dot(up);
    const double length = std::hypot(x, y);
    x /= length;
    y /= length;
  };
  double x, y;
  at(u, v, x, y);
  const double rho = torus_core + torus_tube * std::cos(v);
  const double a = u + step * x / rho, b = v + step * y / torus_tube;
  at(a, b, x, y);
  const double k = std::cos(b) / (torus_core + torus_tube * std::cos(b));
  return k * x * x + y * y / torus_tube;
}

double worst_radial_curvature(int n, const Camera& camera) {
  const Surface torus = shapes::torus_surface(torus_core, torus_tube, 2 * n, n);
  CurvatureCurveOptions options;
  options.suggestive_contours = true;
  options.suggestive_threshold = 3;
  const FreeLines found = curves_of(torus, camera, options);
  check_curves(torus, found);
  EXPECT_FALSE(found.lines.curves.empty());
  double worst = 0;
  for (const ZeroPoint& p : found.lines.curves.values) {
    const double u = std::atan2(p.position.y(), p.position.x());
    const double rho = p.position.head<2>().norm();
    const double v = std::atan2(p.position.z(), rho - torus_core);
    worst = std::max(worst, std::abs(radial_curvature(u, v, camera, 0)));
    EXPECT_GT(radial_curvature(u, v, camera, 0.02), radial_curvature(u, v, camera, -0.02));
    const Vec3 normal(std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v));
    EXPECT_GT(normal.dot(camera.to_eye(p.position)), -0.01) << "only the front is seen";
  }
  return worst;
}

TEST(SuggestiveContours, OfATorusAreWhereTheRadialCurvatureGrowsThroughZero) {
  for (const Camera& camera : {cameras::orthographic(Vec3(1, 0, 0.8), 2),
                               cameras::perspective(Vec3(3, 1, 2), Vec3::Zero())}) {
    const double coarse = worst_radial_curvature(16, camera);
    const double fine = worst_radial_curvature(128, camera);
    EXPECT_LT(fine, 0.03 / torus_tube);
    EXPECT_LT(fine, coarse / 2);
  }
}

TEST(SuggestiveContours, WeakerOnesAreLeftOut) {
  const Surface torus = shapes::torus_surface(torus_core, torus_tube, 128, 64);
  const Camera camera = cameras::perspective(Vec3(3, 1, 2), Vec3::Zero());
  std::size_t previous = 1000000;
  for (const double threshold : {3.0, 10.0, 20.0, 1000.0}) {
    CurvatureCurveOptions options;
    options.suggestive_contours = true;
    options.suggestive_threshold = threshold;
    const std::size_t points = curves_of(torus, camera, options).lines.curves.values.size();
    EXPECT_LT(points, previous);
    previous = points;
  }
  EXPECT_EQ(previous, 0U);
}

}  // namespace
}  // namespace illustrate
