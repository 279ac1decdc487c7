#include "hatch/curves/surface_curves.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/errors.h"
#include "hatch/curves/field_walk.h"
#include "tests/cpp/hatch/hatch_scene.h"

namespace illustrate {
namespace {

using namespace hatching;

// The square [-1, 1]^2 with a cross along the axes.
struct Square {
  Surface surface = shapes::plain_surface(shapes::plane(9, 7));
  CrossField field = field_of(surface, [](const Vec3&) { return Vec3::UnitX(); });
};

// Where the curves of one direction lie across it, in rank order.
std::vector<double> offsets_across(const Square& square, const SurfaceCurves& curves, int axis) {
  std::vector<double> offsets;
  for (std::size_t c = 0; c < curves.curves.size(); ++c) {
    const Vec3 from = position_at(square.surface, curves.curves[c].front());
    const Vec3 to = position_at(square.surface, curves.curves[c].back());
    if (std::abs(to[1 - axis] - from[1 - axis]) < 1e-9) offsets.push_back(from[1 - axis]);
  }
  return offsets;
}

std::vector<int> triangles_of(const SurfaceCurves& curves) {
  std::vector<int> triangles;
  for (const SurfacePoint& on : curves.curves.values) triangles.push_back(on.triangle);
  return triangles;
}

TEST(FieldWalker, SlidesStraightAndStopsAtTheBoundary) {
  const Square square;
  const FieldWalker walker(square.surface, square.field);
  SurfacePoint on{0, 0.3, 0.3};
  const Vec3 from = position_at(square.surface, on), run(1.1, 0.7, 0);
  ASSERT_TRUE(walker.slide(on, run));
  EXPECT_LT((position_at(square.surface, on) - from - run).norm(), 1e-5);
  EXPECT_FALSE(walker.slide(on, 3 * run));
  EXPECT_NEAR(position_at(square.surface, on).cwiseAbs().maxCoeff(), 1, 1e-6);
}

TEST(FieldWalker, TellsTheLengthThatIsLeft) {
  const Square square;
  const FieldWalker walker(square.surface, square.field);
  SurfacePoint on{0, 0.3, 0.3};
  Vec3 tangent(1, 0.2, 0);
  const double x = position_at(square.surface, on).x();
  EXPECT_EQ(walker.advance(on, tangent, 0.5), 0);
  EXPECT_NEAR(position_at(square.surface, on).x(), x + 0.5, 1e-6);
  EXPECT_NEAR(walker.advance(on, tangent, 5), 5 - (1 - x - 0.5), 1e-5);
}

TEST(Headway, IsLostWhereManyEdgesBringNothing) {
  const auto crossed = [](const std::vector<double>& steps) {
    double left = 1;
    std::size_t edges = 0;
    for (Headway headway(left); headway.is_made(left) && edges < 10'000; ++edges) {
      left -= steps[std::min(edges, steps.size() - 1)];
    }
    return edges;
  };
  EXPECT_EQ(crossed({0}), 63U);
  EXPECT_EQ(crossed({1e-9}), 63U) << "rounding is no way";
  EXPECT_EQ(crossed({1e-5}), 4095U) << "no walk needs more";
  std::vector<double> fan(41, 0);
  fan.back() = 1e-3;  // round a vertex of forty edges, then on
  EXPECT_GT(crossed(fan), 4000U);
}

// On this pyramid a walk comes to the tip and crosses edge after edge there.
TEST(FieldWalker, EndsWhereItTurnsRoundAVertex) {
  const Vec3 tip(0, 0, 1.2268472180490588);
  PolygonMesh pyramid;
  pyramid.positions = {tip, Vec3::UnitX(), Vec3(std::cos(2.1), std::sin(2.1), 0),
                       Vec3(std::cos(4.2), std::sin(4.2), 0)};
  pyramid.face_sizes = {3, 3, 3};
  pyramid.corner_vertices = {0, 1, 2, 0, 2, 3, 0, 3, 1};
  const Surface surface = shapes::plain_surface(pyramid);
  const std::vector<Vec3> along{
      Vec3(-0.55857307459445893, 0.28892981569566656, -0.097887833909776623),
      Vec3(-0.56737498391845542, -0.62721109301057432, -0.20598383015927613),
      Vec3(0.51628568278616149, 0.89841464319650854, -0.79806893716042315),
      Vec3(-0.41671220942598741, 0.035572672202040634, 0.67933401075372202)};
  const CrossField field = field_of(surface, [&](const Vec3& p) {
    const auto at = std::find(pyramid.positions.begin(), pyramid.positions.end(), p);
    return along[static_cast<std::size_t>(at - pyramid.positions.begin())];
  });
  SurfacePoint on{0, 0.02, 0.03};
  Vec3 tangent(-0.53522807620394508, -0.59282464378615551, 0.12369690357796537);
  EXPECT_GT(FieldWalker(surface, field).advance(on, tangent, 5), 4);
  EXPECT_LT((position_at(surface, on) - tip).norm(), 1e-3);
}

TEST(SurfaceCurves, AreStraightLinesFromEdgeToEdgeOnASquare) {
  const Square square;
  const SurfaceCurves curves = surface_curves(square.surface, square.field);
  EXPECT_NEAR(curves.area, 4, 1e-12);
  std::size_t whole = 0;
  for (std::size_t c = 0; c < curves.curves.size(); ++c) {
    const Vec3 run = position_at(square.surface, curves.curves[c].back()) -
                     position_at(square.surface, curves.curves[c].front());
    EXPECT_LT(std::min(std::abs(run.x()), std::abs(run.y())), 1e-5);
    whole += run.norm() > 1.9999;
  }
  EXPECT_EQ(whole, curves.curves.size());
}

TEST(SurfaceCurves, AreNestedAndLeaveNoGaps) {
  const Square square;
  const SurfaceCurves curves = surface_curves(square.surface, square.field);
  const double finest = curves.step / 0.6;
  for (const int axis : {0, 1}) {
    const std::vector<double> offsets = offsets_across(square, curves, axis);
    ASSERT_GT(offsets.size(), 100U);
    std::vector<double> placed, apart;
    for (const double offset : offsets) {
      double nearest = 2;
      for (const double other : placed) nearest = std::min(nearest, std::abs(other - offset));
      EXPECT_GE(nearest, finest - 1e-6);
      apart.push_back(nearest);
      placed.push_back(offset);
    }
    for (std::size_t i = 0; i < 8; ++i) EXPECT_GT(apart[i], 8 * finest) << "coarse ones come first";
    std::sort(placed.begin(), placed.end());
    for (std::size_t i = 1; i < placed.size(); ++i) {
      EXPECT_LT(placed[i] - placed[i - 1], 2.1 * finest);
    }
  }
}

double worst_latitude_drift(int level) {
  const Surface sphere = shapes::sphere_surface(1, level);
  const SurfaceCurves curves = surface_curves(sphere, field_of(sphere, round_z));
  double worst = 0;
  for (std::size_t c = 0; c < std::min<std::size_t>(40, curves.curves.size()); ++c) {
    const auto curve = curves.curves[c];
    const Vec3 from = position_at(sphere, curve[0]), to = position_at(sphere, curve[1]);
    if (std::abs(from.z()) > 0.7 || std::abs((to - from).z()) > 0.5 * (to - from).norm()) continue;
    for (const SurfacePoint& on : curve) {
      worst = std::max(worst, std::abs(position_at(sphere, on).normalized().z() - from.z()));
    }
  }
  return worst;
}

TEST(SurfaceCurves, FollowParallelsOfASphere) {
  const double coarse = worst_latitude_drift(3), fine = worst_latitude_drift(5);
  EXPECT_GT(coarse, 0);
  EXPECT_LT(fine, coarse / 4);
}

TEST(SurfaceCurves, SeedsSpreadEvenlyByArea) {
  const Square square;
  const SurfaceCurves curves = surface_curves(square.surface, square.field);
  std::array<int, 4> quarters{0, 0, 0, 0};
  for (std::size_t i = 0; i < 4000; ++i) {
    const Vec3 p = position_at(square.surface, curves.seeds[i]);
    ++quarters[(p.x() > 0 ? 1 : 0) + (p.y() > 0 ? 2 : 0)];
  }
  for (const int count : quarters) EXPECT_NEAR(count, 1000, 40);
}

TEST(SurfaceCurves, AreTheSameAtAnySize) {
  const Surface torus = shapes::plain_surface(shapes::torus_mesh(2, 0.8, 24, 12));
  const CrossField field = field_of(torus, round_z);
  const SurfaceCurves curves = surface_curves(torus, field);
  ASSERT_GT(curves.curves.size(), 100U);
  for (const int power : {-160, 160}) {  // less and more than a float can hold
    Surface scaled = torus;
    for (Vec3& p : scaled.positions) p *= std::ldexp(1, power);
    const SurfaceCurves found = surface_curves(scaled, field);
    EXPECT_EQ(found.curves.offsets, curves.curves.offsets);
    EXPECT_EQ(triangles_of(found), triangles_of(curves));
  }
}

bool same_seeds(const SurfaceCurves& a, const SurfaceCurves& b) {
  return std::equal(a.seeds.begin(), a.seeds.end(), b.seeds.begin(), b.seeds.end(),
                    [](const SurfacePoint& p, const SurfacePoint& q) {
                      return p.triangle == q.triangle && p.b1 == q.b1 && p.b2 == q.b2;
                    });
}

TEST(RankedCurves, GiveSeedsWithoutCurves) {
  const Surface torus = shapes::torus_surface(1, 0.4, 40, 20);
  const CrossField field = field_of(torus, round_z);
  RankedCurves ranked(torus, field, all_triangles(torus));
  const SurfaceCurves seeds = ranked.seeds_to(0.1);
  const SurfaceCurves& curves = ranked.down_to(0.1);
  EXPECT_TRUE(seeds.curves.empty());
  EXPECT_FALSE(curves.curves.empty());
  EXPECT_TRUE(same_seeds(seeds, curves));
  EXPECT_EQ(seeds.area, curves.area);
}

// Seeds of a mesh that deforms stay in their triangles, unless its size is quite another.
TEST(RankedCurves, SpreadSeedsByTheFirstAreas) {
  const Surface torus = shapes::torus_surface(1, 0.4, 40, 20);
  Surface stretched = torus;
  for (Vec3& p : stretched.positions) p.x() *= p.x() > 0 ? 1.5 : 1;
  const auto seeds = [&](const Surface& surface, const std::vector<double>& areas) {
    const CrossField field = field_of(surface, round_z);
    return RankedCurves(surface, field, all_triangles(surface), areas).seeds_to(0.1);
  };
  const std::vector<double> first = triangle_areas(torus);
  EXPECT_TRUE(same_seeds(seeds(stretched, first), seeds(torus, {})));
  EXPECT_FALSE(same_seeds(seeds(stretched, {}), seeds(torus, {})));
  std::vector<double> far = first;
  for (double& area : far) area *= 3;
  EXPECT_TRUE(same_seeds(seeds(stretched, far), seeds(stretched, {})));
}

TEST(RankedCurves, AreMadeNoFurtherThanAskedAndTheSameInAnyOrder) {
  const Surface torus = shapes::torus_surface(1, 0.4, 40, 20);
  const CrossField field = field_of(torus, round_z);
  RankedCurves zooming_in(torus, field, all_triangles(torus)),
      zooming_out(torus, field, all_triangles(torus));
  const double infinite = std::numeric_limits<double>::infinity();
  const std::vector<double> radii{infinite, 0.1, 0.05, 0.0};
  for (auto radius = radii.rbegin(); radius != radii.rend(); ++radius) zooming_out.down_to(*radius);
  std::size_t last = 0;
  for (const double radius : radii) {
    const SurfaceCurves& in = zooming_in.down_to(radius);
    const SurfaceCurves& out = zooming_out.down_to(radius);
    EXPECT_TRUE(is_start_of(in, out) && is_start_of(out, in));
    EXPECT_TRUE(is_start_of(in, zooming_out.down_to(0)));
    EXPECT_GT(in.curves.size(), last) << radius;
    if (radius > 0 && std::isfinite(radius)) {
      EXPECT_GE(static_cast<double>(in.seeds.size()) * radius * radius, 2.4 * in.area);
    }
    last = in.curves.size();
  }
}

TEST(RankedCurves, CanBeAskedAgainAfterCancellingAndWhileReporting) {
  const Surface torus = shapes::torus_surface(1, 0.4, 40, 20);
  const CrossField field = field_of(torus, round_z);
  RankedCurves curves(torus, field, all_triangles(torus));
  int calls = 0;
  const auto cancel = [&](double, const std::string&) { return ++calls < 12; };
  EXPECT_THROW(curves.down_to(0.03, Progress(cancel, "hatch curves")), Cancelled);
  const auto ask = [&](double, const std::string&) {
    if (++calls == 20) curves.down_to(0.1);
    return true;
  };
  const SurfaceCurves& asked = curves.down_to(0.03, Progress(ask, "hatch curves"));
  EXPECT_GT(calls, 20);
  const SurfaceCurves all = surface_curves(torus, field);
  EXPECT_TRUE(is_start_of(asked, all));
  EXPECT_TRUE(is_start_of(curves.down_to(0.1), all));
}

TEST(SurfaceCurves, AreDeterministicAndCanBeCancelled) {
  const Surface torus = shapes::torus_surface(1, 0.4, 40, 20);
  const CrossField field = field_of(torus, round_z);
  const SurfaceCurves a = surface_curves(torus, field), b = surface_curves(torus, field);
  EXPECT_EQ(a.curves.offsets, b.curves.offsets);
  int calls = 0;
  const Progress progress([&](double, const std::string&) { return ++calls < 3; }, "hatch curves");
  EXPECT_THROW(surface_curves(torus, field, progress), Cancelled);
  EXPECT_TRUE(surface_curves(Surface{}, CrossField{}).curves.empty());
}

TEST(SurfaceCurves, TellWhichOfThemARadiusNeeds) {
  const Square square;
  RankedCurves ranked(square.surface, square.field, all_triangles(square.surface));
  const SurfaceCurves all = ranked.down_to(0);
  ASSERT_EQ(all.needed_below.size(), all.curves.size());
  for (const double radius : {1., 0.1, 0.03, 0.01}) {
    const auto needed = std::count_if(all.needed_below.begin(), all.needed_below.end(),
                                      [&](double below) { return radius < below; });
    EXPECT_EQ(static_cast<std::size_t>(needed), ranked.down_to(radius).curves.size()) << radius;
  }
}

}  // namespace
}  // namespace illustrate
