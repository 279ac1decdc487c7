#include <gtest/gtest.h>

#include "core/errors.h"
#include "hatch/critical_curves.h"
#include "hatch/neighbour_grid.h"
#include "hatch/reduce_hatches.h"
#include "hatch/walk.h"
#include "tests/cpp/cameras.h"
#include "tests/cpp/shapes.h"

namespace illustrate {
namespace {

// A cross field with the given unit tangent at every vertex.
template <class Direction>
CrossField field_of(const Surface& surface, const Direction& direction) {
  CrossField field;
  for (std::size_t v = 0; v < surface.positions.size(); ++v) {
    const Vec3 d = direction(surface.positions[v]), n = surface.normals[v];
    field.directions.push_back((d - d.dot(n) * n).normalized());
  }
  return field;
}

Vec3 round_z(const Vec3& p) { return Vec3::UnitZ().cross(p) + Vec3(1e-9, 0, 0); }

ToneMap uniform_tone(const VisibleImage& visible, Tone level) {
  ToneMap tone;
  tone.width = visible.width;
  tone.height = visible.height;
  tone.cell_px = visible.cell_px;
  tone.band.assign(visible.triangle.size(), Band::nothing);
  tone.brightness.assign(visible.triangle.size(), 0.5F);
  for (const int triangle : visible.triangle) {
    tone.level.push_back(triangle == none ? Tone::nothing : level);
  }
  return tone;
}

// Everything that placement needs, and what it gives.
struct Scene {
  Surface surface;
  Camera camera;
  CrossField field;
  VisibleImage visible;
  ToneMap tone;
  LabelledGraph graph;
  HatchOptions options;
  std::vector<double> spacing_scale;
  std::vector<std::uint8_t> unhatched;
  Counts counts;

  Hatches place() {
    return place_hatches(surface, field, camera, visible, tone, graph, spacing_scale, unhatched,
                         options, counts);
  }
  Hatches reduce(const Hatches& hatches) {
    return reduce_hatches(hatches, surface, tone, graph, options, counts, spacing_scale);
  }
  int cell(const HatchPoint& point) const { return visible.cell_of(point.image); }
  // A visible arc through world points.
  void add_arc(Kind kind, const Points& line) {
    GraphArc arc{kind, 0, 0};
    arc.start_node = arc.end_node = 0;
    graph.arcs.push_back(arc);
    for (const Vec3& p : line) {
      graph.points.push({p, {}});
      graph.image.push(camera.project(p).xy);
    }
    graph.points.close_list();
    graph.image.close_list();
  }
};

template <class Direction>
Scene scene_of(Surface surface, const Camera& camera, const Direction& direction) {
  CrossField field = field_of(surface, direction);
  VisibleImage visible = render_visible(surface, camera, 1, {}, 1);
  ToneMap tone = uniform_tone(visible, Tone::shadow);
  return {std::move(surface),
          camera,
          std::move(field),
          std::move(visible),
          std::move(tone),
          {},
          {},
          {},
          {},
          {}};
}

// The square [-1, 1]^2 at z = 0, 100 px per unit, with a cross 20 degrees off the axes.
Scene plane_scene() {
  return scene_of(shapes::plain_surface(shapes::plane(13, 11)),
                  cameras::orthographic(Vec3::UnitZ(), 1.2, 240),
                  [](const Vec3&) { return Vec3(std::cos(0.35), std::sin(0.35), 0); });
}

Scene torus_scene() {
  return scene_of(shapes::torus_surface(1, 0.4, 90, 40),
                  cameras::perspective(Vec3(0, -3, 4), Vec3::Zero(), 0.1, 40, 400), round_z);
}

// What holds for any placement.
void check_hatches(const Scene& scene, const Hatches& hatches) {
  ASSERT_EQ(hatches.kinds.size(), hatches.curves.size());
  ASSERT_EQ(hatches.objects.size(), hatches.curves.size());
  for (std::size_t h = 0; h < hatches.curves.size(); ++h) {
    ASSERT_GE(hatches.curves[h].size(), 2U);
    for (const HatchPoint& point : hatches.curves[h]) {
      ASSERT_TRUE(point.position.allFinite() && point.image.allFinite());
      EXPECT_GE(std::min({point.on.b1, point.on.b2, 1 - point.on.b1 - point.on.b2}), -1e-12);
      EXPECT_LT((position_at(scene.surface, point.on) - point.position).norm(), 1e-12);
      EXPECT_LT((scene.camera.project(point.position).xy - point.image).norm(), 1e-9);
      EXPECT_EQ(scene.surface.triangle_objects[point.on.triangle], hatches.objects[h]);
      EXPECT_NE(scene.cell(point), none);
    }
  }
}

double length_px(Span<const HatchPoint> curve) {
  double length = 0;
  for (std::size_t i = 1; i < curve.size(); ++i) {
    length += (curve[i].image - curve[i - 1].image).norm();
  }
  return length;
}

Vec3 tangent_at(Span<const HatchPoint> curve, std::size_t i) {
  const std::size_t a = i == 0 ? 0 : i - 1, b = std::min(i + 1, curve.size() - 1);
  return (curve[b].position - curve[a].position).normalized();
}

// The least image distance between points of different hatches that satisfy `pair(tangent,
// tangent)`.
template <class Pair>
double least_distance(const Hatches& hatches, const Pair& pair) {
  double least = 1e9;
  for (std::size_t a = 0; a < hatches.curves.size(); ++a) {
    for (std::size_t b = a + 1; b < hatches.curves.size(); ++b) {
      const auto one = hatches.curves[a], other = hatches.curves[b];
      for (std::size_t i = 0; i < one.size(); ++i) {
        for (std::size_t j = 0; j < other.size(); ++j) {
          const double distance = (one[i].image - other[j].image).norm();
          if (distance < least && pair(tangent_at(one, i), tangent_at(other, j))) least = distance;
        }
      }
    }
  }
  return least;
}

bool parallel(const Vec3& a, const Vec3& b) { return std::abs(a.dot(b)) > 0.75; }
bool perpendicular(const Vec3& a, const Vec3& b) { return std::abs(a.dot(b)) < 0.6; }

// The greatest distance of a covered cell to the nearest hatch along `direction`, away from the
// outline.
double worst_gap(const Scene& scene, const Hatches& hatches, const Vec3& direction) {
  double worst = 0;
  for (double x = -0.85; x < 0.86; x += 0.05) {
    for (double y = -0.85; y < 0.86; y += 0.05) {
      const Vec2 p = scene.camera.project(Vec3(x, y, 0)).xy;
      double nearest = 1e9;
      for (std::size_t h = 0; h < hatches.curves.size(); ++h) {
        const auto curve = hatches.curves[h];
        if (!parallel(tangent_at(curve, curve.size() / 2), direction)) continue;
        for (const HatchPoint& q : curve) nearest = std::min(nearest, (q.image - p).norm());
      }
      worst = std::max(worst, nearest);
    }
  }
  return worst;
}

// --- walking
// --------------------------------------------------------------------------------------

// Greatest drift in latitude of a walk of a quarter turn round a sphere of radius 1, 100 px a unit.
double drift_along_parallel(int level) {
  const Surface sphere = shapes::sphere_surface(1, level);
  const CrossField field = field_of(sphere, round_z);
  const Camera camera = cameras::orthographic(Vec3(0, -1, 0), 1.2, 240);
  const Walker walker(sphere, field, camera);
  const VisibleImage visible = render_visible(sphere, camera, 1, {}, 1);
  const Vec2 start = camera.project(Vec3(0, -1, 0.5)).xy;
  Walk walk = walker.start(
      surface_point_under(sphere, camera, visible.triangle[visible.cell_of(start)], start),
      Vec3::UnitX());
  const double z = walker.point(walk.on).position.z();
  double worst = 0;
  for (int i = 0; i < 60; ++i) {
    EXPECT_EQ(walker.advance(walk, 1), WalkEnd::whole);
    worst = std::max(worst, std::abs(walker.point(walk.on).position.z() - z));
  }
  EXPECT_NEAR(walker.point(walk.on).image.x() - start.x(), 60, 0.5) << "lengths are of the image";
  return worst;
}

TEST(Walk, FollowsTheCrossToSecondOrder) {
  const double coarse = drift_along_parallel(3), fine = drift_along_parallel(5);
  EXPECT_LT(coarse, 0.02);
  EXPECT_LT(fine, coarse / 4);
}

TEST(Walk, EndsOnTheSilhouette) {
  const Surface sphere = shapes::sphere_surface(1, 4);
  const CrossField field = field_of(sphere, round_z);
  const Camera camera = cameras::orthographic(Vec3(0, -1, 0), 1.2, 240);
  const Walker walker(sphere, field, camera);
  const VisibleImage visible = render_visible(sphere, camera, 1, {}, 1);
  const Vec2 start = camera.project(Vec3(0, -1, 0.2)).xy;
  Walk walk = walker.start(
      surface_point_under(sphere, camera, visible.triangle[visible.cell_of(start)], start),
      Vec3::UnitX());
  WalkEnd end = WalkEnd::whole;
  for (int i = 0; i < 200 && end == WalkEnd::whole; ++i) end = walker.advance(walk, 1);
  EXPECT_EQ(end, WalkEnd::silhouette);
  EXPECT_NEAR(normal_at(sphere, walk.on).y(), 0, 1e-6);
}

TEST(Walk, StopsAtCreasesAndBoundaries) {
  Surface plane = shapes::plain_surface(shapes::plane(2, 2));
  const CrossField field = field_of(plane, [](const Vec3&) { return Vec3::UnitX(); });
  const Camera camera = cameras::orthographic(Vec3::UnitZ(), 1, 200);
  const auto walk_right = [&] {
    const Walker walker(plane, field, camera);
    const VisibleImage visible = render_visible(plane, camera, 1, {}, 1);
    const Vec2 start = camera.project(Vec3(-0.63, 0.31, 0)).xy;
    Walk walk = walker.start(
        surface_point_under(plane, camera, visible.triangle[visible.cell_of(start)], start),
        Vec3::UnitX());
    EXPECT_EQ(walker.advance(walk, 1000), WalkEnd::edge);
    EXPECT_NEAR(walker.point(walk.on).position.y(), 0.31, 1e-6);
    return walker.point(walk.on).position.x();
  };
  EXPECT_NEAR(walk_right(), 1, 1e-6);
  for (std::size_t t = 0; t < plane.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const double a = plane.positions[plane.triangles[t][k]].x();
      const double b = plane.positions[plane.triangles[t][next_corner(k)]].x();
      if (a == 0 && b == 0) plane.edge_kinds[t][k] = EdgeKind::crease;
    }
  }
  EXPECT_NEAR(walk_right(), 0, 1e-6);
}

// The right half wound the other way, as beyond the seam of a double cover.
TEST(Walk, CrossesTheSeamOfADoubleCover) {
  Surface plane = shapes::plain_surface(shapes::plane(8, 8));
  for (std::size_t t = 0; t < plane.triangles.size(); ++t) {
    Triangle& corner = plane.triangles[t];
    const double x = plane.positions[corner[0]].x() + plane.positions[corner[1]].x() +
                     plane.positions[corner[2]].x();
    if (x < 0) continue;
    std::swap(corner[1], corner[2]);
    plane.flips[t] = 7;
  }
  shapes::link_neighbours(plane);
  const CrossField field = field_of(plane, [](const Vec3&) { return Vec3(2, 1, 0); });
  const Camera camera = cameras::orthographic(Vec3::UnitZ(), 1, 200);
  const Walker walker(plane, field, camera);
  Walk walk = walker.start({0, 0.3, 0.3}, Vec3::UnitX());
  const Vec3 from = walker.point(walk.on).position;
  EXPECT_EQ(walker.advance(walk, 150), WalkEnd::whole);
  const Vec3 run = walker.point(walk.on).position - from;
  EXPECT_LT((run - 1.5 * Vec3(2, 1, 0).normalized()).norm(), 1e-5);
  EXPECT_EQ(walk.facing, -1);
}

// --- critical curves and neighbours
// ---------------------------------------------------------------

TEST(CriticalCurves, OnlyVisibleCriticalArcsSeparate) {
  Scene scene = plane_scene();
  scene.add_arc(Kind::crease,
                {Vec3(0, -1e6, 0), Vec3(0, 1, 0)});  // far out of the frame, column 120
  scene.add_arc(Kind::mark, {Vec3(0.5, -1, 0), Vec3(0.5, 1, 0)});
  scene.add_arc(Kind::silhouette, {Vec3(-0.5, -1, 0), Vec3(-0.5, 1, 0)});
  scene.graph.arcs[2].invisibility = 2;
  const CriticalCurves curves(scene.graph, 240, 240);
  EXPECT_NEAR(curves.first_crossing(Vec2(115, 100), Vec2(135, 108)), 0.25, 1e-6);
  EXPECT_FALSE(curves.separate(Vec2(115, 100), Vec2(119, 108)));
  EXPECT_FALSE(curves.separate(Vec2(160, 100), Vec2(180, 100))) << "marks do not count";
  EXPECT_FALSE(curves.separate(Vec2(60, 100), Vec2(80, 100))) << "nor do hidden silhouettes";
  EXPECT_FALSE(curves.separate(Vec2(115, 5), Vec2(125, 5))) << "it ends at y = 1, row 20";
}

TEST(NeighbourGrid, ParallelTestIsThePapers) {
  const Vec3 n = Vec3::UnitZ(), t = Vec3::UnitX();
  EXPECT_TRUE(are_parallel(t, n, -t));
  EXPECT_TRUE(are_parallel(t, n, Vec3(1, 0.99, 0)));
  EXPECT_FALSE(are_parallel(t, n, Vec3(1, 1.01, 0)));
  EXPECT_TRUE(are_parallel(t, n, Vec3(0.3, 0.1, 5))) << "after projection to the tangent plane";
  EXPECT_FALSE(are_parallel(t, n, n));
}

TEST(NeighbourGrid, FindsAllWithinTheRadius) {
  NeighbourGrid grid(100, 100, 8);
  int point = 0;
  for (double x = -5; x < 106; x += 3.7) {
    for (double y = -5; y < 106; y += 3.1) grid.add({Vec2(x, y), Vec3::UnitX(), point++});
  }
  int found = 0, expected = 0;
  grid.any_within(Vec2(33, 47), 15, [&](const HatchNode&) { return ++found < 0; });
  grid.any_within(Vec2(33, 47), 1000, [&](const HatchNode& node) {
    expected += (node.image - Vec2(33, 47)).norm() < 15;
    return false;
  });
  EXPECT_EQ(found, expected);
  EXPECT_GT(expected, 40);
}

// --- placement
// ------------------------------------------------------------------------------------

TEST(PlaceHatches, PlaneIsCoveredEvenlyByBothFamilies) {
  Scene scene = plane_scene();
  const Hatches hatches = scene.place();
  check_hatches(scene, hatches);
  EXPECT_GE(least_distance(hatches, parallel), 0.6 * 8 - 1e-9);
  const Vec3 one(std::cos(0.35), std::sin(0.35), 0), other(-one.y(), one.x(), 0);
  EXPECT_LT(worst_gap(scene, hatches, one), 8);
  EXPECT_LT(worst_gap(scene, hatches, other), 8);
  for (std::size_t h = 0; h < hatches.curves.size(); ++h) {
    const auto curve = hatches.curves[h];
    const Vec3 run = (curve.back().position - curve.front().position).normalized();
    EXPECT_GT(std::max(std::abs(run.dot(one)), std::abs(run.dot(other))), 1 - 1e-6) << "straight";
    EXPECT_GE(length_px(curve), scene.options.min_length_px);
  }
  EXPECT_EQ(scene.counts["hatches"], static_cast<int>(hatches.curves.size()));
  EXPECT_GT(scene.counts["hatch_steps"], 1000);
}

TEST(PlaceHatches, NothingHiddenIsHatched) {
  Scene scene = torus_scene();
  const Hatches hatches = scene.place();
  check_hatches(scene, hatches);
  EXPECT_GT(hatches.curves.size(), 100U);
  for (const HatchPoint& point : hatches.curves.values) {
    double farthest = 0;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const int cell = scene.visible.cell_of(point.image + Vec2(dx, dy));
        if (cell != none) farthest = std::max(farthest, scene.visible.depth[cell]);
      }
    }
    const double slack = scene.camera.pixel_size(point.position);
    EXPECT_LT(scene.camera.project(point.position).depth, farthest + slack);
  }
}

TEST(PlaceHatches, HatchesFollowTheCross) {
  Scene scene = torus_scene();
  const Hatches hatches = scene.place();
  int far_off = 0, all = 0;
  for (std::size_t h = 0; h < hatches.curves.size(); ++h) {
    const auto curve = hatches.curves[h];
    for (std::size_t i = 1; i + 1 < curve.size(); ++i, ++all) {
      const Vec3 p = curve[i].position;
      const double around = std::abs(tangent_at(curve, i).dot(round_z(p).normalized()));
      far_off += std::min(around, std::sqrt(1 - std::min(1.0, around * around))) > std::sin(0.05);
    }
  }
  EXPECT_LT(far_off, all / 50);
}

TEST(PlaceHatches, EndAtCriticalCurvesAndDoNotMindNeighboursBeyond) {
  Scene scene = plane_scene();
  scene.add_arc(Kind::crease, {Vec3(0.013, -1.1, 0), Vec3(0.013, 1.1, 0)});
  const Hatches hatches = scene.place();
  check_hatches(scene, hatches);
  const double column = scene.camera.project(Vec3(0.013, 0, 0)).xy.x();
  int ends_on_curve = 0;
  for (std::size_t h = 0; h < hatches.curves.size(); ++h) {
    const auto curve = hatches.curves[h];
    const bool left = curve[curve.size() / 2].image.x() < column;
    for (const HatchPoint& point : curve) {
      EXPECT_LT((point.image.x() - column) * (left ? 1 : -1), 1e-6) << "no hatch crosses";
    }
    ends_on_curve += std::abs(curve.front().image.x() - column) < 0.03;
    ends_on_curve += std::abs(curve.back().image.x() - column) < 0.03;
  }
  EXPECT_GT(ends_on_curve, 40);
}

TEST(PlaceHatches, HighlightsAndMachBandsStayWhite) {
  Scene scene = plane_scene();
  for (int cell = 0; cell < 240 * 240; ++cell) {
    const int column = cell % 240;
    if (column < 90) scene.tone.level[cell] = Tone::highlight;
    if (column >= 150 && column < 160) scene.tone.band[cell] = Band::mach_band;
  }
  const Hatches hatches = scene.place();
  EXPECT_GT(hatches.curves.size(), 20U);
  for (const HatchPoint& point : hatches.curves.values) {
    const double x = point.image.x();
    EXPECT_TRUE(x >= 90 && (x < 150 || x >= 160)) << x;
  }
}

TEST(PlaceHatches, UndercutsAreDenseAlsoInHighlights) {
  Scene scene = plane_scene();
  for (int cell = 0; cell < 240 * 240; ++cell) {
    scene.tone.level[cell] = Tone::highlight;
    if (cell % 240 >= 100 && cell % 240 < 140) scene.tone.band[cell] = Band::undercut;
  }
  const Hatches hatches = scene.place();
  check_hatches(scene, hatches);
  double undercut_px = 0, all_px = 0;
  for (std::size_t h = 0; h < hatches.curves.size(); ++h) {
    all_px += length_px(hatches.curves[h]);
    if (hatches.kinds[h] == Kind::undercut) undercut_px += length_px(hatches.curves[h]);
    for (const HatchPoint& point : hatches.curves[h]) {
      EXPECT_TRUE(point.image.x() >= 100 && point.image.x() < 140);
    }
  }
  const double area = 40 * 200;
  EXPECT_GT(undercut_px, 0);
  EXPECT_GT(all_px / area, 1.15 * 2 / 8) << "denser than elsewhere";
  EXPECT_EQ(scene.reduce(hatches).curves.size(), hatches.curves.size()) << "nothing to reduce";
}

TEST(PlaceHatches, LengthAndTurnAreLimited) {
  Scene scene = torus_scene();
  scene.options.max_length_px = 60;
  const Hatches shorter = scene.place();
  for (std::size_t h = 0; h < shorter.curves.size(); ++h) {
    EXPECT_LT(length_px(shorter.curves[h]), 60.01);
  }
  scene.options = {};
  scene.options.max_turn_deg = 30;
  const Hatches hatches = scene.place();
  for (std::size_t h = 0; h < hatches.curves.size(); ++h) {
    const auto curve = hatches.curves[h];
    const double turn = tangent_at(curve, 0).dot(tangent_at(curve, curve.size() - 1));
    EXPECT_GT(turn, std::cos(66 * shapes::pi / 180)) << "30 degrees each way, and a bend";
  }
}

TEST(PlaceHatches, ObjectsHaveTheirOwnSpacingOrNone) {
  Surface two =
      shapes::joined(shapes::plain_surface(shapes::moved(shapes::plane(4, 4), Vec3(-1.05, 0, 0))),
                     shapes::plain_surface(shapes::moved(shapes::plane(4, 4), Vec3(1.05, 0, 0))));
  Scene scene = scene_of(std::move(two), cameras::orthographic(Vec3::UnitZ(), 2.2, 300),
                         [](const Vec3&) { return Vec3::UnitX(); });
  const auto lengths = [&] {
    const Hatches hatches = scene.place();
    std::array<double, 2> sum{0, 0};
    for (std::size_t h = 0; h < hatches.curves.size(); ++h) {
      sum[hatches.objects[h]] += length_px(hatches.curves[h]);
    }
    return sum;
  };
  scene.spacing_scale = {1, 2};
  EXPECT_NEAR(lengths()[1] / lengths()[0], 0.5, 0.1);
  scene.unhatched = {1, 0};
  EXPECT_EQ(lengths()[0], 0);
  EXPECT_GT(lengths()[1], 0);
  scene.spacing_scale = {1};
  EXPECT_THROW(scene.place(), InvalidInput);
  scene.spacing_scale = {1, 0};
  EXPECT_THROW(scene.place(), InvalidInput);
}

TEST(PlaceHatches, IsDeterministicAndCanBeCancelled) {
  Scene scene = torus_scene();
  const Hatches a = scene.place(), b = scene.place();
  ASSERT_EQ(a.curves.offsets, b.curves.offsets);
  for (std::size_t i = 0; i < a.curves.values.size(); ++i) {
    EXPECT_EQ(a.curves.values[i].position, b.curves.values[i].position);
  }
  int calls = 0;
  const Progress progress([&](double, const std::string&) { return ++calls < 3; }, "hatch");
  EXPECT_THROW(place_hatches(scene.surface, scene.field, scene.camera, scene.visible, scene.tone,
                             scene.graph, {}, {}, {}, scene.counts, progress),
               Cancelled);
}

TEST(PlaceHatches, NothingSeenGivesNothing) {
  Scene scene = plane_scene();
  scene.tone = uniform_tone(scene.visible, Tone::highlight);
  EXPECT_TRUE(scene.place().curves.empty());
  scene.surface = Surface{};
  scene.field = CrossField{};
  scene.visible = render_visible(scene.surface, scene.camera, 1, {}, 1);
  EXPECT_TRUE(scene.place().curves.empty());
  EXPECT_TRUE(scene.reduce(Hatches{}).curves.empty());
}

TEST(PlaceHatches, BadOptionsAreNamed) {
  const auto fails_with = [](const HatchOptions& options, const std::string& name) {
    try {
      validate(options);
    } catch (const InvalidInput& error) {
      return std::string(error.what()).find(name) != std::string::npos;
    }
    return false;
  };
  HatchOptions options;
  EXPECT_NO_THROW(validate(options));
  options.spacing_px = 0.5;
  EXPECT_TRUE(fails_with(options, "spacing_px"));
  options = {};
  options.test_factor = std::nan("");
  EXPECT_TRUE(fails_with(options, "test_factor"));
  options = {};
  options.max_length_px = 1e9;
  EXPECT_TRUE(fails_with(options, "max_length_px"));
}

// --- reduction
// ------------------------------------------------------------------------------------

TEST(ReduceHatches, OneFamilyIsLeftInMidtones) {
  Scene scene = plane_scene();
  scene.tone = uniform_tone(scene.visible, Tone::midtone);
  const Hatches all = scene.place(), left = scene.reduce(all);
  check_hatches(scene, left);
  EXPECT_LT(left.curves.size(), all.curves.size());
  EXPECT_GT(least_distance(left, perpendicular), 2 * 8);
  const Vec3 kept = tangent_at(left.curves[0], 1);
  EXPECT_LT(worst_gap(scene, left, kept), 8) << "and it is whole";
  for (const Kind kind : left.kinds) EXPECT_EQ(kind, Kind::hatch);
}

TEST(ReduceHatches, ShadowsKeepBothAndDeletedHatchesAreClippedToThem) {
  Scene scene = plane_scene();
  for (int cell = 0; cell < 240 * 240; ++cell) {
    if (cell % 240 >= 120 && scene.tone.level[cell] == Tone::shadow) {
      scene.tone.level[cell] = Tone::midtone;
    }
  }
  const Hatches left = scene.reduce(scene.place());
  check_hatches(scene, left);
  Hatches in_midtone;
  double crossed_px = 0;
  for (std::size_t h = 0; h < left.curves.size(); ++h) {
    for (const HatchPoint& point : left.curves[h]) {
      EXPECT_TRUE(left.kinds[h] != Kind::cross_hatch || point.image.x() < 120);
      if (point.image.x() >= 120) in_midtone.curves.push(point);
      crossed_px += point.image.x() < 120;
    }
    if (in_midtone.curves.values.size() >
        static_cast<std::size_t>(in_midtone.curves.offsets.back())) {
      in_midtone.curves.close_list();
    }
  }
  EXPECT_GT(least_distance(in_midtone, perpendicular), 2 * 8);
  EXPECT_GT(in_midtone.curves.values.size(), 500U);
  EXPECT_NEAR(crossed_px / double(in_midtone.curves.values.size()), 2, 0.4);
}

TEST(ReduceHatches, CriticalCurvesKeepRegionsApart) {
  Scene scene = plane_scene();
  scene.tone = uniform_tone(scene.visible, Tone::midtone);
  // One hatch runs beside the crease on its left, the other away from it on its right.
  scene.add_arc(Kind::crease, {Vec3(0, -1.1, 0), Vec3(0, 1.1, 0)});
  Hatches pair;
  const VisibleImage& visible = scene.visible;
  const auto add = [&](const Vec3& from, const Vec3& to) {
    for (int i = 0; i <= 20; ++i) {
      const Vec3 p = from + (to - from) * i / 20.0;
      const Vec2 image = scene.camera.project(p).xy;
      const SurfacePoint on = surface_point_under(scene.surface, scene.camera,
                                                  visible.triangle[visible.cell_of(image)], image);
      pair.curves.push({p, on, image});
    }
    pair.curves.close_list();
    pair.kinds.push_back(Kind::hatch);
    pair.objects.push_back(0);
  };
  add(Vec3(-0.03, -0.1, 0), Vec3(-0.03, 0.1, 0));
  add(Vec3(0.03, 0, 0), Vec3(0.23, 0, 0));
  EXPECT_LT(least_distance(scene.reduce(pair), perpendicular), 7);
  scene.graph.arcs[0].invisibility = 1;
  EXPECT_GE(least_distance(scene.reduce(pair), perpendicular), 2 * 8 - 1e-9)
      << "a hidden crease keeps nothing apart";
}

}  // namespace
}  // namespace illustrate
