#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/errors.h"
#include "pipeline/draw.h"
#include "stroke/continued_ends.h"
#include "tests/cpp/cameras.h"
#include "tests/cpp/shapes.h"
#include "tests/cpp/stroke/stroke_scene.h"

namespace illustrate {
namespace {

using namespace stroke_scene;

constexpr double width_px = 4;

Light side_light(const Vec3& vector) {
  Light light;
  light.kind = LightKind::side;
  light.vector = vector;
  return light;
}

DrawOptions weighted(const LineWeightOptions& weight) {
  DrawOptions options;
  options.hatching = false;
  options.stroke.line_width_px = width_px;
  options.stroke.simplify_px = 0;
  options.stroke.taper_px = 0;
  options.stroke.line_weight = weight;
  return options;
}

Drawing drawn(const std::vector<PolygonMesh>& meshes, const Camera& camera,
              const LineWeightOptions& weight, const std::vector<Light>& lights = {}) {
  std::vector<MeshPointer> pointers;
  for (const PolygonMesh& mesh : meshes)
    pointers.push_back(std::make_shared<const PolygonMesh>(mesh));
  PrepareOptions options;
  options.field = false;
  return draw(*prepare(pointers, options), camera, weighted(weight), lights).drawing;
}

Camera front(double half_height = 2) {
  return cameras::orthographic(Vec3(0.02, -1, 0.03), half_height, 400);
}

PolygonMesh ball_of(double radius) { return shapes::icosphere_mesh(radius, 4); }

// Of all points of one object's strokes.
double mean_width(const Drawing& drawing, int object, Kind kind) {
  double sum = 0;
  int count = 0;
  for (std::size_t s = 0; s < drawing.kinds.size(); ++s) {
    if (drawing.objects[s] != object || drawing.kinds[s] != kind) continue;
    for (int i = drawing.offsets[s]; i < drawing.offsets[s + 1]; ++i, ++count)
      sum += static_cast<double>(drawing.widths[idx(i)]);
  }
  return count > 0 ? sum / count : 0;
}

TEST(LightFrom, IsTheCosineOfOneSunAndNothingOfAmbientLight) {
  const Vec3 towards = Vec3(1, 2, 2) / 3;
  Light sun{LightKind::sun, towards};
  Light sky{LightKind::ambient};
  EXPECT_NEAR(light_from({sun}, front(), Vec3::Zero(), towards), 1, 1e-12);
  EXPECT_NEAR(light_from({sun}, front(), Vec3::Zero(), -towards), -1, 1e-12);
  EXPECT_NEAR(light_from({sun}, front(), Vec3::Zero(), Vec3::UnitX()), 1.0 / 3, 1e-12);
  EXPECT_EQ(light_from({sky}, front(), Vec3::Zero(), towards), 0);
  EXPECT_NEAR(light_from({sun, sky}, front(), Vec3::Zero(), towards), 0.5, 1e-12);
  sun.strength = 0;
  EXPECT_EQ(light_from({sun}, front(), Vec3::Zero(), towards), 0);
}

TEST(LineWeights, AnOutlineSwellsAwayFromTheLight) {
  LineWeightOptions weight;
  weight.by_light = 0.5;
  const Drawing ball = drawn({ball_of(1)}, front(), weight, {side_light(Vec3(1, 0, 0))});
  ASSERT_EQ(count_of(ball), 1U);
  for (std::size_t i = 0; i < ball.points.size(); ++i) {
    const double cosine = (ball.image[i].x() - 200) / (ball.image[i] - Vec2(200, 200)).norm();
    EXPECT_NEAR(static_cast<double>(ball.widths[i]), width_px * (1 - 0.5 * cosine), 0.06);
  }
}

TEST(LineWeights, TheHeadlightChangesNothing) {
  LineWeightOptions weight;
  weight.by_light = 1;
  const Drawing ball = drawn({ball_of(1)}, front(), weight);
  for (const float width : ball.widths) EXPECT_NEAR(static_cast<double>(width), width_px, 0.01);
}

TEST(LineWeights, NearerThingsHaveWiderLines) {
  LineWeightOptions weight;
  weight.by_depth = 0.5;
  const PolygonMesh ball = ball_of(0.5);
  const Drawing both = drawn(
      {shapes::moved(ball, Vec3(-1, -1, 0)), shapes::moved(ball, Vec3(1, 1, 0))}, front(), weight);
  EXPECT_NEAR(mean_width(both, 0, Kind::silhouette), 1.5 * width_px, 0.05);
  EXPECT_NEAR(mean_width(both, 1, Kind::silhouette), 0.5 * width_px, 0.05);
  const Drawing beside = drawn(
      {shapes::moved(ball, Vec3(-1, 0, 0)), shapes::moved(ball, Vec3(1, 0, 0))}, front(), weight);
  for (const float width : beside.widths) EXPECT_NEAR(static_cast<double>(width), width_px, 0.15);
}

TEST(LineWeights, OnlyLinesInsideAnObjectAreInner) {
  LineWeightOptions weight;
  weight.inner_scale = 0.5;
  const PolygonMesh near = shapes::moved(ball_of(0.5), Vec3(0, -3, 0));
  const PolygonMesh far = ball_of(1.5);
  const Drawing two = drawn({near, far}, front(), weight);
  for (const float width : two.widths) EXPECT_NEAR(static_cast<double>(width), width_px, 1e-6);
  const Drawing one = drawn({shapes::joined(near, far)}, front(), weight);
  ASSERT_EQ(count_of(one), 2U);
  for (std::size_t i = 0; i < one.points.size(); ++i) {
    const bool inner = (one.image[i] - Vec2(200, 200)).norm() < 100;
    EXPECT_NEAR(static_cast<double>(one.widths[i]), inner ? width_px / 2 : width_px, 1e-6);
  }
}

TEST(LineWeights, DoNotJumpWhereALineRunsOn) {
  GraphBuilder b;
  const int middle = b.node(NodeKind::joint, {50, 50});
  b.line(b.node(NodeKind::end, {10, 50}), middle);
  b.line(middle, b.node(NodeKind::end, {90, 50}));
  StrokeOptions options;
  options.taper_px = 0;
  options.simplify_px = 0;
  Ragged<double> weights;
  weights.add(std::vector<double>{1, 1});
  weights.add(std::vector<double>{0.5, 0.5});
  const Drawing drawing =
      make_strokes(b.graph, {}, {}, flat_camera(), {}, {}, options, {weights, {}, {}});
  ASSERT_EQ(count_of(drawing), 1U);
  EXPECT_NEAR(static_cast<double>(drawing.widths.front()), 2, 1e-6);
  EXPECT_NEAR(static_cast<double>(drawing.widths.back()), 1, 1e-6);
  for (std::size_t i = 0; i + 1 < drawing.widths.size(); ++i) {
    const double step = (drawing.image[i + 1] - drawing.image[i]).norm();
    EXPECT_LE(std::abs(drawing.widths[i + 1] - drawing.widths[i]), 1.01 / 16 * step + 1e-6);
  }
}

TEST(LineWeights, WrongOptionsAreNamed) {
  StrokeOptions options;
  options.line_weight.by_light = 1.5;
  EXPECT_THROW(validate(options), InvalidInput);
  options.line_weight = {0, -0.1, 1};
  EXPECT_THROW(validate(options), InvalidInput);
  options.line_weight = {0, 0, std::nan("")};
  EXPECT_THROW(validate(options), InvalidInput);
}

// A level line that ends freely on the right.
StrokePath level_path(double from, double to, double y, double width = 2) {
  StrokePath path;
  for (double x = from; x <= to; x += 5)
    path.points.push_back({Vec3(x, -y, 0), {}, Vec2(x, y), width});
  path.free_end = true;
  return path;
}

bool end_stays_free(StrokePath other) {
  std::vector<StrokePath> paths{level_path(0, 50, 20), std::move(other)};
  keep_continued_ends(paths, 10, 1);
  return paths[0].free_end;
}

TEST(ContinuedEnds, OnAnotherLineThatRunsOnAreNotFree) {
  EXPECT_FALSE(end_stays_free(level_path(45, 100, 20.5)));
  EXPECT_FALSE(end_stays_free(level_path(50.5, 100, 20.0)));
  EXPECT_TRUE(end_stays_free(level_path(45, 100, 23))) << "too far beside";
  EXPECT_FALSE(end_stays_free(level_path(45, 100, 23, 8))) << "within a wide line";
  EXPECT_TRUE(end_stays_free(level_path(55, 100, 20))) << "too far ahead";
  EXPECT_TRUE(end_stays_free(level_path(0, 55, 20.5))) << "which ends there, too";
}

// Whatever other lines there are, from beyond the image too.
TEST(ContinuedEnds, AreToldByEachOtherLineAlone) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> place(0, 60);
  std::vector<StrokePath> paths;
  for (int i = 0; i < 150; ++i) {
    const double from = place(random) - 5, y = place(random);
    paths.push_back(level_path(i % 50 == 0 ? -1e4 : from, from + 20, y, 1 + i % 3));
  }
  std::vector<StrokePath> together = paths;
  keep_continued_ends(together, 10, 1);
  int free = 0;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    bool stays_free = true;
    for (std::size_t j = 0; j < paths.size(); ++j) {
      if (j == i) continue;
      std::vector<StrokePath> two{paths[i], paths[j]};
      keep_continued_ends(two, 10, 1);
      stays_free = stays_free && two[0].free_end;
    }
    EXPECT_EQ(together[i].free_end, stays_free) << i;
    free += stays_free ? 1 : 0;
  }
  EXPECT_GT(free, 10);
  EXPECT_LT(free, 140);
}

TEST(ContinuedEnds, OnALineAcrossStayFree) {
  StrokePath across;
  for (double y = 0; y <= 40; y += 5)
    across.points.push_back({Vec3(50, -y, 0), {}, Vec2(50, y), 2});
  EXPECT_TRUE(end_stays_free(across));
}

TEST(ContinuedEnds, AClosedLineRunsOnRoundItsStart) {
  StrokePath ring;
  ring.closed = true;
  for (const Vec2& p : circle({50, 120}, 100, 360))
    ring.points.push_back({Vec3(p.x(), -p.y(), 0), {}, p, 2});
  for (const std::size_t turn : {0, 90, 265, 268, 270, 272}) {
    StrokePath turned = ring;
    std::rotate(turned.points.begin(), turned.points.begin() + static_cast<std::ptrdiff_t>(turn),
                turned.points.end());
    EXPECT_FALSE(end_stays_free(turned)) << turn;
  }
}

}  // namespace
}  // namespace illustrate
