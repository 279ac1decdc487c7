#include "contour/intersection/meetings.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/cpp/cameras.h"

namespace illustrate {
namespace {

constexpr int valence = 8;
constexpr double turn = 2 * 3.141592653589793 / valence;
const Vec3 blade_direction(std::cos(2.5 * turn), std::sin(2.5 * turn), 0);

// A flat fan round the origin, and an upright triangle that stands on its third one.
Surface fan_and_blade() {
  Surface surface;
  surface.positions.push_back(Vec3::Zero());
  for (int k = 0; k < valence; ++k)
    surface.positions.push_back(Vec3(std::cos(k * turn), std::sin(k * turn), 0));
  const Vec3& along = blade_direction;
  const Vec3 up(0, 0, 1);
  for (const Vec3& p : {Vec3(.05 * along - up), Vec3(.8 * along - up), Vec3(.4 * along + up)})
    surface.positions.push_back(p);
  for (int k = 0; k < valence; ++k) {
    surface.triangles.push_back({0, 1 + k, 1 + (k + 1) % valence});
    surface.neighbours.push_back({(k + valence - 1) % valence, none, (k + 1) % valence});
  }
  surface.triangles.push_back({valence + 1, valence + 2, valence + 3});
  surface.neighbours.push_back({none, none, none});
  surface.flips.assign(surface.triangles.size(), 0);
  for (int v = 0; v < valence + 4; ++v) surface.places.push_back(v);
  return surface;
}

IntersectionCurves foot_of_the_blade() {
  IntersectionCurves curves;
  for (const double reach : {.05, .8}) {
    curves.curves.push({reach * blade_direction, {2, .1, .1}, {valence, .1, .1}, Vec3::Zero()});
  }
  curves.curves.close_list();
  curves.closed = {0};
  curves.segment_triangles = {{2, valence}, {none, none}};
  return curves;
}

ChainPoint chain_point(const Vec3& position, int triangle, int edge, double fraction) {
  ChainPoint p;
  p.position = position;
  p.on = edge == none ? SurfacePoint{triangle, .3, .3} : SurfacePoint{triangle, fraction, 0};
  p.edge = edge;
  p.fraction = fraction;
  return p;
}

const std::vector<int> all_of_the_fan{0, 1, 2, 3, 4, 5};

// A chain from the first triangle of the fan to the fifth. Its points on the spokes between them,
// at this share of their length, are left out.
Silhouettes chain_round_the_vertex(double share) {
  Silhouettes result;
  result.chains.push(chain_point(Vec3(.5, .3, 0), 0, none, 0));
  result.chains.push(chain_point(Vec3(-.5, -.1, 0), 4, none, 0));
  result.chains.close_list();
  result.closed = {0};
  for (int k = 1; k <= 4; ++k) {
    const Vec3 at(share * std::cos(k * turn), share * std::sin(k * turn), 0);
    result.passed.push_back({0, 0, chain_point(at, k, 0, share)});
  }
  return result;
}

TEST(Meetings, AreFoundWhereAChainHasLeftOutItsPoints) {
  const Surface surface = fan_and_blade();
  const Silhouettes silhouettes = chain_round_the_vertex(.4);
  const std::vector<Meeting> found =
      find_meetings(surface, silhouettes, pieces_of_chains(surface, silhouettes, all_of_the_fan),
                    foot_of_the_blade(), cameras::orthographic(Vec3(0, 0, 1), 1));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].curve, 0);
  EXPECT_GT(found[0].chain_fraction, 0);
  EXPECT_LT(found[0].chain_fraction, 1);
}

TEST(Meetings, AreNoneWhereItPassesBesideTheCurve) {
  const Surface surface = fan_and_blade();
  const Silhouettes silhouettes = chain_round_the_vertex(.95);
  EXPECT_TRUE(find_meetings(surface, silhouettes,
                            pieces_of_chains(surface, silhouettes, all_of_the_fan),
                            foot_of_the_blade(), cameras::orthographic(Vec3(0, 0, 1), 1))
                  .empty());
}

TEST(SurfaceWays, AreKeptInTheTrianglesAskedFor) {
  const std::vector<int> asked{2, none, 3, 2};
  const PiecesByTriangle pieces =
      pieces_of_chains(fan_and_blade(), chain_round_the_vertex(.4), asked);
  for (int t = 0; t < 5; ++t) EXPECT_EQ(pieces[t].size(), t == 2 || t == 3 ? 1U : 0U);
}

TEST(SurfaceWays, HaveNoGaps) {
  const Surface surface = fan_and_blade();
  const PiecesByTriangle pieces =
      pieces_of_chains(surface, chain_round_the_vertex(.4), all_of_the_fan);
  double reached = 0;
  for (int t = 0; t < 5; ++t) {
    ASSERT_EQ(pieces[t].size(), 1U);
    const CurvePiece& piece = pieces[t].front();
    EXPECT_EQ(piece.from, reached);
    EXPECT_GT(piece.to, piece.from);
    reached = piece.to;
    if (t < 4) {
      EXPECT_NEAR(piece.end.y(), .4, 1e-12);
      EXPECT_NEAR(pieces[t + 1].front().start.x(), .4, 1e-12);
    }
  }
  EXPECT_EQ(reached, 1);
}

}  // namespace
}  // namespace illustrate
