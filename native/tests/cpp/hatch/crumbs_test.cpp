#include "hatch/crumbs.h"

#include <gtest/gtest.h>

#include "tests/cpp/hatch/hatch_scene.h"

namespace illustrate {
namespace {

using namespace hatching;

// On a plane, 100 px to a unit, with hatches 8 px apart: crumbs are shorter than 16 px.
class Crumbs : public testing::Test {
 protected:
  void add(const Vec3& from, double length, Kind kind = Kind::hatch) {
    constexpr int parts = 8;
    for (int i = 0; i <= parts; ++i) {
      const Vec3 p = from + Vec3(length * i / parts, 0, 0);
      const Vec2 image = scene.camera.project(p).xy;
      const int triangle = scene.visible.triangle[scene.visible.cell_of(image)];
      hatches.curves.push(
          {p, surface_point_under(scene.surface, scene.camera, triangle, image), image});
    }
    hatches.curves.close_list();
    hatches.kinds.push_back(kind);
    hatches.objects.push_back(0);
  }

  // A hatch along y.
  void add_across(const Vec3& from, double length) {
    const std::size_t first = hatches.curves.values.size();
    add(Vec3::Zero(), length);
    for (std::size_t i = first; i < hatches.curves.values.size(); ++i) {
      HatchPoint& point = hatches.curves.values[i];
      point.position = from + Vec3(0, point.position.x(), 0);
      point.image = scene.camera.project(point.position).xy;
    }
  }

  // A crumb with long neighbours above and below, which give it company.
  void add_in_company(const Vec3& from, double length, Kind kind = Kind::hatch) {
    add(from + Vec3(-0.2, 0.08, 0), 0.6);
    add(from, length, kind);
    add(from + Vec3(-0.2, -0.08, 0), 0.6);
  }

  // All columns from `column` on become light.
  void light_from(int column) {
    for (std::size_t cell = 0; cell < scene.tone.level.size(); ++cell) {
      if (static_cast<int>(cell) % scene.tone.width >= column) {
        scene.tone.level[cell] = Tone::highlight;
      }
    }
  }

  int column_of(double x) const {
    return static_cast<int>(scene.camera.project(Vec3(x, 0, 0)).xy.x() / scene.tone.cell_px);
  }

  std::size_t count_left() {
    return without_crumbs(hatches, scene.view(), scene.options).curves.size();
  }

  Scene scene = scene_of(shapes::plain_surface(shapes::plane(13, 11)),
                         cameras::orthographic(Vec3::UnitZ(), 1.2, 240),
                         [](const Vec3&) { return Vec3(1, 0, 0); });
  Hatches hatches;
};

TEST_F(Crumbs, StayAmongOthers) {
  add_in_company(Vec3(0, 0, 0), 0.1);
  EXPECT_EQ(count_left(), 3U);
}

TEST_F(Crumbs, AreLeftToTheToneBesideThem) {
  light_from(column_of(0.12));
  scene.add_arc(Kind::crease, {Vec3(-0.02, -1, 0), Vec3(-0.02, 1, 0)});
  add_in_company(Vec3(0, 0, 0), 0.1);
  EXPECT_EQ(count_left(), 2U);
}

TEST_F(Crumbs, StayBetweenCriticalCurves) {
  for (const double x : {-0.02, 0.12}) {
    scene.add_arc(Kind::crease, {Vec3(x, -1, 0), Vec3(x, 1, 0)});
  }
  add(Vec3(0, 0.08, 0), 0.1);
  add(Vec3(0, 0, 0), 0.1);
  add(Vec3(0, -0.08, 0), 0.1);
  EXPECT_EQ(count_left(), 3U);
}

TEST_F(Crumbs, StubsInNarrowGapsGo) {
  add(Vec3(-0.2, 0.06, 0), 0.6);
  add(Vec3(0, 0, 0), 0.1);
  add(Vec3(0, 0.12, 0), 0.1);
  EXPECT_EQ(count_left(), 1U) << "beside a long hatch, whatever is on the other side";
  add(Vec3(0.4, 0.12, 0), 0.1);
  add(Vec3(0.4, 0.18, 0), 0.1);
  add(Vec3(0.4, 0.24, 0), 0.1);
  EXPECT_EQ(count_left(), 4U) << "no long one is beside those beyond its end";
}

TEST_F(Crumbs, RungsGo) {
  scene.add_arc(Kind::crease, {Vec3(-0.02, -1, 0), Vec3(-0.02, 1, 0)});
  for (const double y : {-0.08, 0.0, 0.08}) add(Vec3(0, y, 0), 0.1);
  add_across(Vec3(0.16, -0.3, 0), 0.6);
  EXPECT_EQ(count_left(), 4U) << "in shadows hatches cross";
  for (Tone& level : scene.tone.level) level = Tone::midtone;
  EXPECT_EQ(count_left(), 1U);
}

TEST_F(Crumbs, LoneTicksGo) {
  add(Vec3(0, 0, 0), 0.3);
  EXPECT_EQ(count_left(), 0U) << "shorter than four spacings";
  add(Vec3(0, 0.5, 0), 0.4);
  EXPECT_EQ(count_left(), 1U);
}

TEST_F(Crumbs, UndercutsHaveASpacingOfTheirOwn) {
  add_in_company(Vec3(0, 0, 0), 0.12, Kind::undercut);
  light_from(0);
  for (std::size_t cell = 0; cell < scene.tone.band.size(); ++cell) {
    const int column = static_cast<int>(cell) % scene.tone.width;
    if (column >= column_of(0) && column <= column_of(0.12)) {
      scene.tone.band[cell] = Band::undercut;
    }
  }
  EXPECT_EQ(count_left(), 3U) << "12 px are more than two spacings of 5";
}

// Undercuts 5 px apart: a hundred pixels of them side by side are twenty spacings.
TEST_F(Crumbs, SpecksOfUndercutGo) {
  for (const int count : {3, 4}) {
    hatches = {};
    for (int i = 0; i < count; ++i) add(Vec3(0, 0.05 * i, 0), 0.3, Kind::undercut);
    EXPECT_EQ(count_left(), count == 3 ? 0U : 4U) << 30 * count << " px";
  }
  for (int i = 0; i < 3; ++i) add(Vec3(0.5, 0.05 * i, 0), 0.3, Kind::undercut);
  EXPECT_EQ(count_left(), 4U) << "a patch alone";
  add(Vec3(0.2, -0.05, 0), 0.5);
  add(Vec3(0.2, -0.13, 0), 0.5);
  EXPECT_EQ(count_left(), 9U) << "beside hatches it is part of a whole";
}

TEST_F(Crumbs, WhatLiesInUndercutsIsOfThatKind) {
  add(Vec3(0, 0, 0), 0.1);
  add(Vec3(0.06, 0.1, 0), 0.1);
  for (std::size_t cell = 0; cell < scene.tone.band.size(); ++cell) {
    if (static_cast<int>(cell) % scene.tone.width < column_of(0.1)) {
      scene.tone.band[cell] = Band::undercut;
    }
  }
  mark_undercuts(hatches, scene.tone);
  EXPECT_EQ(hatches.kinds, (std::vector<Kind>{Kind::undercut, Kind::hatch}));
}

}  // namespace
}  // namespace illustrate
