// A segment of a silhouette within one triangle, drawn as the contour of the limit surface: cusps
// exactly where they are, and points in between until the polyline follows the curve.
//
// The image of the contour turns back at a cusp, where kappa changes its sign. A cusp separates
// points of different sign; a second one between two points of equal sign, and what a chord hides
// else, shows in the angles between the chord and the exact directions at its ends.
#pragma once

#include "contour/exact/limit_contour.h"

namespace illustrate {

// A point of the contour in the coordinates of one patch. `before` and `after` are the signs of
// kappa on both sides of it along the contour: they differ at a cusp.
struct ContourKnot {
  Vec2 uv = Vec2::Zero();
  ContourSample sample;
  Vec2 image = Vec2::Zero();
  int before = 0;
  int after = 0;

  bool is_cusp() const { return before != after; }
  int cusp_jump() const { return !is_cusp() ? 0 : sample.rho >= 0 ? 1 : -1; }
};

// Near a cusp two strands of the image run together like x^1.5; below this distance the grid on
// which crossings are decided would twist them.
constexpr double cusp_reach_px = 0.12;

class ExactSegment {
 public:
  ExactSegment(LimitContour& contour, const Camera& camera) : contour_(contour), camera_(camera) {}

  ContourKnot knot(const Vec2& uv, const ContourSample& sample) const;

  // The points strictly between a and b, in order, no farther apart than longest_px.
  void refine(int ptex_face, const ContourKnot& a, const ContourKnot& b, double longest_px,
              std::vector<ContourKnot>& between);

  // The cusp (or pinch point) of the segment refined last, between ends of different signs; where
  // it was not found the place on the chord at which kappa would vanish.
  const std::optional<ContourKnot>& cusp() const { return cusp_; }

  // The point of the contour across from `fraction` of the chord from a to b.
  std::optional<ContourKnot> between(int ptex_face, const ContourKnot& a, const ContourKnot& b,
                                     double fraction);

 private:
  void refine(const ContourKnot& a, const ContourKnot& b, int depth);
  void settle(const ContourKnot& a, const ContourKnot& b);
  void split(const ContourKnot& a, const ContourKnot& b, const ContourKnot& middle, int depth);
  bool needs_split(const ContourKnot& a, const ContourKnot& b) const;
  Vec2 image_tangent(const ContourKnot& knot, int sign) const;
  // Points of the contour between which kappa changes its sign.
  struct SignChange {
    ContourKnot before, behind;
  };
  void split_at_sign_change(const ContourKnot& a, const ContourKnot& b, int depth);
  ContourKnot find_cusp(const ContourKnot& a, const ContourKnot& b, SignChange& nearest);
  ContourKnot linear_cusp(const ContourKnot& a, const ContourKnot& b) const;

  LimitContour& contour_;
  const Camera& camera_;
  int ptex_face_ = none;
  double longest_px_ = 0;
  std::vector<ContourKnot>* found_ = nullptr;
  std::optional<ContourKnot> cusp_;
};

}  // namespace illustrate
