#include "hatch/streamlines/finish_streamlines.h"

#include <gtest/gtest.h>

#include "tests/cpp/hatch/hatch_scene.h"

namespace illustrate {
namespace {

using namespace hatching;

// A torus from above, and a streamline over its tube that goes on round the outline to where what
// is hidden still lies beside empty cells.
TEST(FinishStreamlines, HatchesEndWhereTheSheetTurnsAway) {
  Scene scene = scene_of(shapes::torus_surface(1, 0.4, 90, 40),
                         cameras::orthographic(Vec3::UnitZ(), 1.6, 400), round_z);
  const HatchScene data = scene.view();
  const HatchView view(data, scene.options);
  SurfacePoint on = view.area.visible_point(scene.camera.project(Vec3(1.2, 0, 0.35)).xy);
  ASSERT_NE(on.triangle, none);
  Streamline streamline{{}, 0, 8};
  Vec3 tangent(1, 0, -0.6);
  for (int i = 0; i < 12; ++i) {
    streamline.nodes.push_back(view.node(on, tangent));
    ASSERT_EQ(view.walker.on_surface().advance(on, tangent, 0.04), 0);
  }
  ASSERT_GT(view.walker.facing_at(streamline.nodes.front().on), 0);
  ASSERT_LT(view.walker.facing_at(streamline.nodes.back().on), 0);

  const Hatches hatches = finished({streamline}, view);
  ASSERT_EQ(hatches.curves.size(), 1U);
  for (const HatchPoint& point : hatches.curves[0]) EXPECT_GT(view.walker.facing_at(point.on), 0);
  const double outline = scene.camera.project(Vec3(1.4, 0, 0)).xy.x();
  EXPECT_NEAR(hatches.curves[0].back().image.x(), outline, 1);
}

}  // namespace
}  // namespace illustrate
