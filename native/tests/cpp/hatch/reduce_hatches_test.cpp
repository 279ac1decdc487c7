#include <gtest/gtest.h>

#include "hatch/reduce_hatches.h"
#include "tests/cpp/hatch/hatch_scene.h"

namespace illustrate {
namespace {

using namespace hatching;

TEST(ReduceHatches, OneFamilyIsLeftInMidtones) {
  Scene scene = plane_scene();
  const Hatches both = scene.place();
  scene.tone = uniform_tone(scene.visible, Tone::midtone);
  const Hatches all = scene.place(), left = scene.reduce(all);
  check_hatches(scene, left);
  EXPECT_LT(double(all.curves.size()), 0.6 * double(both.curves.size())) << "one is not placed";
  EXPECT_EQ(left.curves.size(), all.curves.size());
  EXPECT_GT(least_distance(left, perpendicular), 2 * 8);
  const Vec3 kept = tangent_at(left.curves[0], 1);
  EXPECT_LT(worst_gap(scene, left, kept), 8) << "and it is whole";
  for (const Kind kind : left.kinds) EXPECT_EQ(kind, Kind::hatch);
}

// On a ring the strokes stay that run round its tube.
TEST(ReduceHatches, OneDirectionRoundTheFormInAllOfARegion) {
  Scene scene = torus_scene();
  scene.tone = uniform_tone(scene.visible, Tone::midtone);
  const Hatches all = scene.place(), left = scene.reduce(all);
  check_hatches(scene, left);
  double round_tube_px = 0, all_px = 0;
  for (std::size_t h = 0; h < left.curves.size(); ++h) {
    const auto curve = left.curves[h];
    for (std::size_t i = 1; i < curve.size(); ++i) {
      const double length = (curve[i].image - curve[i - 1].image).norm();
      const double along =
          std::abs(tangent_at(curve, i).dot(round_z(curve[i].position).normalized()));
      round_tube_px += along < 0.7 ? length : 0;
      all_px += length;
    }
  }
  EXPECT_GT(round_tube_px, 0.98 * all_px);
  double placed_px = 0;
  for (std::size_t h = 0; h < all.curves.size(); ++h) placed_px += length_px(all.curves[h]);
  EXPECT_GT(all_px, 0.4 * placed_px) << "and no part of it is white";
}

TEST(ReduceHatches, LonelySpecksAreDroppedOutsideUndercuts) {
  Scene scene = plane_scene();
  Hatches specks;
  const auto add = [&](const Vec3& from, double length) {
    for (int i = 0; i <= 8; ++i) {
      const Vec3 p = from + Vec3(length * i / 8, 0, 0);
      const Vec2 image = scene.camera.project(p).xy;
      const int triangle = scene.visible.triangle[scene.visible.cell_of(image)];
      specks.curves.push(
          {p, surface_point_under(scene.surface, scene.camera, triangle, image), image});
    }
    specks.curves.close_list();
    specks.kinds.push_back(Kind::hatch);
    specks.objects.push_back(0);
  };
  add(Vec3(-0.5, 0.5, 0), 0.10);  // alone
  add(Vec3(0.0, 0.0, 0), 0.50);   // long
  add(Vec3(0.0, 0.08, 0), 0.10);  // beside it
  add(Vec3(0.5, -0.5, 0), 0.10);  // in an undercut
  const int undercut = scene.visible.cell_of(scene.camera.project(Vec3(0.55, -0.5, 0)).xy);
  for (int column = -20; column <= 20; ++column) {
    scene.tone.band[undercut + column] = Band::undercut;
  }
  const Hatches left = scene.reduce(specks);
  ASSERT_EQ(left.curves.size(), 3U);
  for (int h = 0; h < 3; ++h) {
    EXPECT_EQ(left.curves[h].front().position, specks.curves[h + 1].front().position);
  }
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

TEST(ReduceHatches, NothingIsCrossedInSpecksOfShadow) {
  Scene scene = plane_scene();
  const auto distance_across = [&](int low, int high) {
    scene.tone = uniform_tone(scene.visible, Tone::midtone);
    for (int row = low; row < high; ++row) {
      for (int column = low; column < high; ++column) {
        scene.tone.level[scene.visible.index(column, row)] = Tone::shadow;
      }
    }
    return least_distance(scene.reduce(scene.place()), perpendicular);
  };
  EXPECT_GT(distance_across(110, 120), 2 * 8) << "a spacing and a quarter wide";
  EXPECT_LT(distance_across(90, 140), 1);
}

// The square with the other family in its right half.
TEST(ReduceHatches, HatchesThatEndAtASeamGiveWay) {
  Scene scene = plane_scene();
  scene.tone = uniform_tone(scene.visible, Tone::midtone);
  for (std::size_t v = 0; v < scene.families.size(); ++v) {
    scene.families[v] = scene.surface.positions[v].x() > 0 ? 1 : -1;
  }
  const Hatches all = scene.even(), left = scene.reduce(all);
  EXPECT_LT(least_distance(all, perpendicular), 6);
  EXPECT_GE(least_distance(left, perpendicular), 8);
  double all_px = 0, left_px = 0, worst = 0;
  for (std::size_t h = 0; h < all.curves.size(); ++h) all_px += length_px(all.curves[h]);
  for (std::size_t h = 0; h < left.curves.size(); ++h) left_px += length_px(left.curves[h]);
  EXPECT_GT(left_px, 0.94 * all_px);
  for (double y = -0.8; y < 0.8; y += 0.02) {
    const Vec2 p = scene.camera.project(Vec3(0, y, 0)).xy;
    double nearest = 1e9;
    for (const HatchPoint& q : left.curves.values)
      nearest = std::min(nearest, (q.image - p).norm());
    worst = std::max(worst, nearest);
  }
  EXPECT_LT(worst, 1.5 * 8) << "no white lane";
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
  EXPECT_GE(least_distance(scene.reduce(pair), perpendicular), 8)
      << "a hidden crease keeps nothing apart";
}

}  // namespace
}  // namespace illustrate
