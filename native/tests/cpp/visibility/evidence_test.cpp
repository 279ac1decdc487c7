#include "visibility/evidence/evidence.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "pipeline/draw.h"
#include "tests/cpp/cameras.h"
#include "tests/cpp/shapes.h"
#include "visibility/label_network.h"

namespace illustrate {
namespace {

using cameras::one_px;

constexpr int arc_count = 40, short_arc = 11, wrong_cusp = 21;

Surface square_at(double low_x, double high_x, double z) {
  PolygonMesh mesh = shapes::plane(1, 1);
  const double middle = (low_x + high_x) / 2, half = (high_x - low_x) / 2;
  for (Vec3& p : mesh.positions) p = Vec3(middle + half * p.x(), 150 * p.y(), z);
  return shapes::plain_surface(mesh);
}

// A comb over a floor with its rim, and between them lines that pass below one tooth after the
// other: every other arc is hidden, and each arc ends in a cusp. Paths: the rim, then the lines.
struct Comb {
  CurveNetwork network;
  Surface surface = square_at(-300, 300, -50);

  Comb() {
    for (int i = 1; i < arc_count; i += 2)
      surface = shapes::joined(surface, square_at(start(i), start(i + 1), 50));
    for (const Vec2& p : {Vec2(-300, -150), Vec2(300, -150), Vec2(300, 150), Vec2(-300, 150)})
      network.points.push({{p.x(), p.y(), -50}, {}});
    network.points.close_list();
    network.strands.push_back({Kind::boundary, 0, none, none, 1, 0});
  }

  static double start(int arc) { return 10 * arc - 200 - (arc > short_arc ? 8 : 0); }

  // `wrong`: the cusp whose change has the other sign.
  void add_line(double y, int wrong) {
    const int first_node = static_cast<int>(network.nodes.size());
    const int first = static_cast<int>(network.strands.size());
    for (int i = 0; i <= arc_count; ++i)
      network.nodes.push_back({NodeKind::cusp, {start(i), y, 0}});
    for (int i = 0; i < arc_count; ++i) {
      network.points.push({{start(i), y, 0}, {}});
      network.points.push({{start(i + 1), y, 0}, {}});
      network.points.close_list();
      network.strands.push_back({Kind::boundary, 0, first_node + i, first_node + i + 1, 1, 0});
      const int jump = (i % 2 == 1) == (i != wrong) ? 1 : -1;
      if (i > 0) network.ties.push_back({first_node + i, first + i - 1, first + i, jump});
    }
  }
};

int asked(const std::vector<Evidence>& evidence) {
  return static_cast<int>(std::count_if(evidence.begin(), evidence.end(),
                                        [](const Evidence& e) { return e.weight > 0; }));
}

TEST(AskAllArcs, AsksThoseOfItsPathsThatAreNotKnown) {
  Comb comb;
  comb.add_line(0, none);
  comb.add_line(50, none);
  const Bvh bvh(comb.surface.positions, comb.surface.triangles);
  const Arrangement arrangement = arrange(comb.network, one_px);
  const std::vector<std::vector<PathArc>> arcs = arcs_of_paths(arrangement);
  const Insets insets;
  LayerRays rays(comb.surface, bvh, one_px, insets);
  auto evidence = gather_evidence(arrangement, arcs, rays, 1, {});
  ASSERT_EQ(evidence.size(), 3u);
  const int few = asked(evidence[2]);
  EXPECT_LT(few, arc_count / 2);
  evidence[1][0] = {7, 0, 3, false};
  ask_all_arcs({1}, arrangement, arcs, rays, 1, {}, evidence);
  EXPECT_EQ(asked(evidence[1]), arc_count);
  EXPECT_EQ(evidence[1][0].layers, 7);
  for (int i = 1; i < arc_count; ++i) EXPECT_EQ(evidence[1][idx(i)].layers, i % 2) << i;
  EXPECT_EQ(asked(evidence[2]), few);
}

// No label is negative, so a rule of the path gives way. The few arcs that are asked at first leave
// open which, and the cusp beside the short arc costs least.
TEST(AskAllArcs, TellsWhichChangeOfALongPathIsWrong) {
  Comb comb;
  comb.add_line(0, wrong_cusp);
  const Bvh bvh(comb.surface.positions, comb.surface.triangles);
  Counts counts;
  const LabelledGraph graph =
      label_network(comb.network, comb.surface, bvh, one_px, counts, {}, 1, {});
  EXPECT_EQ(counts["repairs"], 1);
  ASSERT_EQ(graph.arcs.size(), idx(arc_count + 1));
  for (const GraphArc& arc : graph.arcs) {
    const int number = arc.strand - 1;  // behind the rim
    EXPECT_EQ(arc.invisibility, arc.strand > 0 ? number % 2 : 0) << number;
  }
}

// A bar with a thin wall along its side, and close behind that a ridge that is not as high.
PolygonMesh walled_bar() {
  const std::vector<Vec2> profile{{0, 0},        {0, 1},        {-0.005, 1}, {-0.005, 0.2},
                                  {-0.015, 0.8}, {-0.025, 0.2}, {-1, 0.2},   {-1, 0}};
  const int count = static_cast<int>(profile.size());
  std::vector<Vec3> corners;
  for (const double y : {-1., 1.})
    for (const Vec2& p : profile) corners.emplace_back(p.x(), y, p.y());
  std::vector<std::vector<int>> faces(2);
  for (int i = 0; i < count; ++i) {
    const int next = (i + 1) % count;
    faces[0].push_back(count - 1 - i);
    faces[1].push_back(count + i);
    faces.push_back({i, next, count + next, count + i});
  }
  PolygonMesh bar = shapes::polygon_mesh(corners, faces);
  bar.crease_angle_deg = 180;
  return bar;
}

// Contours of smooth objects lie beside their triangles, which tell nothing from near; edges do
// not.
TEST(LayerRays, ASilhouetteOfPolygonsIsHiddenByWhatIsClose) {
  PrepareOptions options;
  options.field = false;
  options.surface.scheme = Scheme::polygons;
  const auto prepared = prepare({std::make_shared<PolygonMesh>(walled_bar())}, options);
  DrawOptions lines;
  lines.hatching = false;
  const Camera camera = cameras::orthographic({1, 0.15, 0.05}, 1.2);
  const LabelledGraph graph = draw(*prepared, camera, lines, {}).graph;
  int ridges = 0;
  for (std::size_t a = 0; a < graph.arcs.size(); ++a) {
    const Vec3 middle = (graph.points[a][0].position + graph.points[a].back().position) / 2;
    const bool is_ridge = std::abs(middle.x() + 0.015) < 1e-6 && std::abs(middle.z() - 0.8) < 1e-6;
    if (!is_ridge) continue;
    ++ridges;
    EXPECT_EQ(graph.arcs[a].kind, Kind::silhouette);
    EXPECT_GT(graph.arcs[a].invisibility, 0);
  }
  EXPECT_GT(ridges, 0);
}

}  // namespace
}  // namespace illustrate
