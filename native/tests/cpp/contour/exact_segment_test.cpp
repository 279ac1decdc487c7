#include "contour/exact/exact_segment.h"

#include <gtest/gtest.h>

#include "tests/cpp/cameras.h"
#include "tests/cpp/surface_checks.h"

namespace illustrate {
namespace {

using namespace surface_checks;

// A knot anywhere on the first face: what counts is what is told of it.
ContourKnot knot_at(const ExactSegment& segment, LimitContour& contour, const Vec2& uv, int sign,
                    double kappa) {
  ContourKnot knot = segment.knot(uv, LimitContour::sample(*contour.at({0, uv})));
  knot.before = knot.after = sign;
  knot.sample.kappa = kappa;
  return knot;
}

// As on noise, where kappa has the same sign at both ends of a segment with a cusp: it would vanish
// three and a half chords away.
TEST(ExactSegment, CuspsLieBetweenTheEnds) {
  const Surface surface = refined(shapes::icosphere_mesh(1, 2), at_level(0));
  const LimitSurface limit(surface);
  const Camera camera = cameras::perspective(Vec3(0, -4, 1), Vec3::Zero());
  LimitContour contour(limit, camera);
  for (const double kappa : {.2, .3, .5, -.2}) {
    ExactSegment segment(contour, camera);
    const ContourKnot a = knot_at(segment, contour, {.3, .3}, 1, .28);
    const ContourKnot b = knot_at(segment, contour, {.4, .3}, -1, kappa);
    std::vector<ContourKnot> between;
    segment.refine(0, a, b, 1e9, between);
    ASSERT_TRUE(segment.cusp());
    const Vec2 chord = b.image - a.image;
    for (const ContourKnot& knot : between) {
      const double share = (knot.image - a.image).dot(chord) / chord.squaredNorm();
      EXPECT_GE(share, -1e-9) << kappa;
      EXPECT_LE(share, 1 + 1e-9) << kappa;
    }
  }
}

}  // namespace
}  // namespace illustrate
