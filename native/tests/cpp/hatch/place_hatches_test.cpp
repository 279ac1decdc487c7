#include <gtest/gtest.h>

#include "core/errors.h"
#include "hatch/greedy/place_hatches.h"
#include "tests/cpp/hatch/hatch_scene.h"

namespace illustrate {
namespace {

using namespace hatching;

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
  check_ends_at_column(hatches, scene.camera.project(Vec3(0.013, 0, 0)).xy.x());
}

// Seen obliquely, with creases all round: hatches leave the edges at a slant.
TEST(PlaceHatches, FlatFacesHaveEvenHatchesFromEdgeToEdge) {
  Scene scene = scene_of(shapes::plain_surface(shapes::plane(2, 2)),
                         cameras::orthographic(Vec3(1, 0.5, 1), 1.5, 400),
                         [](const Vec3&) { return Vec3(0.8, 0.6, 0); });
  const std::array<Vec3, 4> corners{Vec3(-1, -1, 0), Vec3(1, -1, 0), Vec3(1, 1, 0), Vec3(-1, 1, 0)};
  for (int k = 0; k < 4; ++k) scene.add_arc(Kind::crease, {corners[k], corners[(k + 1) % 4]});
  const Hatches hatches = scene.place();
  check_hatches(scene, hatches);
  int broken = 0;
  for (std::size_t h = 0; h < hatches.curves.size(); ++h) {
    const auto curve = hatches.curves[h];
    for (const Vec3& end : {curve.front().position, curve.back().position}) {
      broken += std::max(std::abs(end.x()), std::abs(end.y())) < 0.999;
    }
    double nearest = 1e9;
    for (std::size_t other = 0; other < hatches.curves.size(); ++other) {
      if (other == h || !parallel(tangent_at(curve, 0), tangent_at(hatches.curves[other], 0)))
        continue;
      for (const HatchPoint& point : hatches.curves[other]) {
        nearest = std::min(nearest, (point.image - curve[curve.size() / 2].image).norm());
      }
    }
    EXPECT_GT(nearest, 0.8 * scene.options.spacing_px);
    EXPECT_LT(nearest, 1.3 * scene.options.spacing_px);
  }
  EXPECT_EQ(broken, 0);
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
  check_limits(scene, 60.01, [&] { return scene.place(); });
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
  const std::vector<int>& objects = scene.surface.triangle_objects;
  for (const int object : objects) scene.spacing_scale.push_back(object == 0 ? 1 : 2);
  EXPECT_NEAR(lengths()[1] / lengths()[0], 0.5, 0.1);
  scene.unhatched = {1, 0};
  EXPECT_EQ(lengths()[0], 0);
  EXPECT_GT(lengths()[1], 0);
  scene.spacing_scale = {1};
  EXPECT_THROW(scene.place(), InvalidInput);
  scene.spacing_scale.assign(objects.size(), 0);
  EXPECT_THROW(scene.place(), InvalidInput);
  scene.spacing_scale = {};
  EXPECT_NO_THROW(scene.place());
  scene.families.pop_back();
  EXPECT_THROW(scene.place(), InvalidInput);
}

TEST(PlaceHatches, IsDeterministicAndCanBeCancelled) {
  Scene scene = torus_scene();
  const Hatches a = scene.place(), b = scene.place();
  expect_same_hatches(a, b);
  int calls = 0;
  const Progress progress([&](double, const std::string&) { return ++calls < 3; }, "hatch");
  EXPECT_THROW(place_hatches(scene.view(), {}, scene.counts, progress), Cancelled);
}

TEST(PlaceHatches, NothingSeenGivesNothing) {
  Scene scene = plane_scene();
  scene.tone = uniform_tone(scene.visible, Tone::highlight);
  EXPECT_TRUE(scene.place().curves.empty());
  scene.surface = Surface{};
  scene.field = CrossField{};
  scene.families = {};
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

}  // namespace
}  // namespace illustrate
