#include "hatch/even_hatches.h"

#include <gtest/gtest.h>

#include "core/errors.h"
#include "hatch/streamlines/place_curves.h"
#include "tests/cpp/hatch/hatch_scene.h"

namespace illustrate {
namespace {

using namespace hatching;

// Standard deviation over mean of the distances beside hatches along `direction` on a plane.
double spacing_variation(const Hatches& hatches, const Vec2& across) {
  std::vector<double> offsets;
  for (std::size_t h = 0; h < hatches.curves.size(); ++h) {
    const auto curve = hatches.curves[h];
    const Vec2 run = (curve.back().image - curve.front().image).normalized();
    if (std::abs(run.dot(across)) > 0.1 || length_px(curve) < 100) continue;
    offsets.push_back(curve[curve.size() / 2].image.dot(across));
  }
  std::sort(offsets.begin(), offsets.end());
  double sum = 0, squares = 0;
  for (std::size_t i = 1; i < offsets.size(); ++i) {
    const double gap = offsets[i] - offsets[i - 1];
    sum += gap, squares += gap * gap;
  }
  const double count = static_cast<double>(offsets.size()) - 1;
  return std::sqrt(squares / count - sum * sum / (count * count)) / (sum / count);
}

TEST(EvenHatches, PlaneIsHatchedEvenlyByBothFamilies) {
  Scene scene = plane_scene();
  const Hatches hatches = scene.even();
  check_hatches(scene, hatches);
  const Vec3 one(std::cos(0.35), std::sin(0.35), 0), other(-one.y(), one.x(), 0);
  EXPECT_GE(least_distance(hatches, parallel), 0.5 * 8 - 0.1);
  EXPECT_LT(worst_gap(scene, hatches, one), 8);
  EXPECT_LT(worst_gap(scene, hatches, other), 8);
  for (const Vec3& d : {one, other}) {
    EXPECT_LT(spacing_variation(hatches, Vec2(d.x(), -d.y())), 0.15);
  }
  EXPECT_EQ(scene.counts["hatches"], static_cast<int>(hatches.curves.size()));
}

// A ground that the eye is close to: from one hatch to the next it recedes by many spacings.
TEST(EvenHatches, AreApartOnAGroundThatRecedes) {
  Scene scene = scene_of(shapes::plain_surface(shapes::plane(13, 11)),
                         cameras::perspective(Vec3(0, -1, 0.04), Vec3(0, 1, 0), 0.01, 40, 400),
                         [](const Vec3&) { return Vec3(Vec3::UnitX()); });
  scene.surface.planes.emplace_back();
  scene.surface.triangle_planes.assign(scene.surface.triangles.size(), 0);
  const Hatches hatches = scene.even();
  EXPECT_GT(hatches.curves.size(), 10U);
  EXPECT_GE(least_distance(hatches, parallel), 0.5 * 8 - 0.1);
}

// Cells of the image take depths that differ by a tenth of a pixel for one.
TEST(EvenHatches, AreNotThoseOfASheetJustBelowAnother) {
  const PolygonMesh sheet = shapes::plane(13, 11);
  Scene scene =
      scene_of(shapes::joined(shapes::plain_surface(shapes::moved(sheet, Vec3(0.1, 0, -0.001))),
                              shapes::plain_surface(sheet)),
               cameras::orthographic(Vec3(0.3, -0.5, 1), 1.2, 240),
               [](const Vec3&) { return Vec3(1, 2, 0); });
  const Hatches hatches = scene.even();
  const double below = -0.0005;
  double length = 0;
  for (std::size_t h = 0; h < hatches.curves.size(); ++h) {
    for (const HatchPoint& point : std::as_const(hatches.curves)[h]) {
      EXPECT_TRUE(point.position.z() > below || point.position.x() > 0.99);
    }
    length += length_px(hatches.curves[h]);
  }
  EXPECT_GT(length, 1000);
}

// Gaps of a face of ninety hatches, before its edges too, when it is known to be flat.
TEST(EvenHatches, AreRuledOnFlatFaces) {
  Scene scene = scene_of(shapes::plain_surface(shapes::plane(13, 11)),
                         cameras::orthographic(Vec3::UnitZ(), 1.2, 880),
                         [](const Vec3&) { return Vec3(Vec3::UnitX()); });
  scene.add_arc(Kind::boundary, {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}});
  const double drifting = spacing_variation(scene.even(), Vec2::UnitY());
  scene.surface.planes.emplace_back();
  scene.surface.triangle_planes.assign(scene.surface.triangles.size(), 0);
  const Hatches ruled = scene.even();
  check_hatches(scene, ruled);
  EXPECT_GT(drifting, 0.06);
  EXPECT_LT(spacing_variation(ruled, Vec2::UnitY()), 0.01);
  for (std::size_t h = 0; h < ruled.curves.size(); ++h) {
    const auto curve = std::as_const(ruled.curves)[h];
    for (const HatchPoint& point : curve) {
      const Vec2 off = (point.image - curve.front().image).cwiseAbs();
      EXPECT_LT(off.minCoeff(), 1e-3) << "straight";
    }
  }
}

TEST(EvenHatches, KeepToTheCross) {
  Scene scene = torus_scene();
  const Hatches hatches = scene.even();
  int far_off = 0, all = 0;
  for (std::size_t h = 0; h < hatches.curves.size(); ++h) {
    const auto curve = hatches.curves[h];
    for (std::size_t i = 1; i + 1 < curve.size(); ++i, ++all) {
      const double around =
          std::abs(tangent_at(curve, i).dot(round_z(curve[i].position).normalized()));
      far_off += std::min(around, std::sqrt(1 - std::min(1.0, around * around))) > std::sin(0.1);
    }
  }
  EXPECT_LT(far_off, all / 40);
}

// A hundredth of the plane fills the frame: neither curves nor seeds lie so densely.
TEST(EvenHatches, CloseViewsAreCoveredToo) {
  Scene scene = scene_of(shapes::plain_surface(shapes::plane(13, 11)),
                         cameras::orthographic(Vec3::UnitZ(), 0.012, 240),
                         [](const Vec3&) { return Vec3(std::cos(0.35), std::sin(0.35), 0); });
  const Hatches hatches = scene.even();
  double length = 0;
  for (std::size_t h = 0; h < hatches.curves.size(); ++h) length += length_px(hatches.curves[h]);
  EXPECT_NEAR(length * 8 / (2 * 240 * 240), 1, 0.2);
}

// The same view in half as many pixels, at half the spacing.
TEST(EvenHatches, DoNotDependOnThePixels) {
  Scene fine = torus_scene();
  Scene coarse = scene_of(
      fine.surface, cameras::perspective(Vec3(0, -3, 4), Vec3::Zero(), 0.1, 40, 200), round_z);
  coarse.visible = render_visible(coarse.surface, coarse.camera, 0.5, {}, 1);
  coarse.tone = uniform_tone(coarse.visible, Tone::shadow);
  coarse.options.spacing_px = fine.options.spacing_px / 2;
  const Hatches a = fine.even(), b = coarse.even();
  ASSERT_EQ(a.curves.offsets, b.curves.offsets);
  for (std::size_t i = 0; i < a.curves.values.size(); ++i) {
    EXPECT_LT((a.curves.values[i].image - 2 * b.curves.values[i].image).norm(), 0.01);
  }
}

TEST(EvenHatches, HighlightsAndMachBandsStayWhiteAndEdgesAreMet) {
  Scene scene = plane_scene();
  for (int cell = 0; cell < 240 * 240; ++cell) {
    const int column = cell % 240;
    if (column < 90) scene.tone.level[cell] = Tone::highlight;
    if (column >= 150 && column < 160) scene.tone.band[cell] = Band::mach_band;
  }
  const Hatches hatches = scene.even();
  int at_edge = 0;
  for (const HatchPoint& point : hatches.curves.values) {
    const double x = point.image.x();
    EXPECT_TRUE(x >= 90 && (x < 150 || x >= 160)) << x;
    at_edge += x < 92;
  }
  EXPECT_GT(at_edge, 15);
}

TEST(EvenHatches, EndAtCriticalCurvesAndCrossNone) {
  Scene scene = plane_scene();
  scene.add_arc(Kind::crease, {Vec3(0.013, -1.1, 0), Vec3(0.013, 1.1, 0)});
  const Hatches hatches = scene.even();
  check_ends_at_column(hatches, scene.camera.project(Vec3(0.013, 0, 0)).xy.x());
}

// Between two creases, half a spacing wide: too narrow for seeds of the surface to be sure to meet.
TEST(EvenHatches, NarrowStripsAreHatched) {
  Scene scene = plane_scene();
  const double low = 0.013, high = 0.053;
  for (const double x : {low, high}) {
    scene.add_arc(Kind::crease, {Vec3(x, -1.1, 0), Vec3(x, 1.1, 0)});
  }
  const Hatches hatches = scene.even();
  std::vector<double> rows{-1, 1};
  for (const HatchPoint& point : hatches.curves.values) {
    if (point.position.x() > low && point.position.x() < high) rows.push_back(point.position.y());
  }
  std::sort(rows.begin(), rows.end());
  for (std::size_t i = 1; i < rows.size(); ++i) {
    EXPECT_LT(100 * (rows[i] - rows[i - 1]), 1.5 * 8) << "at " << rows[i];
  }
}

TEST(EvenHatches, UndercutsAreDenser) {
  Scene scene = plane_scene();
  for (int cell = 0; cell < 240 * 240; ++cell) {
    if (cell % 240 >= 100 && cell % 240 < 140) scene.tone.band[cell] = Band::undercut;
  }
  const Hatches hatches = scene.even();
  check_hatches(scene, hatches);
  EXPECT_GT(std::count(hatches.kinds.begin(), hatches.kinds.end(), Kind::undercut), 10);
  EXPECT_GT(least_distance(hatches, parallel), 0.5 * scene.options.undercut_spacing_px);
  for (std::size_t h = 0; h < hatches.curves.size(); ++h) {
    if (hatches.kinds[h] != Kind::undercut) continue;
    EXPECT_GT(length_px(hatches.curves[h]), 1.9 * scene.options.undercut_spacing_px);
  }
}

// Share of the points of `a` that lie within two pixels of one of `b`.
double share_kept(const Hatches& a, const Hatches& b) {
  int kept = 0;
  for (const HatchPoint& p : a.curves.values) {
    kept += std::any_of(b.curves.values.begin(), b.curves.values.end(), [&](const HatchPoint& q) {
      return (p.image - q.image).norm() < 2 && (p.position - q.position).norm() < 0.05;
    });
  }
  return kept / static_cast<double>(a.curves.values.size());
}

// Two squares of one object, one of which asks for half the spacing.
struct TwoParts {
  Scene scene = scene_of(
      shapes::plain_surface(shapes::joined(shapes::moved(shapes::plane(9, 9), Vec3(-1.3, 0, 0)),
                                           shapes::moved(shapes::plane(9, 9), Vec3(1.3, 0, 0)))),
      cameras::orthographic(Vec3::UnitZ(), 2.5, 500), [](const Vec3&) { return Vec3::UnitX(); });

  void make_right_finer() {
    for (const Triangle& t : scene.surface.triangles) {
      scene.spacing_scale.push_back(scene.surface.positions[idx(t[0])].x() < 0 ? 1 : 0.5F);
    }
  }
};

// Of what lies on the left, or on the right.
Hatches half_of(const Hatches& hatches, bool right) {
  Hatches half;
  for (std::size_t h = 0; h < hatches.kinds.size(); ++h) {
    if ((hatches.curves[h][0].position.x() > 0) == right) half.add(hatches, h);
  }
  return half;
}

TEST(EvenHatches, AreFinerOnOnePartAlone) {
  TwoParts two;
  const Hatches plain = two.scene.even();
  two.make_right_finer();
  const Hatches finer = two.scene.even();
  check_hatches(two.scene, finer);
  const Hatches left = half_of(finer, false), right = half_of(finer, true);
  const Hatches before = half_of(plain, false);
  expect_same_hatches(left, before);
  const auto count = [](const Hatches& hatches) {
    return static_cast<double>(hatches.kinds.size());
  };
  EXPECT_NEAR(count(right) / count(left), 2, 0.2);
  EXPECT_LT(spacing_variation(right, Vec2(0, 1)), 0.2);
}

TEST(EvenHatches, StayWhereTheDrawingBeforeHadThem) {
  Scene scene = torus_scene();
  const Hatches first = scene.even();
  Ragged<SurfacePoint> points;
  for (std::size_t h = 0; h < first.curves.size(); ++h) {
    for (const HatchPoint& point : std::as_const(first.curves)[h]) points.push(point.on);
    points.close_list();
  }
  EXPECT_GT(share_kept(first, scene.even(points)), 0.97);
}

TEST(EvenHatches, LengthAndTurnAreLimited) {
  Scene scene = torus_scene();
  check_limits(scene, 65, [&] { return scene.even(); });
}

TEST(EvenHatches, AreTheSameOnAllThreadsAndCanBeCancelled) {
  Scene scene = torus_scene();
  const Hatches a = scene.even({}, 1), b = scene.even({}, 3);
  expect_same_hatches(a, b);
  int calls = 0;
  const Progress progress([&](double, const std::string&) { return ++calls < 3; }, "hatch");
  const SurfaceCurves curves = surface_curves(scene.surface, scene.field);
  const CurvesOfObjects of_objects{{&curves}};
  EXPECT_THROW(even_hatches(scene.view(), of_objects, {}, {}, 1, scene.counts, progress),
               Cancelled);
}

// A draft starts from the same curves, a spacing apart: it has gaps, of up to three.
TEST(DraftHatches, CoverWhatIsHatchedApartFromGaps) {
  Scene scene = plane_scene();
  const Hatches hatches = scene.draft();
  check_hatches(scene, hatches);
  EXPECT_GE(least_distance(hatches, parallel), PlaceRules().test * 8 - 0.1);
  const Vec3 one(std::cos(0.35), std::sin(0.35), 0), other(-one.y(), one.x(), 0);
  EXPECT_LT(worst_gap(scene, hatches, one), 3 * 8);
  EXPECT_LT(worst_gap(scene, hatches, other), 3 * 8);
  EXPECT_EQ(scene.counts["hatches"], static_cast<int>(hatches.curves.size()));
  EXPECT_TRUE(hatches.placed.empty());
}

TEST(DraftHatches, AreTheSameOnAllThreadsAndStayOfTheDrawingBefore) {
  Scene scene = torus_scene();
  const Hatches a = scene.draft({}, 1), b = scene.draft({}, 3);
  expect_same_hatches(a, b);
  const Hatches whole = scene.even();
  EXPECT_GT(share_kept(whole, scene.draft(whole.placed)), 0.97);
}

TEST(EvenHatches, NothingSeenGivesNothing) {
  Scene scene = plane_scene();
  scene.tone = uniform_tone(scene.visible, Tone::highlight);
  EXPECT_TRUE(scene.even().curves.empty());
  scene.surface = Surface{};
  scene.field = CrossField{};
  scene.families = {};
  scene.visible = render_visible(scene.surface, scene.camera, 1, {}, 1);
  EXPECT_TRUE(scene.even().curves.empty());
  scene.spacing_scale = {1};
  EXPECT_THROW(scene.even(), InvalidInput);
}

}  // namespace
}  // namespace illustrate
