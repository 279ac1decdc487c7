#include <gtest/gtest.h>

#include "core/errors.h"
#include "pipeline/draw.h"
#include "tests/cpp/cameras.h"
#include "tests/cpp/check_graph.h"
#include "tests/cpp/contour/curvature_curve_checks.h"
#include "tests/cpp/shapes.h"

namespace illustrate {
namespace {

using curvature_lines::check_curves;
using curvature_lines::everything;
using curvature_lines::ridges_and_valleys;
using curvature_lines::wave;

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
  const FreeLines found = curvature_curves(surface, band->curvature_derivative(),
                                           band->intersections(), camera, ridges_and_valleys(9));
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

// Every drawing of this file obeys the rules.
DrawResult drawn(const Prepared& scene, const Camera& camera, const DrawOptions& options) {
  DrawResult result = draw(scene, camera, options);
  check_graph(result.graph);
  return result;
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
    const DrawResult without = drawn(*sphere, camera, drawing_of({}));
    const DrawResult with = drawn(*sphere, camera, drawing_of(everything(8)));
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
    const DrawResult result = drawn(*scene, camera, drawing_of(everything(2)));
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
    const DrawResult result = drawn(*scene, camera, options);
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
  const DrawResult ridges = drawn(*sphere, camera, drawing_of(options));
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
  const DrawResult result = drawn(*scene, camera, drawing_of(options));
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
  const DrawResult result = drawn(*scene, camera, drawing_of(ridges_and_valleys(4)));
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
