#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

#include "contour/shape/loose_curves.h"
#include "core/errors.h"
#include "pipeline/draw.h"
#include "tests/cpp/cameras.h"
#include "tests/cpp/shapes.h"

namespace illustrate {
namespace {

constexpr double px = 125;  // of a unit, in the view from the front

Camera front() { return cameras::orthographic(Vec3(0, -1, 0), 4); }

// Vertices one after another.
PolygonMesh wire(Points points, bool closed = false) {
  PolygonMesh mesh;
  mesh.positions = std::move(points);
  const int count = static_cast<int>(mesh.positions.size());
  for (int i = 0; i + 1 < count; ++i) mesh.loose_edges.push_back({i, i + 1});
  if (closed) mesh.loose_edges.push_back({count - 1, 0});
  return mesh;
}

std::shared_ptr<const Prepared> prepared(const std::vector<PolygonMesh>& meshes) {
  std::vector<MeshPointer> pointers;
  for (const PolygonMesh& mesh : meshes)
    pointers.push_back(std::make_shared<const PolygonMesh>(mesh));
  PrepareOptions options;
  options.field = false;
  return prepare(pointers, options);
}

DrawOptions options(bool loose) {
  DrawOptions options;
  options.hatching = false;
  options.loose_edges = loose;
  options.stroke.hidden_lines = {1, 99};
  options.stroke.taper_px = 0;
  return options;
}

// Length in the image of all loose strokes, by layers in front.
std::map<int, double> lengths(const Drawing& drawing) {
  std::map<int, double> found;
  for (std::size_t s = 0; s < drawing.kinds.size(); ++s) {
    if (drawing.kinds[s] != Kind::loose) continue;
    const int first = drawing.offsets[s], end = drawing.offsets[s + 1];
    for (int i = first; i + 1 < end; ++i)
      found[drawing.invisibility[s]] += (drawing.image[idx(i + 1)] - drawing.image[idx(i)]).norm();
    if (drawing.closed[s])
      found[drawing.invisibility[s]] +=
          (drawing.image[idx(end - 1)] - drawing.image[idx(first)]).norm();
  }
  return found;
}

std::map<int, double> lengths_before_ball(const PolygonMesh& mesh, const Camera& camera) {
  const PolygonMesh ball = shapes::icosphere_mesh(1, 4);
  const auto scene = prepared({ball, mesh});
  return lengths(draw(*scene, camera, options(true), {}).drawing);
}

CurveNetwork curves_of(const PolygonMesh& mesh) {
  return loose_curves({std::make_shared<const PolygonMesh>(mesh)}, {1});
}

TEST(LooseEdges, AreHiddenInsideABallFromWhereTheyPierceIt) {
  const auto found = lengths_before_ball(wire({Vec3(-3, 0, 0), Vec3(3, 0, 0)}), front());
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found.at(0), 4 * px, 2);
  EXPECT_NEAR(found.at(1), 2 * px, 2);
}

TEST(LooseEdges, AreHiddenBehindABallFromItsOutlineOn) {
  const PolygonMesh behind = wire({Vec3(-3, 2, 0.6), Vec3(-0.1, 2, 0.6), Vec3(3, 2, 0.6)});
  const auto found = lengths_before_ball(behind, front());
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found.at(0), (6 - 1.6) * px, 2);
  EXPECT_NEAR(found.at(2), 1.6 * px, 2);
}

TEST(LooseEdges, InFrontOfABallAreSeen) {
  const auto found = lengths_before_ball(wire({Vec3(-3, -2, 0), Vec3(3, -2, 0)}), front());
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found.at(0), 6 * px, 1e-6);
}

// A ring round a ball, as a planet has one: seen from above by 30 degrees.
TEST(LooseEdges, OfARingAreHiddenBehindItsPlanet) {
  Points points;
  const int count = 720;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * pi * i / count;
    points.emplace_back(1.5 * std::cos(angle), 1.5 * std::sin(angle), 0);
  }
  const Camera camera = cameras::orthographic(Vec3(0, -std::sqrt(3) / 2, 0.5), 4);
  const PolygonMesh ball = shapes::icosphere_mesh(1, 4);
  const auto scene = prepared({ball, wire(points, true)});
  const DrawResult result = draw(*scene, camera, options(true), {});
  int visible = 0;
  for (std::size_t s = 0; s < result.drawing.kinds.size(); ++s) {
    if (result.drawing.kinds[s] != Kind::loose || result.drawing.invisibility[s] != 0) continue;
    ++visible;
    EXPECT_FALSE(result.drawing.closed[s]);
  }
  EXPECT_EQ(visible, 1) << "one stroke, on through where the ring begins";
  // Where x^2 + (y / 2)^2 is 1 with x^2 + y^2 = 1.5^2: beyond, as the image has it.
  const double x = std::sqrt((1 - 1.5 * 1.5 / 4) / 0.75);
  for (std::size_t n = 0; n < result.graph.nodes.size(); ++n) {
    const GraphNode& node = result.graph.nodes[n];
    const bool is_cut = node.kind == NodeKind::joint && std::abs(node.image.x() - 500) < 1.4 * px;
    if (!is_cut) continue;
    EXPECT_NEAR(std::abs(node.image.x() - 500), x * px, 2);
  }
}

TEST(LooseEdges, AreDrawnOnlyWhenAskedFor) {
  const PolygonMesh ball = shapes::icosphere_mesh(1, 3),
                    string = wire({Vec3(-3, 0, 0), Vec3(3, 0, 0)});
  const auto scene = prepared({ball, string});
  const DrawResult without = draw(*scene, front(), options(false), {});
  EXPECT_TRUE(lengths(without.drawing).empty());
  const DrawResult with = draw(*scene, front(), options(true), {});
  for (std::size_t i = 0; i < without.drawing.image.size(); ++i)
    EXPECT_EQ(without.drawing.image[i], with.drawing.image[i]) << "the other lines are the same";
  DrawOptions styled = options(false);
  styled.styles.resize(2);
  styled.styles[1].loose_edges = true;
  EXPECT_EQ(lengths(draw(*scene, front(), styled, {}).drawing), lengths(with.drawing));
  for (bool ObjectStyle::*const hides : {&ObjectStyle::ignore, &ObjectStyle::occlude_only}) {
    styled.styles[1] = ObjectStyle{};
    styled.styles[1].loose_edges = styled.styles[1].*hides = true;
    EXPECT_TRUE(lengths(draw(*scene, front(), styled, {}).drawing).empty());
  }
}

TEST(LooseEdges, NeedNoSurface) {
  const auto scene = prepared({wire({Vec3(-1, 0, 0), Vec3(1, 0, 0), Vec3(1, 0, 1)}, true)});
  const DrawResult result = draw(*scene, front(), options(true), {});
  ASSERT_EQ(result.drawing.kinds.size(), 1u);
  EXPECT_TRUE(result.drawing.closed[0]);
  for (const SurfacePoint& on : result.drawing.on) EXPECT_EQ(on.triangle, none);
}

TEST(LooseEdges, EndAtTheNearPlane) {
  const Camera camera = cameras::perspective(Vec3(0, -5, 0), Vec3::Zero());
  const auto scene = prepared({wire({Vec3(0.1, 5, 0), Vec3(0.1, -9, 0.3)})});
  const DrawResult result = draw(*scene, camera, options(true), {});
  ASSERT_EQ(result.drawing.kinds.size(), 1u);
  for (const Vec2& image : result.drawing.image) EXPECT_TRUE(image.allFinite());
}

TEST(LooseEdges, ThinOutAtFreeEndsOnly) {
  const PolygonMesh ball = shapes::icosphere_mesh(1, 3);
  const auto scene = prepared({ball, wire({Vec3(-3, 0, 0), Vec3(0, 0, 0)})});
  DrawOptions tapered = options(true);
  tapered.stroke.hidden_lines.reset();
  tapered.stroke.taper_px = 10;
  const Drawing drawing = draw(*scene, front(), tapered, {}).drawing;
  for (std::size_t s = 0; s < drawing.kinds.size(); ++s) {
    if (drawing.kinds[s] != Kind::loose) continue;
    const float outer = drawing.widths[idx(drawing.offsets[s])];
    const float inner = drawing.widths[idx(drawing.offsets[s + 1] - 1)];
    EXPECT_LT(outer, 0.5f);
    EXPECT_FLOAT_EQ(inner, 1.4f) << "it goes on within the ball";
  }
}

TEST(LooseCurves, AreChainedUpToWhereThreeMeet) {
  PolygonMesh star = wire({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0)});
  for (const double z : {-1., 1.}) {
    star.positions.emplace_back(0, 0, z);
    star.loose_edges.push_back({0, static_cast<int>(star.positions.size()) - 1});
  }
  const CurveNetwork curves = curves_of(star);
  ASSERT_EQ(curves.strands.size(), 3u);
  EXPECT_EQ(curves.points.values.size(), 7u);
  int joints = 0;
  for (const NetworkNode& node : curves.nodes) joints += node.kind == NodeKind::joint;
  EXPECT_EQ(curves.nodes.size(), 4u);
  EXPECT_EQ(joints, 1);
}

TEST(LooseCurves, RootsOnAFaceAreNoFreeEnds) {
  PolygonMesh grass = shapes::plane(2, 2);
  grass.positions.push_back(grass.positions[4] + Vec3(0, 0, 1));
  grass.loose_edges = {{4, static_cast<int>(grass.positions.size()) - 1}};
  const CurveNetwork curves = curves_of(grass);
  ASSERT_EQ(curves.nodes.size(), 2u);
  EXPECT_EQ(curves.nodes[0].kind, NodeKind::joint);
  EXPECT_EQ(curves.nodes[1].kind, NodeKind::end);
}

TEST(LooseCurves, LeaveOutWhatIsNoEdge) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  PolygonMesh mesh = wire({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 0, 0), Vec3(nan, 0, 0)});
  mesh.loose_edges.push_back({1, 0});
  mesh.loose_edges.push_back({0, 0});
  const CurveNetwork curves = curves_of(mesh);
  ASSERT_EQ(curves.strands.size(), 1u);
  EXPECT_EQ(curves.points.values.size(), 2u);
  mesh.loose_edges.push_back({0, 4});
  EXPECT_THROW(validate(mesh), InvalidInput);
}

}  // namespace
}  // namespace illustrate
