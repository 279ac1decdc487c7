// Mach bands and undercuts along folds by hand.
#include "tone/bands.h"

#include <gtest/gtest.h>

#include "tests/cpp/cameras.h"
#include "tests/cpp/shapes.h"
#include "tests/cpp/tone/toned.h"

namespace illustrate {
namespace {

// One straight visible arc on the line x = 0 from (0, -end, z) to (0, end, z).
LabelledGraph straight_arc(const Camera& camera, Kind kind, double z, int left, int right,
                           double end = 1) {
  LabelledGraph graph;
  graph.nodes.resize(2);
  GraphArc arc{kind, 0, 0, 0, 1};
  arc.left_layers = left;
  arc.right_layers = right;
  graph.arcs.push_back(arc);
  for (const double y : {-end, end}) {
    const Vec3 p(0, y, z);
    graph.points.push({p, {}});
    graph.image.push(camera.project(p).xy);
    graph.nodes[y < 0 ? 0 : 1].image = camera.project(p).xy;
  }
  graph.points.close_list();
  graph.image.close_list();
  return graph;
}

// A half plane x >= 0 at z = .5 before a whole one at z = 0, seen from above: 100 px per world
// unit, the fold's edge at column 100.
struct Fold {
  Camera camera = cameras::orthographic(Vec3::UnitZ(), 1, 200);
  Surface surface =
      shapes::joined(shapes::plain_surface(shapes::plane(2, 2)),
                     shapes::plain_surface(shapes::moved(shapes::plane(2, 2), Vec3(1, 0, 0.5))));
  std::vector<std::uint8_t> hidden;

  double contact = 0;
  std::vector<Light> lights;

  ToneMap tone(const LabelledGraph& graph, ToneOptions options = {}) const {
    options.undercut_contact = contact;
    const VisibleImage visible = render_visible(surface, camera, 1, hidden, 1);
    return toned({surface, visible, camera, lights}, graph, options);
  }
};

// Columns of a row that carry a band.
std::pair<int, int> columns(const ToneMap& tone, Band band, int row = 100) {
  int first = tone.width, last = -1;
  for (int i = 0; i < tone.width; ++i) {
    if (tone.band[row * tone.width + i] != band) continue;
    first = std::min(first, i);
    last = i;
  }
  return {first, last};
}

TEST(Bands, FoldHasAMachBandAndBeyondItAnUndercut) {
  const Fold fold;
  Vec2 top = fold.camera.project(Vec3(0, 1, 0)).xy, side = fold.camera.project(Vec3(1, 0, 0)).xy;
  ASSERT_LT(top.y(), 100);  // +y is up in the image, +x right: the fold is right of the arc
  ASSERT_GT(side.x(), 100);
  const ToneMap tone = fold.tone(straight_arc(fold.camera, Kind::boundary, 0.5, 0, 1));
  EXPECT_EQ(columns(tone, Band::mach_band), std::make_pair(100, 105));
  EXPECT_EQ(columns(tone, Band::undercut), std::make_pair(86, 99));

  const ToneMap wrong_side = fold.tone(straight_arc(fold.camera, Kind::boundary, 0.5, 1, 0));
  EXPECT_EQ(columns(wrong_side, Band::undercut).second, -1) << "nothing behind on the other side";
}

// The fold is half a unit in front of what lies beyond; the part's diagonal is the root of eight.
TEST(Bands, UndercutsNarrowAsTheGapGrows) {
  Fold fold;
  LabelledGraph edge = straight_arc(fold.camera, Kind::boundary, 0.5, 0, 1);
  for (CurvePoint& p : edge.points.values) {
    p.on.triangle = static_cast<int>(fold.surface.triangles.size()) - 1;
  }
  const auto width = [&](double contact) {
    fold.contact = contact;
    const auto [first, last] = columns(fold.tone(edge), Band::undercut);
    return last < 0 ? 0 : last - first + 1;
  };
  EXPECT_EQ(width(0), 14);
  EXPECT_EQ(width(0.2), 14) << "the gap is less than a fifth of what would end it";
  const double end = 0.25 * std::sqrt(8.0);
  EXPECT_NEAR(width(0.5), 14 * (1 - 0.5 / end) / 0.8, 1);
  EXPECT_EQ(width(0.7), 0);
  EXPECT_EQ(width(1), 0);
  EXPECT_EQ(columns(fold.tone(edge), Band::mach_band), std::make_pair(100, 105));
}

// The same fold: on the side of the light the gap that ends undercuts is 1 - sin 45 degrees of what
// it is without a side, on the other one 1 + sin 45 degrees.
TEST(Bands, UndercutsAreOnTheFarSideOfTheLightFirst) {
  Fold fold;
  fold.contact = 0.5;
  LabelledGraph edge = straight_arc(fold.camera, Kind::boundary, 0.5, 0, 1);
  for (CurvePoint& p : edge.points.values) {
    p.on.triangle = static_cast<int>(fold.surface.triangles.size()) - 1;
  }
  const auto width = [&](const Vec3& towards) {
    Light sun;
    sun.kind = LightKind::sun;
    sun.vector = towards;
    fold.lights = {sun};
    const auto [first, last] = columns(fold.tone(edge), Band::undercut);
    return last < 0 ? 0 : last - first + 1;
  };
  const double end = 0.25 * std::sqrt(8.0), side = std::sqrt(0.5);
  EXPECT_NEAR(width(Vec3(0, 0, 1)), 14 * (1 - 0.5 / end) / 0.8, 1);
  EXPECT_NEAR(width(Vec3(1, 0, 1)), 14 * (1 - 0.5 / (end * (1 + side))) / 0.8, 1);
  EXPECT_EQ(width(Vec3(-1, 0, 1)), 0);
  fold.contact = 0;
  EXPECT_EQ(width(Vec3(-1, 0, 1)), 14) << "as in the paper";
}

// Circles round the places of the fold whose radii are .7 of the distance from its end touch two
// lines through that: .7 / sqrt(1 - .7^2) px aside for each px along it.
TEST(Bands, UndercutsTaperTowardsTheEndOfTheirFold) {
  Fold fold;
  const LabelledGraph edge = straight_arc(fold.camera, Kind::boundary, 0.5, 0, 1, 0.5);
  const auto width = [&](int row) {
    const auto [first, last] = columns(fold.tone(edge), Band::undercut, row);
    return last < 0 ? 0 : last - first + 1;
  };
  EXPECT_EQ(width(53), 14) << "whole where undercuts are anywhere";
  fold.contact = 0.1;
  EXPECT_EQ(width(49), 0);
  for (const int row : {53, 57, 60}) EXPECT_NEAR(width(row), 0.98 * (row - 49.5), 1) << row;
  EXPECT_EQ(width(100), 14);
}

TEST(Bands, OptionsAndCurvesThatCoverNothing) {
  Fold fold;
  const LabelledGraph edge = straight_arc(fold.camera, Kind::silhouette, 0.5, 0, 2);
  ToneOptions options;
  options.mach_bands = false;
  EXPECT_EQ(columns(fold.tone(edge, options), Band::mach_band).second, -1);
  EXPECT_EQ(columns(fold.tone(edge, options), Band::undercut).first, 86);
  options = {};
  options.undercuts = false;
  EXPECT_EQ(columns(fold.tone(edge, options), Band::undercut).second, -1);
  EXPECT_EQ(columns(fold.tone(edge, options), Band::mach_band).first, 100);

  LabelledGraph hidden = edge;
  hidden.arcs[0].invisibility = 1;
  EXPECT_EQ(columns(fold.tone(hidden), Band::mach_band).second, -1);
  const LabelledGraph crease = straight_arc(fold.camera, Kind::crease, 0.5, 1, 1);
  EXPECT_EQ(columns(fold.tone(crease), Band::mach_band).second, -1);
  fold.hidden = {1, 0};
  EXPECT_EQ(columns(fold.tone(edge), Band::mach_band).second, -1) << "nothing beyond the fold";
}

TEST(Bands, IntersectionDarkensTheSheetTurnedAway) {
  const Camera camera = cameras::orthographic(Vec3::UnitZ(), 1, 200);
  const Surface roof = shapes::plain_surface(
      shapes::height_field(2, 2, [](double x, double) { return x < 0 ? x : -2 * x; }));
  Surface flat = roof;  // each side with its own normal at the ridge
  for (auto& normal : flat.normals) normal = Vec3::UnitZ();
  for (std::size_t v = 0; v < flat.positions.size(); ++v) {
    if (flat.positions[v].x() > 0) flat.normals[v] = Vec3(2, 0, 1).normalized();
  }
  const VisibleImage visible = render_visible(flat, camera, 1, {}, 1);
  const ToneMap tone =
      toned({flat, visible, camera, {}}, straight_arc(camera, Kind::intersection, 0, 0, 0));
  EXPECT_EQ(columns(tone, Band::undercut), std::make_pair(100, 113));
  EXPECT_EQ(columns(tone, Band::mach_band), std::make_pair(94, 99));
}

}  // namespace
}  // namespace illustrate
