#include <gtest/gtest.h>

#include <random>

#include "contour/network/network.h"
#include "tests/cpp/cameras.h"
#include "tests/cpp/check_graph.h"
#include "tests/cpp/shapes.h"
#include "visibility/arrangement/crossings.h"
#include "visibility/build_graph.h"
#include "visibility/evidence/outline.h"
#include "visibility/label_network.h"
#include "visibility/labels/repairs.h"
#include "visibility/labels/swallowtails.h"
#include "visibility/labels/view_labels.h"

namespace illustrate {
namespace {

LabelledGraph graph_of(const Surface& surface, const Camera& camera, Counts& counts) {
  const Bvh bvh(surface.positions, surface.triangles);
  const IntersectionCurves crossings = intersections(surface, bvh, counts);
  const CurveNetwork network = build_network(
      {surface, LimitSurface(surface), feature_edges(surface), crossings}, camera, {}, counts);
  LabelledGraph graph = label_network(network, surface, bvh, camera, counts);
  check_graph(graph);
  return graph;
}

int most_hidden(const LabelledGraph& graph) {
  int most = 0;
  for (const GraphArc& arc : graph.arcs) most = std::max(most, arc.invisibility);
  return most;
}

TEST(Orientation, TiesAreSettledByIndexAndKeepTheParity) {
  const GridPoint a{0, 0, 3}, b{0, 0, 1}, c{0, 0, 2};
  EXPECT_NE(orientation(a, b, c), 0);
  EXPECT_EQ(orientation(a, b, c), -orientation(b, a, c));
  EXPECT_EQ(orientation(a, b, c), orientation(b, c, a));
}

// Any two closed polygons cross an even number of times, also on a grid so coarse that everything
// touches.
TEST(Crossings, OfClosedCurvesAreEvenInNumber) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 300; ++trial) {
    CurveNetwork network;
    ImageStrands strands;
    for (int s = 0; s < 2; ++s) {
      for (int i = 0; i < 7; ++i) {
        const std::int64_t x = random() % 4, y = random() % 4;
        network.points.push({Vec3::Zero(), {}});
        strands.image.emplace_back(x, -y);
        strands.depth.push_back(s);
        strands.grid.push_back({x, y, static_cast<int>(strands.grid.size())});
      }
      network.points.close_list();
      network.strands.push_back({});
    }
    strands.places = strands.grid;
    strands.decided_depth = strands.depth;
    int between = 0;
    const std::vector<Crossing> crossings = *find_crossings(network, strands);
    for (const Crossing& c : crossings) {
      between += c.front.strand != c.back.strand;
    }
    EXPECT_EQ(between % 2, 0);
  }
}

void add_square(CurveNetwork& network, ImageStrands& strands, double half) {
  for (const Vec2& p :
       {Vec2(-half, -half), Vec2(half, -half), Vec2(half, half), Vec2(-half, half)}) {
    network.points.push({Vec3::Zero(), {}});
    strands.image.push_back(p);
  }
  network.points.close_list();
  network.strands.push_back({});
}

const Eigen::AlignedBox2d everywhere(Vec2(-1000, -1000), Vec2(1000, 1000));

TEST(Outline, IsTheOuterOfTwoNestedSquares) {
  CurveNetwork network;
  ImageStrands strands;
  add_square(network, strands, 10);
  add_square(network, strands, 30);
  const std::vector<std::vector<StrandPlace>> outline =
      outline_places(network, strands, everywhere, {});
  EXPECT_TRUE(outline[0].empty());
  EXPECT_EQ(outline[1].size(), 4U) << "each of its sides";
}

TEST(Outline, IsNothingWithinWhatIsCutOff) {
  CurveNetwork network;
  ImageStrands strands;
  add_square(network, strands, 30);
  const std::vector<ImageSegment> cuts{{Vec2(-50, -40), Vec2(50, -40)},
                                       {Vec2(50, -40), Vec2(0, 300)},
                                       {Vec2(0, 300), Vec2(-50, -40)}};
  EXPECT_EQ(outline_places(network, strands, everywhere, {cuts[0]})[0].size(), 4U);
  EXPECT_TRUE(outline_places(network, strands, everywhere, cuts)[0].empty());
}

// From a joint over a cusp `reach_px` away to a far end.
CurveNetwork cusp_near_an_end(double reach_px) {
  const Points places{{0, 0, 0}, {reach_px, 0, 0}, {-50, 3, 0}};
  CurveNetwork network;
  for (const Vec3& p : places) network.nodes.push_back({NodeKind::joint, p});
  network.nodes[1].kind = NodeKind::cusp;
  for (const int s : {0, 1}) {
    for (const int node : {s, s + 1}) network.points.push({places[idx(node)], {}});
    network.points.close_list();
    network.strands.push_back({Kind::silhouette, 0, s, s + 1, 2, 0});
  }
  network.ties = {{1, 0, 1, 1}};
  return network;
}

TEST(Swallowtails, CuspsAtTheEndOfAnOpenPathAreDropped) {
  for (const double reach_px : {0.01, 0.5}) {
    const CurveNetwork network = cusp_near_an_end(reach_px);
    Arrangement arrangement = arrange(network, cameras::one_px);
    ASSERT_EQ(arrangement.paths()[0].jumps, (std::vector<int>{0, 1}));
    double moved_px = 0;
    const bool at_end = reach_px < 0.1;
    EXPECT_EQ(collapse_swallowtails(arrangement, moved_px), at_end ? 1 : 0);
    EXPECT_EQ(arrangement.paths()[0].jumps[1], at_end ? 0 : 1);
    EXPECT_NEAR(moved_px, at_end ? reach_px : 0, 1e-9);
  }
}

// The inner one stands out in five spikes, each narrower than the scan lines are apart.
TEST(Outline, HasWhatStandsOutBetweenScanLines) {
  CurveNetwork network;
  ImageStrands strands;
  add_square(network, strands, 30);
  std::vector<Vec2> inner{Vec2(-29.98, -29.98), Vec2(29.98, -29.98)};
  std::vector<int> tips;
  for (const double y : {-20.03, -10.41, 0.17, 10.71, 20.33}) {
    inner.emplace_back(29.98, y - 0.06);
    tips.push_back(static_cast<int>(inner.size()));
    inner.emplace_back(30.2, y);
    inner.emplace_back(29.98, y + 0.06);
  }
  inner.emplace_back(29.98, 29.98);
  inner.emplace_back(-29.98, 29.98);
  for (const Vec2& p : inner) {
    network.points.push({Vec3::Zero(), {}});
    strands.image.push_back(p);
  }
  network.points.close_list();
  network.strands.push_back({});
  const std::vector<std::vector<StrandPlace>> outline =
      outline_places(network, strands, everywhere, {});
  for (const int tip : tips) {
    EXPECT_TRUE(std::any_of(outline[1].begin(), outline[1].end(), [&](const StrandPlace& place) {
      return place.segment == tip || place.segment == tip - 1;
    })) << tip;
  }
}

// A curve with points at one place turns there into every direction without crossing itself.
TEST(Crossings, AreNoneWherePointsOfACurveCoincide) {
  const Camera camera = cameras::orthographic(Vec3(0, 0, 1), 1);
  for (int direction = 0; direction < 16; ++direction) {
    const double angle = pi * (direction + 0.3) / 8;
    for (const double side : {-0.5, 0.5}) {
      CurveNetwork network;
      network.nodes = {{NodeKind::end, Vec3::Zero()}, {NodeKind::end, Vec3::Zero()}};
      const Vec3 corner(0.1, 0.2, 0);
      const Vec3 end = corner + 0.3 * Vec3(std::cos(angle), std::sin(angle), 0);
      for (const Vec3& p : {Vec3(side, 0.1, 0), corner, corner, corner, end}) {
        network.points.push({p, {}});
      }
      network.points.close_list();
      network.strands.push_back({Kind::silhouette, 0, 0, 1, 2, 0});
      EXPECT_TRUE(find_crossings(network, project_strands(network, camera))->empty()) << direction;
    }
  }
}

TEST(Labels, OfASphereAreZero) {
  Counts counts;
  const LabelledGraph graph = graph_of(shapes::sphere_surface(1, 4),
                                       cameras::perspective(Vec3(3, 2, 1), Vec3::Zero()), counts);
  EXPECT_EQ(graph.arcs.size(), 1U);
  EXPECT_EQ(most_hidden(graph), 0);
}

TEST(Labels, BehindAnotherSphereAreTwo) {
  Surface pair = shapes::joined(shapes::sphere_surface(1, 4, Vec3(0, 0, 0)),
                                shapes::sphere_surface(1, 4, Vec3(0.9, 5, 0.3)));
  Counts counts;
  const LabelledGraph graph = graph_of(pair, cameras::orthographic(Vec3(0, -1, 0), 3), counts);
  EXPECT_EQ(counts["crossings"], 2);
  EXPECT_EQ(most_hidden(graph), 2);
  EXPECT_EQ(counts["unbalanced_loops"], 0);
}

TEST(Labels, OfANestedSphereComeFromARay) {
  Surface pair = shapes::joined(shapes::sphere_surface(1, 4, Vec3(0, 0, 0)),
                                shapes::sphere_surface(0.4, 4, Vec3(0.1, 5, 0.1)));
  Counts counts;
  const LabelledGraph graph = graph_of(pair, cameras::orthographic(Vec3(0, -1, 0), 3), counts);
  EXPECT_EQ(counts["crossings"], 0);
  EXPECT_EQ(most_hidden(graph), 2);
}

// Square, across the line of sight along y.
Surface sheet(double half, double y) {
  PolygonMesh mesh = shapes::plane(4, 4);
  for (Vec3& p : mesh.positions) p = Vec3(half * p.x(), y, half * p.y());
  return shapes::plain_surface(mesh);
}

// A ball near behind a sheet, with few triangles: how near to its own surface a ray sees nothing is
// a matter of the ball, and not of a huge wall far behind.
TEST(Labels, OfABallBehindASheetDoNotDependOnAHugeWall) {
  Surface pair = shapes::joined(shapes::sphere_surface(.4, 1), sheet(1, -.45));
  for (const bool with_wall : {false, true}) {
    if (with_wall) pair = shapes::joined(pair, sheet(1000, 1000));
    Counts counts;
    const LabelledGraph graph = graph_of(pair, cameras::orthographic(Vec3(0, -1, 0), 3), counts);
    EXPECT_EQ(most_hidden(graph), 1) << with_wall;
  }
}

// A bead behind a ball, its outline a pixel inside that of the ball: a ray two pixels beside the
// bead's outline passes by the ball too and knows nothing of it.
TEST(Labels, NearAnotherOutlineAreNotThoseBeyondIt) {
  const double pixel = 1.5 / 500, bead = 4 * pixel;
  for (int i = 0; i < 12; ++i) {
    const double angle = 2 * pi * i / 12, reach = 1 - bead - 1.4 * pixel;
    const Vec3 centre(reach * std::cos(angle), 5, reach * std::sin(angle));
    const Surface pair = shapes::joined(shapes::sphere_surface(1, 5, Vec3(0, 0, 0)),
                                        shapes::sphere_surface(bead, 2, centre));
    Counts counts;
    const LabelledGraph graph = graph_of(pair, cameras::orthographic(Vec3(0, -1, 0), 1.5), counts);
    EXPECT_EQ(counts["crossings"], 0);
    EXPECT_EQ(most_hidden(graph), 2) << "at " << angle;
  }
}

// The outline of a ball runs half a pixel within that of a ball in front of it.
TEST(Labels, HalfAPixelBesideAnotherOutlineAreTrue) {
  const double pixel = 1.5 / 500;
  const Surface pair = shapes::joined(shapes::sphere_surface(1, 6, Vec3(0, 0, 0)),
                                      shapes::sphere_surface(1 - pixel / 2, 6, Vec3(0, 5, 0)));
  Counts counts;
  const LabelledGraph graph = graph_of(pair, cameras::orthographic(Vec3(0, -1, 0), 1.5), counts);
  EXPECT_EQ(counts["crossings"], 0);
  EXPECT_EQ(most_hidden(graph), 2);
}

// R = 1, r = 0.4: the labels round the inner loop in the three regimes (method, section 4).
TEST(Labels, OfATorusAreThoseOfItsRegime) {
  const Surface torus = shapes::torus_surface(1, 0.4, 256, 128);
  const auto labels = [&](double b, std::int64_t cusps, std::int64_t crossings) {
    Counts counts;
    const Vec3 direction(std::sqrt(1 - b * b), 0.013, b);
    const LabelledGraph graph = graph_of(torus, cameras::orthographic(direction, 2), counts);
    EXPECT_EQ(counts["cusps"], cusps) << b;
    EXPECT_EQ(counts["crossings"], crossings) << b;
    EXPECT_EQ(counts["unbalanced_loops"], 0) << b;
    EXPECT_EQ(counts["loops"], 2) << b;
    return most_hidden(graph);
  };
  EXPECT_EQ(labels(0.8, 0, 0), 0);
  EXPECT_EQ(labels(0.5, 4, 2), 2);
  EXPECT_EQ(labels(0.2, 4, 0), 2);
}

// Times that the line of sight from p passes through unit spheres but `own`; -1 where p is too
// near one of them, or its contour, to tell.
int layers_before(const Vec3& p, const Vec3& towards, const Points& centres, int own) {
  constexpr double touching = 0.1;
  int layers = 0;
  for (std::size_t i = 0; i < centres.size(); ++i) {
    const double along = (centres[i] - p).dot(towards);
    const double square = along * along - (centres[i] - p).squaredNorm() + 1;
    if (static_cast<int>(i) == own || square <= 0) continue;
    const bool on_it = std::abs((centres[i] - p).norm() - 1) < 0.02;
    for (const double distance : {along - std::sqrt(square), along + std::sqrt(square)}) {
      layers += distance > touching;
      if (std::abs(on_it ? along : distance) < touching) return -1;
    }
  }
  return layers;
}

// Of the arcs long enough to have a middle clear of their ends; returns their number.
int expect_layers(const LabelledGraph& graph, const Vec3& towards, const Points& centres) {
  int asked = 0;
  for (std::size_t a = 0; a < graph.arcs.size(); ++a) {
    const GraphArc& arc = graph.arcs[a];
    if (graph.points[a].size() < 12) continue;
    const Vec3& middle = graph.points[a][graph.points[a].size() / 2].position;
    const int own = arc.kind == Kind::silhouette ? arc.object : none;
    const int layers = layers_before(middle, towards, centres, own);
    if (layers < 0) continue;
    EXPECT_EQ(arc.invisibility, layers) << middle.transpose();
    ++asked;
  }
  return asked;
}

TEST(Crossings, AreNotListedBeyondTheMost) {
  const Surface surface = shapes::torus_surface(1, 0.4, 64, 32);
  const Camera camera = cameras::orthographic(Vec3(1, 0, .45), 2);
  Counts counts;
  const CurveNetwork network = build_network(
      {surface, LimitSurface(surface), feature_edges(surface), {}}, camera, {}, counts);
  const std::size_t count = arrange(network, camera).crossings().size();
  ASSERT_GT(count, 0U);
  EXPECT_TRUE(arrange(network, camera, count).has_value());
  EXPECT_FALSE(arrange(network, camera, count - 1).has_value());
}

// Contours dive into other spheres; circles of intersection change where they meet contours and, in
// the two points that lie on three spheres, a third sphere.
TEST(Labels, OfSpheresThatPassThroughEachOtherAreTrue) {
  const Points two{{-0.5, 0, 0}, {0.5, 0.1, 0.05}};
  const Points three{{0.5, 0, 0}, {-0.25, 0.43, 0}, {-0.25, -0.43, 0.02}};
  for (const Points& centres : {two, three}) {
    Surface spheres = shapes::sphere_surface(1, 4, centres[0]);
    for (std::size_t i = 1; i < centres.size(); ++i) {
      spheres = shapes::joined(spheres, shapes::sphere_surface(1, 4, centres[i]));
    }
    for (const Vec3& direction : {Vec3(0.2, -1, 0.3), Vec3(-0.4, 0.3, 1), Vec3(1, 0.4, 0.5)}) {
      Counts counts;
      const LabelledGraph graph = graph_of(spheres, cameras::orthographic(direction, 3), counts);
      EXPECT_EQ(counts["loops"], centres.size() == 2 ? 3 : 6);
      EXPECT_EQ(counts["unbalanced_loops"], 0);
      EXPECT_EQ(counts["repairs"], 0);
      EXPECT_GE(expect_layers(graph, direction.normalized(), centres), 3);
    }
  }
}

TEST(Labels, OfAnOpenSheetChangeByOneBehindItsBoundary) {
  const Surface sheets =
      shapes::joined(shapes::plain_surface(shapes::moved(shapes::plane(4, 4), Vec3(0, 0, 0))),
                     shapes::plain_surface(shapes::moved(shapes::plane(4, 4), Vec3(0.7, 0.4, -3))));
  Counts counts;
  const LabelledGraph graph = graph_of(sheets, cameras::orthographic(Vec3(0, 0.01, 1), 3), counts);
  EXPECT_EQ(counts["crossings"], 2);
  EXPECT_EQ(most_hidden(graph), 1);
}

TEST(Labels, OfAPolygonCubeAreZeroAlongItsOutline) {
  Surface cube = shapes::plain_surface(shapes::cube());
  cube.object_is_smooth = {0};
  Counts counts;
  const LabelledGraph graph =
      graph_of(cube, cameras::perspective(Vec3(4, 5, 6), Vec3::Zero()), counts);
  EXPECT_EQ(graph.arcs.size(), 6U);
  EXPECT_EQ(most_hidden(graph), 0);
}

}  // namespace
}  // namespace illustrate
