#include "tone/light_contours.h"

#include <gtest/gtest.h>

#include "contour/shape/plane_section.h"
#include "pipeline/draw.h"
#include "surface/locate.h"
#include "tests/cpp/cameras.h"
#include "tests/cpp/check_graph.h"
#include "tests/cpp/shapes.h"
#include "tests/cpp/tone/sun.h"

namespace illustrate {
namespace {

std::shared_ptr<const Prepared> prepared(const std::vector<PolygonMesh>& meshes, int level) {
  std::vector<MeshPointer> pointers;
  for (const PolygonMesh& mesh : meshes) pointers.push_back(std::make_shared<PolygonMesh>(mesh));
  PrepareOptions options;
  options.surface.level = level;
  options.field = false;
  return prepare(pointers, options);
}

PolygonMesh floor(double z, double half = 4) {
  PolygonMesh mesh = shapes::plane(4, 4);
  for (Vec3& p : mesh.positions) p = Vec3(half * p.x(), half * p.y(), z);
  mesh.crease_angle_deg = 60;
  return mesh;
}

struct Lines {
  double length = 0, off = 0;
  int count = 0, closed = 0;
};

// Those of one kind, each point's distance from where it ought to be by `off`.
template <class Off>
Lines lines_of(const Prepared& scene, const Camera& camera, const Light& light, Kind kind,
               const Off& off, const std::vector<ObjectStyle>& styles = {}) {
  DrawOptions options;
  options.hatching = false;
  options.light_contours = {true, true};
  options.styles = styles;
  const DrawResult result = draw(scene, camera, options, {light});
  check_graph(result.graph);
  Lines lines;
  const Drawing& drawing = result.drawing;
  for (std::size_t s = 0; s < drawing.kinds.size(); ++s) {
    if (drawing.kinds[s] != kind) continue;
    ++lines.count;
    lines.closed += drawing.closed[s];
    const int first = drawing.offsets[s], last = drawing.offsets[s + 1];
    for (int i = first; i < last; ++i) {
      lines.off = std::max(lines.off, off(drawing.points[idx(i)]));
      const int next = i + 1 < last ? i + 1 : drawing.closed[s] ? first : i;
      lines.length += (drawing.points[idx(next)] - drawing.points[idx(i)]).norm();
    }
  }
  return lines;
}

constexpr double ball_height = 2;  // of the ball over the floor

// A ball of the finer triangles the larger n.
std::shared_ptr<const Prepared> ball_over_floor(int n) {
  return prepared({shapes::icosphere_mesh(1, n), floor(-ball_height)}, 1);
}

double radius_of(const Prepared& scene) {
  double radius = 0;
  for (const Vec3& p : scene.surface().positions)
    if (p.z() > -1.5) radius = std::max(radius, p.norm());
  return radius;
}

TEST(Terminator, OfABallIsHalfACircle) {
  const Vec3 towards = Vec3(1, -.5, 1).normalized();
  const Camera camera = cameras::orthographic(Vec3(0, -1, .3), 4);
  double last = 1;
  for (const int n : {2, 3, 4}) {
    const auto scene = ball_over_floor(n);
    const Lines lines = lines_of(*scene, camera, sun(towards), Kind::terminator,
                                 [&](const Vec3& p) { return std::abs(p.dot(towards)); });
    EXPECT_EQ(lines.count, 1);
    EXPECT_NEAR(lines.length, pi * radius_of(*scene), .03);
    EXPECT_LT(lines.off, last);
    last = lines.off / 2;
  }
  EXPECT_LT(last, .004);
}

TEST(Terminator, OfALampIsTheCircleThatTheLampSees) {
  Light lamp;
  lamp.kind = LightKind::point;
  lamp.vector = Vec3(0, 0, 3);
  const auto scene = ball_over_floor(4);
  const double at = 1 / lamp.vector.z();
  const Lines lines = lines_of(*scene, cameras::orthographic(Vec3(0, -1, 2), 4), lamp,
                               Kind::terminator, [&](const Vec3& p) { return p.z() - at; });
  EXPECT_LT(lines.off, .02);
  EXPECT_GT(lines.length, 4);
}

TEST(Terminator, IsNotWhereSomethingKeepsTheLightAway) {
  const auto roofed = prepared({shapes::icosphere_mesh(1, 2), floor(2.5)}, 3);
  const Lines lines =
      lines_of(*roofed, cameras::orthographic(Vec3(0, -1, 0), 4), sun(Vec3(.2, -.3, 1)),
               Kind::terminator, [](const Vec3&) { return 0.; });
  EXPECT_EQ(lines.count, 0);
}

TEST(ShadowOutline, OfABallUnderTheSunIsAnEllipse) {
  const Vec3 towards = Vec3(1, -.5, 2).normalized();
  const Camera camera = cameras::orthographic(Vec3(0, -.2, 1), 6);
  double last = 1;
  for (const int n : {2, 3, 4}) {
    const auto scene = ball_over_floor(n);
    const double radius = radius_of(*scene);
    const Lines lines =
        lines_of(*scene, camera, sun(towards), Kind::shadow_outline, [&](const Vec3& p) {
          EXPECT_NEAR(p.z(), -ball_height, 1e-9);
          return std::abs((p - p.dot(towards) * towards).norm() - radius);
        });
    EXPECT_GE(lines.length, .5);
    EXPECT_LT(lines.off, last);
    last = lines.off / 1.5;
  }
  EXPECT_LT(last, .01);
}

TEST(ShadowOutline, OfALampGrowsWithTheDistance) {
  Light lamp;
  lamp.kind = LightKind::point;
  lamp.vector = Vec3(0, 0, 4);
  const auto scene = ball_over_floor(4);
  const double slope = 1 / std::sqrt(4 * 4 - 1.);  // of the rays that touch the ball
  const double radius = (lamp.vector.z() + ball_height) * slope;
  const Lines lines =
      lines_of(*scene, cameras::orthographic(Vec3(0, -.1, -1), 6), lamp, Kind::shadow_outline,
               [&](const Vec3& p) { return std::abs(p.head<2>().norm() - radius); });
  EXPECT_EQ(lines.count, 0) << "the floor hides it";
  const Lines above =
      lines_of(*scene, cameras::orthographic(Vec3(0, -3, 1), 6), lamp, Kind::shadow_outline,
               [&](const Vec3& p) { return std::abs(p.head<2>().norm() - radius); });
  EXPECT_LT(above.off, .02);
  EXPECT_NEAR(above.length, 2 * pi * radius, .1 * radius) << "but for what the ball hides";
}

TEST(ShadowOutline, OfACubeIsAPolygonAndStopsAtTheFloorsEnd) {
  PolygonMesh cube = shapes::cube();
  cube.crease_angle_deg = 30;
  const Vec3 towards(1, 0, 1);
  const auto on_floor = [&](double half) {
    const auto scene = prepared({cube, floor(-1.5, half)}, 2);
    return lines_of(*scene, cameras::orthographic(Vec3(-1, -1, 2), 8), sun(towards),
                    Kind::shadow_outline, [](const Vec3& p) { return std::abs(p.z() + 1.5); });
  };
  const Lines whole = on_floor(6), part = on_floor(1.6);
  EXPECT_LT(whole.off, 1e-9);
  // The shadow is 4 long, from x = -3.5 on, and 2 wide; the cube hides the rest of its outline.
  EXPECT_NEAR(whole.length, 4 + 2 + 2.75 + .25, 1e-4);
  EXPECT_EQ(whole.count, 1);
  EXPECT_LT(part.length, whole.length);
}

TEST(ShadowOutline, RunsOverCreasesOfWhatReceivesIt) {
  PolygonMesh step = shapes::cube();  // the shadow of a ball on a box's top and side
  step.crease_angle_deg = 30;
  PolygonMesh ball = shapes::icosphere_mesh(.4, 2);
  for (Vec3& p : ball.positions) p += Vec3(2, 0, 2);
  const auto lit = prepared({ball, step}, 3);
  const Vec3 towards = Vec3(1, 0, 1).normalized();
  const Lines lines =
      lines_of(*lit, cameras::orthographic(Vec3(1, -1, 1), 3), sun(towards), Kind::shadow_outline,
               [&](const Vec3& p) { return std::max(std::abs(p.x()), std::abs(p.z())) - 1; });
  EXPECT_EQ(lines.count, 1);
  EXPECT_EQ(lines.closed, 1);
  EXPECT_LT(lines.off, 1e-9);
  EXPECT_GT(lines.length, 2);
}

TEST(ShadowOutline, IsThereOfWhatOnlyCastsShadows) {
  ObjectStyle unseen, gone;
  unseen.shadow_only = gone.ignore = true;
  const ObjectStyle plain;
  const auto scene = ball_over_floor(4);  // the ball is object 0, the floor is object 1
  const Vec3 towards = Vec3(1, -.5, 2).normalized();
  const double radius = radius_of(*scene);
  const auto shadow = [&](const std::vector<ObjectStyle>& styles) {
    return lines_of(
        *scene, cameras::orthographic(Vec3(0, -.2, 1), 6), sun(towards), Kind::shadow_outline,
        [&](const Vec3& p) { return std::abs((p - p.dot(towards) * towards).norm() - radius); },
        styles);
  };
  const Lines alone = shadow({unseen, plain}), beside = shadow({plain, plain});
  const double a = radius / towards.z(), b = radius;  // Ramanujan's length of an ellipse
  const double around = pi * (3 * (a + b) - std::sqrt((3 * a + b) * (a + 3 * b)));
  EXPECT_EQ(alone.closed, 1);
  EXPECT_LT(alone.off, .02);
  EXPECT_NEAR(alone.length, around, .02 * around);
  EXPECT_GT(alone.length, beside.length) << "the ball hides a part of it";
  EXPECT_EQ(shadow({gone, plain}).count, 0);
  EXPECT_EQ(shadow({plain, unseen}).count, 0) << "what receives it is not seen";
}

TEST(LightContours, AreOfTheLightsThatAskForThem) {
  const auto scene = ball_over_floor(2);
  Light light = sun(Vec3(1, -.5, 2));
  light.contours = false;
  const Camera camera = cameras::orthographic(Vec3(0, -1, 1), 4);
  for (const Kind kind : {Kind::terminator, Kind::shadow_outline}) {
    EXPECT_EQ(lines_of(*scene, camera, light, kind, [](const Vec3&) { return 0.; }).count, 0);
    EXPECT_EQ(lines_of(*scene, camera, Light{}, kind, [](const Vec3&) { return 0.; }).count, 0);
  }
}

TEST(PlaneSection, FollowsARoundFormUpToTheGoal) {
  const Surface sphere = shapes::sphere_surface(1, 4);
  const Vec3 start = Vec3(.1, .05, 1).normalized();
  for (double turn = .3; turn < 3; turn += .3) {
    const SectionPlane section{Vec3::Zero(), Vec3(.05, -.1, 0)};
    const Vec3 along = Vec3(.1, .05, 0).normalized();
    SectionPlane goal{Vec3::Zero(), std::cos(turn) * along - std::sin(turn) * Vec3::UnitZ()};
    ZeroPoint at;
    std::vector<ZeroSegment> way;
    std::vector<int> triangles;
    for (int t = 0; t < static_cast<int>(sphere.triangles.size()); ++t) {
      const Vec2 b = barycentrics(sphere, t, start);
      const Vec3& corner = sphere.positions[idx(sphere.triangles[idx(t)][0])];
      if (b.minCoeff() < 0 || b.sum() > 1 || corner.dot(start) < .5) continue;
      at.on = {t, b.x(), b.y()};
      at.position = position_at(sphere, at.on);
    }
    EXPECT_TRUE(follow_section(sphere, section, goal, at, way)) << turn;
    EXPECT_NEAR(goal.side(at.position), 0, 1e-12);
    for (std::size_t i = 1; i < way.size(); ++i) {
      EXPECT_LT((way[i][0].position - way[i - 1][1].position).norm(), 1e-15);
      EXPECT_NEAR(section.side(way[i][0].position), 0, 1e-6);
    }
  }
}

}  // namespace
}  // namespace illustrate
