// g, its gradient and the contour's direction on the limit surface itself (paper
// sections 4.1, 4.2).
//
// With n = Pu x Pv and v towards the eye, g = n . v; front is g >= 0. The contour runs with the
// front on its left, along t = Pu g_v - Pv g_u. With r = -v, w = n x r (units throughout) and
// kappa = t . w, rho = t . r, the direction of its image is sign(kappa) times that of w, also at a
// cusp, where kappa vanishes and the sign of rho tells whether it recedes from the viewer.
#pragma once

#include "surface/limit/limit_surface.h"
#include "view/camera.h"

namespace illustrate {

struct ContourSample {
  Vec3 position;
  double g;       // sine of the angle between the line of sight and the tangent plane
  Vec2 gradient;  // of g in (u, v)
  Vec3 tangent;   // unit, of the contour; zero where the gradient vanishes
  Vec3 across;    // unit, w
  double kappa;
  double rho;
  double spread;  // |Pu x Pv| in squares of the longer of the two
};

// What Newton's method asks for at each step.
struct ContourValue {
  LimitPoint p;
  Vec3 n, view;  // Pu x Pv, and towards the eye
  double g;      // as in ContourSample, and so are these
  Vec2 gradient;
  double spread() const;
};

class LimitContour {
 public:
  LimitContour(const LimitSurface& limit, const Camera& camera) : limit_(limit), camera_(camera) {}

  // Nothing where there is no limit surface or it has no normal.
  std::optional<ContourValue> at(const BasePlace& place);
  static ContourSample sample(const ContourValue& value);

  // The contour where the line from `uv` along the unit vector `along` crosses it: Newton's method,
  // no farther than `reach` from uv. Moves uv there.
  std::optional<ContourSample> on_line(int ptex_face, Vec2& uv, const Vec2& along, double reach);

  std::int64_t evaluations() const { return evaluations_; }

 private:
  const LimitSurface& limit_;
  const Camera& camera_;
  std::int64_t evaluations_ = 0;
};

// |g| below this is on the contour.
constexpr double on_contour = 1e-7;

// A spread below this is that of a pinch point, where the normal vanishes and turns over.
constexpr double pinch_spread = 1e-3;

}  // namespace illustrate
