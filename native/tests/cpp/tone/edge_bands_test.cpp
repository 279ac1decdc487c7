#include <gtest/gtest.h>

#include <algorithm>

#include "tests/cpp/cameras.h"
#include "tests/cpp/shapes.h"
#include "tone/tone_regions.h"

namespace illustrate {
namespace {

constexpr int side_px = 200;  // of the image, which shows two units

// A plate over a floor, seen aslant from the plate's side: behind its far edge, at x = 0, the floor
// recedes from the viewer by a cell of depth for each cell of the image.
class Step {
 public:
  explicit Step(double height)
      : camera_(cameras::orthographic(Vec3(1, 0, 1).normalized(), 1, side_px)),
        surface_(shapes::joined(
            shapes::plain_surface(shapes::plane(2, 2)),
            shapes::plain_surface(shapes::moved(shapes::plane(2, 2), Vec3(1, 0, height))))),
        height_(height) {}

  // Cells of the image in undercuts, where the edge is drawn between two values of y.
  int undercuts(double from, double to) const {
    const ToneMap tone = tone_regions(surface_, render_visible(surface_, camera_, 1, {}, 1),
                                      edge(from, to), camera_, {}, {});
    return static_cast<int>(std::count(tone.band.begin(), tone.band.end(), Band::undercut));
  }

 private:
  LabelledGraph edge(double from, double to) const {
    LabelledGraph graph;
    graph.nodes.resize(2);
    const Vec3 a(0, from, height_), b(0, to, height_);
    const Vec2 along = camera_.project(b).xy - camera_.project(a).xy;
    const Vec2 to_plate = camera_.project(a + Vec3(0.1, 0, 0)).xy - camera_.project(a).xy;
    const bool plate_is_left = along.x() * to_plate.y() - along.y() * to_plate.x() < 0;
    GraphArc arc{Kind::boundary, 0, 0, 0, 1};
    (plate_is_left ? arc.left_layers : arc.right_layers) = 1;
    graph.arcs.push_back(arc);
    for (const Vec3& p : {a, b}) {
      graph.points.push({p, {}});
      graph.image.push(camera_.project(p).xy);
    }
    graph.points.close_list();
    graph.image.close_list();
    return graph;
  }

  Camera camera_;
  Surface surface_;
  double height_;
};

TEST(EdgeBands, AnEdgeHighAboveAFloorHasAnUndercut) {
  EXPECT_GT(Step(0.5).undercuts(-0.5, 0.5), 10 * side_px / 4);
}

TEST(EdgeBands, AFloorThatRecedesIsNoUndercutOfWhatHardlyStandsOut) {
  EXPECT_EQ(Step(0.02).undercuts(-0.5, 0.5), 0);
}

}  // namespace
}  // namespace illustrate
