#include "contour/curvature_curves.h"

#include <gtest/gtest.h>

#include "cameras.h"
#include "check_graph.h"
#include "core/errors.h"
#include "pipeline/draw.h"
#include "shapes.h"

namespace illustrate {
namespace {

using shapes::pi;

constexpr double torus_core = 1, torus_tube = 0.4;

CurvatureCurves curves_of(const Surface& surface, const Camera& camera,
                          const CurvatureCurveOptions& options) {
  const CurvatureDerivative derivative = curvature_derivative(surface, surface.curvature, 1);
  return curvature_curves(surface, derivative, {}, camera, options);
}

CurvatureCurveOptions everything(double threshold) {
  CurvatureCurveOptions options;
  options.suggestive_contours = options.ridges = options.valleys = true;
  options.suggestive_threshold = options.ridge_threshold = options.valley_threshold = threshold;
  return options;
}

CurvatureCurveOptions ridges_and_valleys(double threshold) {
  CurvatureCurveOptions options = everything(threshold);
  options.suggestive_contours = false;
  return options;
}

// Segments lie in the triangles that they name, and points where they say.
void check_curves(const Surface& surface, const CurvatureCurves& found) {
  ASSERT_EQ(found.suggestive.size(), found.lines.curves.size());
  ASSERT_EQ(found.lines.closed.size(), found.lines.curves.size());
  for (const ZeroPoint& p : found.lines.curves.values) {
    EXPECT_LT((position_at(surface, p.on) - p.position).norm(), 1e-9 * surface.diagonal);
    EXPECT_GE(p.strength, 0);
  }
}

// --- the derivative of curvature -----------------------------------------------------------------

// On a torus only C(tube, around, around) is not 0: R sin v / (r (R + r cos v)^2).
double worst_cubic(int n) {
  const Surface torus = shapes::torus_surface(torus_core, torus_tube, 2 * n, n);
  const CurvatureDerivative found = curvature_derivative(torus, torus.curvature, 1);
  double worst = 0;
  for (std::size_t i = 0; i < torus.positions.size(); ++i) {
    const double v = 2 * pi * static_cast<double>(i % idx(n)) / n;
    const double rho = torus_core + torus_tube * std::cos(v);
    const double exact = torus_core * std::sin(v) / (torus_tube * rho * rho);
    const Vec3& p = torus.positions[i];
    const Vec3 around = Vec3(-p.y(), p.x(), 0).normalized();
    const Vec3 up = torus.normals[i].cross(around);
    const Vec3 &w1 = found.curvature.w1[i], &w2 = found.curvature.w2[i];
    for (const double angle : {0.0, 0.7, 1.5, 2.6}) {
      const Vec3 t = std::cos(angle) * up + std::sin(angle) * around;
      const double expected = 3 * std::cos(angle) * std::sin(angle) * std::sin(angle) * exact;
      const double value = along(found.cubics[i], t.dot(w1), t.dot(w2));
      worst = std::max(worst, std::abs(value - expected));
    }
  }
  return worst;
}

TEST(CurvatureDerivative, OfATorusIsThatOfTheFormula) {
  const double largest = torus_core / (torus_tube * 0.36);  // a bound of the exact values
  EXPECT_LT(worst_cubic(96), 0.02 * largest);
  EXPECT_LT(worst_cubic(96), worst_cubic(24) / 2);
}

TEST(CurvatureDerivative, IsTheSameWithAnyNumberOfThreads) {
  const Surface torus = shapes::torus_surface(torus_core, torus_tube, 96, 48);
  const CurvatureDerivative one = curvature_derivative(torus, torus.curvature, 1);
  const CurvatureDerivative four = curvature_derivative(torus, torus.curvature, 4);
  EXPECT_EQ(one.cubics, four.cubics);
  EXPECT_EQ(one.second, four.second);
  EXPECT_EQ(one.curvature.k1, four.curvature.k1);
}

TEST(CurvatureDerivative, NoSurfaceHasNone) {
  EXPECT_TRUE(curvature_derivative(Surface(), Curvature(), 1).cubics.empty());
}

// --- ridges and valleys --------------------------------------------------------------------------

Surface with_jets(Surface surface) {
  surface.curvature = jet_curvature(surface, {});
  return surface;
}

constexpr double crest = 0.07;  // not where a row of vertices is

double wave(double x) { return 0.1 * std::cos(4 * (x - crest)); }

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
  const CurvatureCurves found =
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
  const CurvatureCurves found = curves_of(surface, camera, ridges_and_valleys(2));
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
  const CurvatureCurves found = curves_of(torus, camera, options);
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

// --- sheets, options, the drawing ----------------------------------------------------------------

MeshPointer pointer(PolygonMesh mesh) {
  return std::make_shared<const PolygonMesh>(std::move(mesh));
}

std::shared_ptr<const Prepared> prepared(const std::vector<PolygonMesh>& meshes) {
  std::vector<MeshPointer> pointers;
  for (const PolygonMesh& mesh : meshes) pointers.push_back(pointer(mesh));
  PrepareOptions options;
  options.field = false;
  options.surface.triangle_budget = 40000;
  return prepare(pointers, options);
}

// A point of the Moebius band of radius 1 and width 1, and how far p stands off from it.
Vec3 off_the_band(const Vec3& p) {
  const double u = std::atan2(p.y(), p.x());
  const Vec3 core(std::cos(u), std::sin(u), 0);
  const Vec3 across = std::cos(u / 2) * core + std::sin(u / 2) * Vec3::UnitZ();
  return p - core - (p - core).dot(across) * across;
}

// Bent to a wave across: a crest on one side of the middle, a trough on the other, which are one
// line that runs round the band twice.
PolygonMesh wavy_moebius(int m, int n) {
  PolygonMesh mesh = shapes::moebius_mesh(m, n);
  for (int i = 0; i < m; ++i) {
    for (int j = 0; j <= n; ++j) {
      const double u = 2 * pi * i / m, s = static_cast<double>(j) / n - 0.5;
      const Vec3 normal(-std::sin(u / 2) * std::cos(u), -std::sin(u / 2) * std::sin(u),
                        std::cos(u / 2));
      mesh.positions[idx(i * (n + 1) + j)] += 0.12 * std::sin(2 * pi * s) * normal;
    }
  }
  return mesh;
}

TEST(RidgesAndValleys, OfAMoebiusBandAreToldApartByTheViewersSide) {
  const auto band = prepared({wavy_moebius(64, 20)});
  const Surface& surface = band->surface();
  const Camera camera = cameras::perspective(Vec3(4, 3, 4), Vec3::Zero());
  const CurvatureCurves found = curvature_curves(
      surface, band->curvature_derivative(), band->intersections(), camera, ridges_and_valleys(9));
  check_curves(surface, found);
  ASSERT_EQ(found.lines.curves.size(), 1U) << "through the seam, twice";
  EXPECT_TRUE(found.lines.closed[0]);
  std::array<int, 2> checked{0, 0};
  int on_seam = 0;
  for (const ZeroPoint& p : found.lines.curves[0]) {
    EXPECT_FALSE(p.unseen) << "no side of it is the outside";
    on_seam += surface.flips[idx(p.on.triangle)] != 0;
    const Vec3 view = camera.to_eye(p.position).normalized();
    if (std::abs(normal_at(surface, p.on).dot(view)) < 0.2) continue;
    EXPECT_EQ(p.ridge, off_the_band(p.position).dot(view) > 0);
    ++checked[p.ridge];
  }
  EXPECT_GT(on_seam, 0);
  EXPECT_GT(checked[0], 50);
  EXPECT_GT(checked[1], 50);
}

PolygonMesh bumpy_sphere() {
  PolygonMesh mesh = shapes::icosphere_mesh(1, 3);
  for (Vec3& p : mesh.positions) {
    p *= 1 + 0.18 * std::sin(4 * p.x() + 1) * std::sin(5 * p.y()) * std::sin(4 * p.z() + 2);
  }
  return mesh;
}

DrawOptions drawing_of(const CurvatureCurveOptions& curves) {
  DrawOptions options;
  options.hatching = false;
  options.curvature_curves = curves;
  return options;
}

double visible_length(const Drawing& drawing, Kind kind) {
  double length = 0;
  for (std::size_t s = 0; s < drawing.kinds.size(); ++s) {
    if (drawing.kinds[s] != kind) continue;
    for (int i = drawing.offsets[s] + 1; i < drawing.offsets[s + 1]; ++i) {
      length += (drawing.image[idx(i)] - drawing.image[idx(i - 1)]).norm();
    }
    const int first = drawing.offsets[s], last = drawing.offsets[s + 1] - 1;
    if (drawing.closed[s]) length += (drawing.image[idx(first)] - drawing.image[idx(last)]).norm();
  }
  return length;
}

TEST(CurvatureLines, ChangeNothingElseAndObeyTheRules) {
  const auto sphere = prepared({bumpy_sphere()});
  for (const Vec3& eye : {Vec3(4, 1, 2), Vec3(-1, 3, -3), Vec3(0.5, -4, 1)}) {
    const Camera camera = cameras::perspective(eye, Vec3::Zero());
    const DrawResult without = draw(*sphere, camera, drawing_of({}));
    const DrawResult with = draw(*sphere, camera, drawing_of(everything(8)));
    check_graph(with.graph);
    EXPECT_NEAR(visible_length(with.drawing, Kind::silhouette),
                visible_length(without.drawing, Kind::silhouette), 1);
    for (const Kind kind : {Kind::suggestive, Kind::ridge, Kind::valley}) {
      EXPECT_GT(visible_length(with.drawing, kind), 20);
      EXPECT_EQ(visible_length(without.drawing, kind), 0);
    }
    for (const GraphNode& node : with.graph.nodes) {
      if (node.kind != NodeKind::crossing) continue;
      EXPECT_FALSE(is_curvature_line(with.graph.arcs[idx(node.arcs[0])].kind)) << "hides nothing";
    }
  }
}

TEST(CurvatureLines, ObeyTheRulesOnSurfacesWithoutAnOutside) {
  const auto scene = prepared(
      {shapes::klein_mesh(24, 16), shapes::moved(wavy_moebius(64, 20), Vec3(0.3, 0.2, 0.4))});
  for (const Vec3& eye : {Vec3(6, 5, 4), Vec3(-4, 3, -6)}) {
    const Camera camera = cameras::perspective(eye, Vec3::Zero());
    const DrawResult result = draw(*scene, camera, drawing_of(everything(2)));
    check_graph(result.graph);
    EXPECT_GT(visible_length(result.drawing, Kind::ridge), 20);
    EXPECT_GT(visible_length(result.drawing, Kind::valley), 20);
  }
}

// The same object without its lid shows its inside.
TEST(CurvatureLines, ShowOnBacksThatCanBeSeen) {
  const auto of = [](const PolygonMesh& mesh) {
    const auto scene = prepared({mesh});
    DrawOptions options = drawing_of(everything(8));
    options.stroke.hidden_lines = {{1, 100}};
    const Camera camera = cameras::perspective(Vec3(4, 1, 2), Vec3::Zero());
    const DrawResult result = draw(*scene, camera, options);
    std::array<int, 2> facing{0, 0};
    for (std::size_t a = 0; a < result.graph.arcs.size(); ++a) {
      if (!is_curvature_line(result.graph.arcs[a].kind)) continue;
      const Span<const CurvePoint> points = result.graph.points[a];
      const CurvePoint& p = points[points.size() / 2];
      const Vec3 view = camera.to_eye(p.position).normalized();
      const double cosine = normal_at(scene->surface(), p.on).dot(view);
      if (std::abs(cosine) > 0.1) ++facing[cosine > 0];
    }
    return facing;
  };
  PolygonMesh closed = bumpy_sphere(), open = closed;
  open.face_sizes.pop_back();
  open.corner_vertices.resize(open.corner_vertices.size() - 3);
  EXPECT_GT(of(closed)[1], 5);
  EXPECT_EQ(of(closed)[0], 0);
  EXPECT_GT(of(open)[0], 5);
}

TEST(CurvatureLines, KindsAreDrawnOnlyWhenAskedFor) {
  const auto sphere = prepared({bumpy_sphere()});
  const Camera camera = cameras::perspective(Vec3(4, 1, 2), Vec3::Zero());
  CurvatureCurveOptions options = everything(8);
  options.suggestive_contours = options.valleys = false;
  const DrawResult ridges = draw(*sphere, camera, drawing_of(options));
  EXPECT_GT(visible_length(ridges.drawing, Kind::ridge), 20);
  EXPECT_EQ(visible_length(ridges.drawing, Kind::valley), 0);
  EXPECT_EQ(visible_length(ridges.drawing, Kind::suggestive), 0);
}

// Arcs of a kind that end at each joint.
std::vector<int> joints_of(const LabelledGraph& graph, Kind kind) {
  std::vector<int> ends(graph.nodes.size(), 0);
  for (const GraphArc& arc : graph.arcs) {
    if (arc.kind != kind || arc.start_node == none) continue;
    for (const int node : {arc.start_node, arc.end_node}) {
      ends[idx(node)] += graph.nodes[idx(node)].kind == NodeKind::joint;
    }
  }
  return ends;
}

// A wave with its crest along y, and a flat square that cuts through it across.
TEST(CurvatureLines, AreCutByBoundariesAndIntersections) {
  PolygonMesh sheet =
      shapes::height_field(20, 20, [](double x, double) { return 0.3 * std::cos(3 * x); });
  PolygonMesh wall = shapes::plane(1, 1);
  for (Vec3& p : wall.positions) p = Vec3(1.3 * p.x(), 0.05, p.y());
  wall.scheme = Scheme::polygons;
  const auto scene = prepared({sheet, wall});
  const Camera camera = cameras::orthographic(Vec3(0.1, 0.2, 1), 2);
  CurvatureCurveOptions options;
  options.ridges = true;
  options.ridge_threshold = 4;
  const DrawResult result = draw(*scene, camera, drawing_of(options));
  check_graph(result.graph);
  const std::vector<int> ends = joints_of(result.graph, Kind::ridge);
  EXPECT_EQ(std::count(ends.begin(), ends.end(), 2), 1) << "runs on behind the wall";
  EXPECT_EQ(std::count(ends.begin(), ends.end(), 1), 2) << "ends on the boundary, twice";
}

// A wave whose crest and two troughs bend away from the viewer: behind the silhouette a ridge is a
// valley, and a valley a ridge.
TEST(CurvatureLines, AreCutBySilhouettes) {
  const auto scene = prepared(
      {shapes::height_field(40, 40, [](double x, double y) { return 2 * wave(x) - 0.8 * y * y; })});
  const Camera camera = cameras::orthographic(Vec3(0.1, 1, 0.6), 2);
  const DrawResult result = draw(*scene, camera, drawing_of(ridges_and_valleys(4)));
  check_graph(result.graph);
  const std::vector<int> silhouettes = joints_of(result.graph, Kind::silhouette);
  const std::vector<int> ridges = joints_of(result.graph, Kind::ridge);
  const std::vector<int> valleys = joints_of(result.graph, Kind::valley);
  int passages = 0;
  for (std::size_t n = 0; n < ridges.size(); ++n) {
    passages += silhouettes[n] == 2 && ridges[n] == 1 && valleys[n] == 1;
  }
  EXPECT_EQ(passages, 3);
}

TEST(CurvatureLines, ThresholdsAreChecked) {
  for (double CurvatureCurveOptions::*field :
       {&CurvatureCurveOptions::suggestive_threshold, &CurvatureCurveOptions::ridge_threshold,
        &CurvatureCurveOptions::valley_threshold}) {
    for (const double wrong : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
      CurvatureCurveOptions options;
      options.*field = wrong;
      EXPECT_THROW(validate(options), InvalidInput);
    }
  }
}

}  // namespace
}  // namespace illustrate
