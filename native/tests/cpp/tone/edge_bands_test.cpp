#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/cpp/cameras.h"
#include "tests/cpp/shapes.h"
#include "tests/cpp/tone/toned.h"

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
  int undercuts(double from, double to) const { return undercuts(edge(from, to)); }

  // The same with a crease on the floor, so many pixels beyond the edge.
  int undercuts_before_crease(double from, double to, double beyond_px) const {
    LabelledGraph graph = edge(from, to);
    const double x = -height_ - std::sqrt(2.0) * beyond_px * 2 / side_px;
    graph.nodes.resize(4);
    add(graph, {Kind::crease, 0, 1, 2, 3, 0, 1, 1}, Vec3(x, from, 0), Vec3(x, to, 0));
    return undercuts(graph);
  }

 private:
  int undercuts(const LabelledGraph& graph) const {
    const VisibleImage visible = render_visible(surface_, camera_, 1, {}, 1);
    const ToneMap tone = toned({surface_, visible, camera_, {}}, graph);
    return static_cast<int>(std::count(tone.band.begin(), tone.band.end(), Band::undercut));
  }

  LabelledGraph edge(double from, double to) const {
    LabelledGraph graph;
    graph.nodes.resize(2);
    const Vec3 a(0, from, height_), b(0, to, height_);
    const Vec2 along = camera_.project(b).xy - camera_.project(a).xy;
    const Vec2 to_plate = camera_.project(a + Vec3(0.1, 0, 0)).xy - camera_.project(a).xy;
    const bool plate_is_left = along.x() * to_plate.y() - along.y() * to_plate.x() < 0;
    GraphArc arc{Kind::boundary, 0, 0, 0, 1};
    (plate_is_left ? arc.left_layers : arc.right_layers) = 1;
    add(graph, arc, a, b);
    return graph;
  }

  void add(LabelledGraph& graph, const GraphArc& arc, const Vec3& a, const Vec3& b) const {
    graph.arcs.push_back(arc);
    for (const Vec3& p : {a, b}) {
      graph.points.push({p, {}});
      graph.image.push(camera_.project(p).xy);
    }
    graph.points.close_list();
    graph.image.close_list();
  }

  Camera camera_;
  Surface surface_;
  double height_;
};

TEST(EdgeBands, AnEdgeHighAboveAFloorHasAnUndercut) {
  EXPECT_GT(Step(0.5).undercuts(-0.5, 0.5), 10 * side_px / 4);
}

// Half way to the crease the undercut ends.
TEST(EdgeBands, AnUndercutDoesNotReachOverACrease) {
  const Step step(0.5);
  const double length_px = side_px / 2.0;
  EXPECT_NEAR(step.undercuts_before_crease(-0.5, 0.5, 8), 4 * length_px, length_px);
  EXPECT_EQ(step.undercuts_before_crease(-0.5, 0.5, 60), step.undercuts(-0.5, 0.5));
}

TEST(EdgeBands, AFloorThatRecedesIsNoUndercutOfWhatHardlyStandsOut) {
  EXPECT_EQ(Step(0.02).undercuts(-0.5, 0.5), 0);
}

}  // namespace
}  // namespace illustrate
