#include <gtest/gtest.h>

#include <limits>

#include "core/errors.h"
#include "tests/cpp/cameras.h"
#include "tests/cpp/shapes.h"
#include "tone/step_along.h"
#include "tone/tone_regions.h"

namespace illustrate {
namespace {

// --- light
// ----------------------------------------------------------------------------------------

TEST(Light, HeadlightIsTheCosineToTheEye) {
  const Camera camera = cameras::orthographic(Vec3::UnitZ(), 2);
  const Vec3 normal = Vec3(std::sin(0.5), 0, std::cos(0.5));
  EXPECT_NEAR(brightness({}, camera, Vec3::Zero(), normal), std::cos(0.5), 1e-12);
  EXPECT_NEAR(brightness({Light{}}, camera, Vec3::Zero(), normal), std::cos(0.5), 1e-12);
  EXPECT_NEAR(brightness({}, camera, Vec3::Zero(), -normal), std::cos(0.5), 1e-12)
      << "the normal is turned to the eye";
}

TEST(Light, SunsAddUpToWhite) {
  const Camera camera = cameras::orthographic(Vec3::UnitZ(), 2);
  Light sun;
  sun.kind = LightKind::sun;
  sun.vector = Vec3(0, 3, 4);
  sun.strength = 0.5;
  EXPECT_NEAR(brightness({sun}, camera, Vec3::Zero(), Vec3::UnitZ()), 0.4, 1e-12);
  EXPECT_NEAR(brightness({sun, sun}, camera, Vec3::Zero(), Vec3::UnitZ()), 0.8, 1e-12);
  EXPECT_EQ(brightness({sun, sun, sun}, camera, Vec3::Zero(), Vec3::UnitZ()), 1);
  sun.vector = -Vec3::UnitZ();
  EXPECT_EQ(brightness({sun}, camera, Vec3::Zero(), Vec3::UnitZ()), 0);
}

TEST(Light, LampsHaveLobesAndNoFallOff) {
  const Camera camera = cameras::orthographic(Vec3::UnitZ(), 2);
  Light lamp;
  lamp.kind = LightKind::point;
  lamp.vector = Vec3(1, 0, 1);
  EXPECT_NEAR(brightness({lamp}, camera, Vec3::Zero(), Vec3::UnitZ()), std::sqrt(0.5), 1e-12);
  lamp.vector *= 100;
  EXPECT_NEAR(brightness({lamp}, camera, Vec3::Zero(), Vec3::UnitZ()), std::sqrt(0.5), 1e-12);
  lamp.kind = LightKind::area;  // shines down: its own cosine comes on top
  EXPECT_NEAR(brightness({lamp}, camera, Vec3::Zero(), Vec3::UnitZ()), 0.5, 1e-12);
  lamp.kind = LightKind::spot;
  lamp.angle_rad = pi / 3;
  EXPECT_NEAR(brightness({lamp}, camera, Vec3::Zero(), Vec3::UnitZ()), 0.5, 1e-12);
  lamp.angle_rad = pi / 5;
  EXPECT_EQ(brightness({lamp}, camera, Vec3::Zero(), Vec3::UnitZ()), 0) << "outside the cone";
  lamp.vector = Vec3::Zero();
  EXPECT_EQ(brightness({lamp}, camera, Vec3::Zero(), Vec3::UnitZ()), 0) << "in the lamp itself";
}

TEST(Light, BadFieldsAreNamed) {
  Light light;
  light.strength = -1;
  try {
    validate(light, 3);
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_NE(std::string(error.what()).find("lights[3].strength"), std::string::npos);
  }
  light = Light{};
  light.kind = LightKind::sun;
  EXPECT_THROW(validate(light, 0), InvalidInput);
  light.kind = LightKind::spot;
  EXPECT_THROW(validate(light, 0), InvalidInput);
  light.kind = LightKind::point;
  light.vector.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(validate(light, 0), InvalidInput);
  light = Light{};
  EXPECT_NO_THROW(validate(light, 0));
}

// --- the visible image
// ----------------------------------------------------------------------------

Vec2 centre_of(const VisibleImage& image, int cell) {
  const int column = cell % image.width, row = cell / image.width;
  return Vec2(column + 0.5, row + 0.5) * image.cell_px;
}

// Greatest error in depth of an icosphere seen from the front, where it is not seen at a grazing
// angle.
double sphere_error(int level) {
  const Surface sphere = shapes::sphere_surface(1, level);
  const Camera camera = cameras::orthographic(Vec3::UnitZ(), 1.25, 200);
  const VisibleImage image = render_visible(sphere, camera, 1, {}, 1);
  const double eye = camera.project(Vec3::Zero()).depth;
  double worst = 0;
  for (int cell = 0; cell < image.width * image.height; ++cell) {
    const Vec2 p = (centre_of(image, cell) - Vec2(100, 100)) / 80;
    if (p.norm() > 0.8) continue;
    EXPECT_NE(image.triangle[cell], none);
    worst = std::max(worst, std::abs(image.depth[cell] - eye + std::sqrt(1 - p.squaredNorm())));
  }
  return worst;
}

TEST(VisibleImage, DepthOfASphereConverges) {
  const double coarse = sphere_error(2), fine = sphere_error(4);
  EXPECT_LT(coarse, 0.05);
  EXPECT_LT(fine, coarse / 10) << "second order: 16";
}

TEST(VisibleImage, DepthIsCorrectInPerspective) {
  const Surface plane = shapes::plain_surface(shapes::plane(1, 1));
  const Vec3 eye(0.2, -2, 1);
  const Camera camera = cameras::perspective(eye, Vec3::Zero(), 0.1, 60, 300);
  const VisibleImage image = render_visible(plane, camera, 1, {}, 1);
  int covered = 0;
  for (int cell = 0; cell < image.width * image.height; ++cell) {
    if (image.triangle[cell] == none) continue;
    ++covered;
    const Vec2 centre = centre_of(image, cell);
    const SurfacePoint on = surface_point_under(plane, camera, image.triangle[cell], centre);
    const ImagePoint seen = camera.project(position_at(plane, on));
    EXPECT_LT((seen.xy - centre).norm(), 1e-8);
    EXPECT_NEAR(seen.depth, image.depth[cell], 1e-9);
  }
  EXPECT_GT(covered, 5000);
}

TEST(VisibleImage, NeighboursLeaveNoCracks) {
  const Surface plane = shapes::plain_surface(shapes::height_field(
      37, 41, [](double x, double y) { return 0.3 * std::sin(5 * x) * std::cos(4 * y); }));
  const Camera camera = cameras::orthographic(Vec3(0.1, 0.05, 1), 0.5, 400);
  const VisibleImage image = render_visible(plane, camera, 1, {}, 1);
  for (const int triangle : image.triangle) EXPECT_NE(triangle, none);
}

TEST(VisibleImage, NearestObjectWinsUnlessHidden) {
  const Surface both =
      shapes::joined(shapes::plain_surface(shapes::plane(2, 2)),
                     shapes::plain_surface(shapes::moved(shapes::plane(2, 2), Vec3(0, 0, 0.5))));
  const Camera camera = cameras::orthographic(Vec3::UnitZ(), 0.9, 64);
  for (const int triangle : render_visible(both, camera, 1, {}, 1).triangle) {
    EXPECT_EQ(both.triangle_objects[triangle], 1);
  }
  for (const int triangle : render_visible(both, camera, 1, {0, 1}, 1).triangle) {
    EXPECT_EQ(both.triangle_objects[triangle], 0);
  }
  EXPECT_THROW(render_visible(both, camera, 1, {1}, 1), InvalidInput);
}

TEST(VisibleImage, TrianglesAreCutAtTheNearPlane) {
  const Surface floor = shapes::plain_surface(shapes::plane(1, 1));
  const Camera camera = cameras::perspective(Vec3(0, 0, 0.2), Vec3(0, 0.5, 0.1), 0.3, 90, 200);
  const VisibleImage image = render_visible(floor, camera, 1, {}, 1);
  int covered = 0;
  for (std::size_t cell = 0; cell < image.triangle.size(); ++cell) {
    if (image.triangle[cell] == none) continue;
    ++covered;
    EXPECT_GE(image.depth[cell], 0.3 - 1e-9);
    EXPECT_LT(image.depth[cell], 1.2);
  }
  EXPECT_GT(covered, 1000);
  const Camera beyond = cameras::perspective(Vec3(0, 0, -2), Vec3(0, 0, -3), 0.3, 90, 200);
  for (const int triangle : render_visible(floor, beyond, 1, {}, 1).triangle) {
    EXPECT_EQ(triangle, none) << "all of it is behind the eye";
  }
}

TEST(VisibleImage, IsTheSameAtAnyThreadCount) {
  const Surface torus = shapes::torus_surface(1, 0.4, 60, 30);
  const Camera camera = cameras::perspective(Vec3(2, 1, 3), Vec3::Zero(), 0.1, 40, 333);
  const VisibleImage one = render_visible(torus, camera, 1.5, {}, 1);
  const VisibleImage many = render_visible(torus, camera, 1.5, {}, 7);
  EXPECT_EQ(one.width, 222);
  EXPECT_EQ(one.triangle, many.triangle);
  EXPECT_EQ(one.depth, many.depth);
}

TEST(VisibleImage, CellsAndBadSizes) {
  const Surface plane = shapes::plain_surface(shapes::plane(1, 1));
  const VisibleImage image =
      render_visible(plane, cameras::orthographic(Vec3::UnitZ(), 2, 10), 2, {}, 1);
  EXPECT_EQ(image.cell_of(Vec2(0, 0)), 0);
  EXPECT_EQ(image.cell_of(Vec2(9.9, 2.1)), 9);
  EXPECT_EQ(image.cell_of(Vec2(10, 5)), none);
  EXPECT_EQ(image.cell_of(Vec2(-0.1, 5)), none);
  EXPECT_EQ(image.cell_of(Vec2(std::nan(""), 5)), none);
  EXPECT_THROW(render_visible(plane, cameras::orthographic(Vec3::UnitZ(), 2, 10), 0, {}, 1),
               InvalidInput);
}

TEST(StepAlong, SamplesAreEvenAndInTheFrame) {
  const std::vector<Vec2> line{{-1e7, 5}, {4, 5}, {4, 1e7}};
  std::vector<Vec2> samples;
  step_along({line.data(), line.size()}, false, 0.5, Frame{Vec2::Zero(), Vec2(10, 10)},
             [&](const CurveSample& sample) { samples.push_back(sample.image); });
  ASSERT_GE(samples.size(), 16U);
  EXPECT_LE(samples.size(), 19U);
  for (const Vec2& sample : samples) {
    EXPECT_TRUE(sample.minCoeff() >= -1e-6 && sample.maxCoeff() <= 10 + 1e-6);
  }
}

// --- tone
// -----------------------------------------------------------------------------------------

TEST(ToneRegions, LevelsOfASphereUnderAHeadlight) {
  const Surface sphere = shapes::sphere_surface(1, 5);
  const Camera camera = cameras::orthographic(Vec3::UnitZ(), 1.25, 400);
  const VisibleImage image = render_visible(sphere, camera, 1, {}, 1);
  ToneOptions options;
  const ToneMap tone = tone_regions({sphere, image, {}, camera, {}}, options);
  const double area = pi * 160 * 160;
  const auto share = [&](Tone level) {
    return double(std::count(tone.level.begin(), tone.level.end(), level)) / area;
  };
  const double high = 0.85 * 0.85, low = 0.45 * 0.45;
  EXPECT_NEAR(share(Tone::highlight), 1 - high, 0.005);  // brightness^2 = 1 - r^2
  EXPECT_NEAR(share(Tone::midtone), high - low, 0.005);
  EXPECT_NEAR(share(Tone::shadow), low, 0.01);
  EXPECT_EQ(tone.level[0], Tone::nothing);
  EXPECT_EQ(tone.brightness[0], 0);
  EXPECT_EQ(tone.cell_of(Vec2(399.5, 1.5)), 799);

  options.highlight_threshold = options.shadow_threshold = 1;
  const ToneMap dark = tone_regions({sphere, image, {}, camera, {}}, options);
  EXPECT_EQ(std::count(dark.level.begin(), dark.level.end(), Tone::midtone), 0);
  EXPECT_EQ(std::count(dark.level.begin(), dark.level.end(), Tone::highlight), 0);
}

// One straight visible arc on the line x = 0 from (0, -end, z) to (0, end, z).
LabelledGraph straight_arc(const Camera& camera, Kind kind, double z, int left, int right,
                           double end = 1) {
  LabelledGraph graph;
  graph.nodes.resize(2);
  GraphArc arc{kind, 0, 0, 0, 1};
  arc.left_layers = left;
  arc.right_layers = right;
  graph.arcs.push_back(arc);
  for (const double y : {-end, end}) {
    const Vec3 p(0, y, z);
    graph.points.push({p, {}});
    graph.image.push(camera.project(p).xy);
    graph.nodes[y < 0 ? 0 : 1].image = camera.project(p).xy;
  }
  graph.points.close_list();
  graph.image.close_list();
  return graph;
}

// A half plane x >= 0 at z = .5 before a whole one at z = 0, seen from above: 100 px per world
// unit, the fold's edge at column 100.
struct Fold {
  Camera camera = cameras::orthographic(Vec3::UnitZ(), 1, 200);
  Surface surface =
      shapes::joined(shapes::plain_surface(shapes::plane(2, 2)),
                     shapes::plain_surface(shapes::moved(shapes::plane(2, 2), Vec3(1, 0, 0.5))));
  std::vector<std::uint8_t> hidden;

  double contact = 0;
  std::vector<Light> lights;

  ToneMap tone(const LabelledGraph& graph, ToneOptions options = {}) const {
    options.undercut_contact = contact;
    return tone_regions(
        {surface, render_visible(surface, camera, 1, hidden, 1), graph, camera, lights}, options);
  }
};

// Columns of a row that carry a band.
std::pair<int, int> columns(const ToneMap& tone, Band band, int row = 100) {
  int first = tone.width, last = -1;
  for (int i = 0; i < tone.width; ++i) {
    if (tone.band[row * tone.width + i] != band) continue;
    first = std::min(first, i);
    last = i;
  }
  return {first, last};
}

TEST(Bands, FoldHasAMachBandAndBeyondItAnUndercut) {
  const Fold fold;
  Vec2 top = fold.camera.project(Vec3(0, 1, 0)).xy, side = fold.camera.project(Vec3(1, 0, 0)).xy;
  ASSERT_LT(top.y(), 100);  // +y is up in the image, +x right: the fold is right of the arc
  ASSERT_GT(side.x(), 100);
  const ToneMap tone = fold.tone(straight_arc(fold.camera, Kind::boundary, 0.5, 0, 1));
  EXPECT_EQ(columns(tone, Band::mach_band), std::make_pair(100, 105));
  EXPECT_EQ(columns(tone, Band::undercut), std::make_pair(86, 99));

  const ToneMap wrong_side = fold.tone(straight_arc(fold.camera, Kind::boundary, 0.5, 1, 0));
  EXPECT_EQ(columns(wrong_side, Band::undercut).second, -1) << "nothing behind on the other side";
}

// The fold is half a unit in front of what lies beyond; the part's diagonal is the root of eight.
TEST(Bands, UndercutsNarrowAsTheGapGrows) {
  Fold fold;
  LabelledGraph edge = straight_arc(fold.camera, Kind::boundary, 0.5, 0, 1);
  for (CurvePoint& p : edge.points.values) {
    p.on.triangle = static_cast<int>(fold.surface.triangles.size()) - 1;
  }
  const auto width = [&](double contact) {
    fold.contact = contact;
    const auto [first, last] = columns(fold.tone(edge), Band::undercut);
    return last < 0 ? 0 : last - first + 1;
  };
  EXPECT_EQ(width(0), 14);
  EXPECT_EQ(width(0.2), 14) << "the gap is less than a fifth of what would end it";
  const double end = 0.25 * std::sqrt(8.0);
  EXPECT_NEAR(width(0.5), 14 * (1 - 0.5 / end) / 0.8, 1);
  EXPECT_EQ(width(0.7), 0);
  EXPECT_EQ(width(1), 0);
  EXPECT_EQ(columns(fold.tone(edge), Band::mach_band), std::make_pair(100, 105));
}

// The same fold: on the side of the light the gap that ends undercuts is 1 - sin 45 degrees of what
// it is without a side, on the other one 1 + sin 45 degrees.
TEST(Bands, UndercutsAreOnTheFarSideOfTheLightFirst) {
  Fold fold;
  fold.contact = 0.5;
  LabelledGraph edge = straight_arc(fold.camera, Kind::boundary, 0.5, 0, 1);
  for (CurvePoint& p : edge.points.values) {
    p.on.triangle = static_cast<int>(fold.surface.triangles.size()) - 1;
  }
  const auto width = [&](const Vec3& towards) {
    Light sun;
    sun.kind = LightKind::sun;
    sun.vector = towards;
    fold.lights = {sun};
    const auto [first, last] = columns(fold.tone(edge), Band::undercut);
    return last < 0 ? 0 : last - first + 1;
  };
  const double end = 0.25 * std::sqrt(8.0), side = std::sqrt(0.5);
  EXPECT_NEAR(width(Vec3(0, 0, 1)), 14 * (1 - 0.5 / end) / 0.8, 1);
  EXPECT_NEAR(width(Vec3(1, 0, 1)), 14 * (1 - 0.5 / (end * (1 + side))) / 0.8, 1);
  EXPECT_EQ(width(Vec3(-1, 0, 1)), 0);
  fold.contact = 0;
  EXPECT_EQ(width(Vec3(-1, 0, 1)), 14) << "as in the paper";
}

// Circles round the places of the fold whose radii are .7 of the distance from its end touch two
// lines through that: .7 / sqrt(1 - .7^2) px aside for each px along it.
TEST(Bands, UndercutsTaperTowardsTheEndOfTheirFold) {
  Fold fold;
  const LabelledGraph edge = straight_arc(fold.camera, Kind::boundary, 0.5, 0, 1, 0.5);
  const auto width = [&](int row) {
    const auto [first, last] = columns(fold.tone(edge), Band::undercut, row);
    return last < 0 ? 0 : last - first + 1;
  };
  EXPECT_EQ(width(53), 14) << "whole where undercuts are anywhere";
  fold.contact = 0.1;
  EXPECT_EQ(width(49), 0);
  for (const int row : {53, 57, 60}) EXPECT_NEAR(width(row), 0.98 * (row - 49.5), 1) << row;
  EXPECT_EQ(width(100), 14);
}

TEST(Bands, OptionsAndCurvesThatCoverNothing) {
  Fold fold;
  const LabelledGraph edge = straight_arc(fold.camera, Kind::silhouette, 0.5, 0, 2);
  ToneOptions options;
  options.mach_bands = false;
  EXPECT_EQ(columns(fold.tone(edge, options), Band::mach_band).second, -1);
  EXPECT_EQ(columns(fold.tone(edge, options), Band::undercut).first, 86);
  options = {};
  options.undercuts = false;
  EXPECT_EQ(columns(fold.tone(edge, options), Band::undercut).second, -1);
  EXPECT_EQ(columns(fold.tone(edge, options), Band::mach_band).first, 100);

  LabelledGraph hidden = edge;
  hidden.arcs[0].invisibility = 1;
  EXPECT_EQ(columns(fold.tone(hidden), Band::mach_band).second, -1);
  const LabelledGraph crease = straight_arc(fold.camera, Kind::crease, 0.5, 1, 1);
  EXPECT_EQ(columns(fold.tone(crease), Band::mach_band).second, -1);
  fold.hidden = {1, 0};
  EXPECT_EQ(columns(fold.tone(edge), Band::mach_band).second, -1) << "nothing beyond the fold";
}

TEST(Bands, IntersectionDarkensTheSheetTurnedAway) {
  const Camera camera = cameras::orthographic(Vec3::UnitZ(), 1, 200);
  const Surface roof = shapes::plain_surface(
      shapes::height_field(2, 2, [](double x, double) { return x < 0 ? x : -2 * x; }));
  Surface flat = roof;  // each side with its own normal at the ridge
  for (auto& normal : flat.normals) normal = Vec3::UnitZ();
  for (std::size_t v = 0; v < flat.positions.size(); ++v) {
    if (flat.positions[v].x() > 0) flat.normals[v] = Vec3(2, 0, 1).normalized();
  }
  const ToneMap tone = tone_regions({flat,
                                     render_visible(flat, camera, 1, {}, 1),
                                     straight_arc(camera, Kind::intersection, 0, 0, 0),
                                     camera,
                                     {}},
                                    {});
  EXPECT_EQ(columns(tone, Band::undercut), std::make_pair(100, 113));
  EXPECT_EQ(columns(tone, Band::mach_band), std::make_pair(94, 99));
}

TEST(ToneRegions, BadOptionsAreNamed) {
  ToneOptions options;
  options.undercut_px = -1;
  EXPECT_THROW(validate(options), InvalidInput);
  options = {};
  options.highlight_threshold = std::nan("");
  EXPECT_THROW(validate(options), InvalidInput);
  EXPECT_NO_THROW(validate(ToneOptions{}));
}

}  // namespace
}  // namespace illustrate
