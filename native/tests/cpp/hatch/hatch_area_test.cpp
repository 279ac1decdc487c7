#include "hatch/view/hatch_area.h"

#include <gtest/gtest.h>

#include "tests/cpp/hatch/hatch_scene.h"

namespace illustrate {
namespace {

using namespace hatching;

// How many of the two families may run in the middle of a plane whose normal is so far off the
// line of sight. The cross stands `turn_deg` off the axis round which the plane is turned.
int families_on(double tilt_deg, double turn_deg, Band band) {
  const double tilt = tilt_deg * pi / 180, turn = turn_deg * pi / 180;
  Scene scene = scene_of(shapes::plain_surface(shapes::plane(13, 11)),
                         cameras::orthographic(Vec3(0, -std::sin(tilt), std::cos(tilt)), 1.2, 240),
                         [&](const Vec3&) { return Vec3(std::cos(turn), std::sin(turn), 0); });
  std::fill(scene.tone.band.begin(), scene.tone.band.end(), band);
  const HatchScene view = scene.view();
  const HatchArea area(view);
  const Vec2 middle(120, 120);
  const SurfacePoint on = area.visible_point(middle);
  const HatchPoint point{position_at(scene.surface, on), on, middle};
  const Vec3 along(std::cos(turn), std::sin(turn), 0), across(-along.y(), along.x(), 0);
  return area.suits(point, along) + area.suits(point, across);
}

// At 45 degrees to the axis two families cross at 2 atan(cos(tilt)).
TEST(HatchArea, UndercutsHaveOneFamilyWhereTwoWouldCrossNarrowly) {
  EXPECT_EQ(families_on(60, 45, Band::undercut), 2) << "53 degrees";
  EXPECT_EQ(families_on(65, 45, Band::undercut), 1) << "46 degrees";
  EXPECT_EQ(families_on(80, 45, Band::undercut), 1);
  EXPECT_EQ(families_on(80, 0, Band::undercut), 2) << "at right angles, however it is turned";
  EXPECT_EQ(families_on(80, 45, Band::nothing), 2) << "shadows have room for both";
}

}  // namespace
}  // namespace illustrate
