#include "contour/exact/exact_segment.h"

#include <algorithm>
#include <cmath>

#include "core/angles.h"

namespace illustrate {
namespace {

constexpr int most_halvings = 12;
constexpr double shortest_px = 0.02;
constexpr double largest_turn_rad = radians(20);
// A mid-point is looked for this far from the chord, in lengths of the chord.
constexpr double search_reach = 0.7;
constexpr double at_cusp = 1e-4;       // |kappa|
constexpr double beside_pinch = 0.05;  // |kappa|

// From a to b, counter-clockwise positive.
double angle(const Vec2& a, const Vec2& b) { return std::atan2(cross(a, b), a.dot(b)); }

int sign(double x) { return x < 0 ? -1 : 1; }

}  // namespace

ContourKnot ExactSegment::knot(const Vec2& uv, const ContourSample& sample) const {
  ContourKnot result;
  result.uv = uv;
  result.sample = sample;
  result.image = camera_.project(sample.position).xy;
  result.before = result.after = sign(sample.kappa);
  return result;
}

void ExactSegment::refine(int ptex_face, const ContourKnot& a, const ContourKnot& b,
                          double longest_px, std::vector<ContourKnot>& between) {
  ptex_face_ = ptex_face;
  longest_px_ = longest_px;
  found_ = &between;
  cusp_.reset();
  refine(a, b, most_halvings);
}

std::optional<ContourKnot> ExactSegment::between(int ptex_face, const ContourKnot& a,
                                                 const ContourKnot& b, double fraction) {
  const Vec2 chord = b.uv - a.uv;
  const double length = chord.norm();
  if (!(length > 0)) return {};
  Vec2 uv = a.uv + fraction * chord;
  const Vec2 across(-chord.y() / length, chord.x() / length);
  const auto sample = contour_.on_line(ptex_face, uv, across, search_reach * length);
  if (!sample || !(camera_.near_distance(sample->position) > 0)) return {};
  return knot(uv, *sample);
}

void ExactSegment::refine(const ContourKnot& a, const ContourKnot& b, int depth) {
  if (depth == 0) return settle(a, b);
  if (a.after != b.before && !a.is_cusp() && !b.is_cusp()) {
    split_at_sign_change(a, b, depth);
  } else if (a.after != b.before || needs_split(a, b)) {
    const auto middle = between(ptex_face_, a, b, 0.5);
    middle ? split(a, b, *middle, depth) : settle(a, b);
  }
}

// Signs that differ need a cusp between them, found or not.
void ExactSegment::settle(const ContourKnot& a, const ContourKnot& b) {
  if (a.after != b.before) found_->push_back(linear_cusp(a, b));
}

void ExactSegment::split(const ContourKnot& a, const ContourKnot& b, const ContourKnot& middle,
                         int depth) {
  refine(a, middle, depth - 1);
  found_->push_back(middle);
  refine(middle, b, depth - 1);
}

// A cusp, or a pinch point: there the normal vanishes and turns over, so kappa jumps from one sign
// to the other, but the image of the contour goes straight on.
void ExactSegment::split_at_sign_change(const ContourKnot& a, const ContourKnot& b, int depth) {
  SignChange change{a, b};
  const ContourKnot cusp = find_cusp(a, b, change);
  if (depth == most_halvings) cusp_ = cusp;
  const auto is_beside_pinch = [](const ContourSample& sample) {
    return sample.spread < pinch_spread && std::abs(sample.kappa) > beside_pinch;
  };
  const bool is_pinch =
      is_beside_pinch(change.before.sample) && is_beside_pinch(change.behind.sample);
  if (!is_pinch) return split(a, b, cusp, depth);
  refine(a, change.before, depth - 1);
  found_->push_back(change.before);
  found_->push_back(change.behind);
  refine(change.behind, b, depth - 1);
}

Vec2 ExactSegment::image_tangent(const ContourKnot& knot, int sign) const {
  return sign * camera_.project_direction(knot.sample.position, knot.sample.across);
}

bool ExactSegment::needs_split(const ContourKnot& a, const ContourKnot& b) const {
  const Vec2 chord = b.image - a.image;
  const double length = chord.norm();
  if (!(length > shortest_px)) return false;
  if (length > longest_px_) return true;
  const double first = angle(image_tangent(a, a.after), chord);
  const double second = angle(chord, image_tangent(b, b.before));
  if (std::abs(first) > largest_turn_rad || std::abs(second) > largest_turn_rad) return true;
  if (!a.is_cusp() && !b.is_cusp()) return false;
  // Beside a cusp: y = s x^1.5 + c x^2 above the cusp's tangent, from the angles of the chord and
  // of the far end to it.
  const double chord_angle = a.is_cusp() ? first : second, end_angle = first + second;
  const double s = 4 * chord_angle - 2 * end_angle, c = 2 * end_angle - 3 * chord_angle;
  return std::abs(c) > .7 * std::abs(s) && length > cusp_reach_px;
}

// The signs beside a cusp are those of its neighbours, whatever kappa was found there: the two may
// agree, and kappa vanish beyond the ends, at any distance.
ContourKnot ExactSegment::linear_cusp(const ContourKnot& a, const ContourKnot& b) const {
  const double span = a.sample.kappa - b.sample.kappa;
  const double fraction = span != 0 ? std::clamp(a.sample.kappa / span, 0., 1.) : .5;
  ContourKnot cusp = fraction < .5 ? a : b;
  cusp.uv = a.uv + fraction * (b.uv - a.uv);
  cusp.sample.position = a.sample.position + fraction * (b.sample.position - a.sample.position);
  cusp.image = camera_.project(cusp.sample.position).xy;
  cusp.before = a.after;
  cusp.after = b.before;
  return cusp;
}

// The Illinois variant of the false position.
ContourKnot ExactSegment::find_cusp(const ContourKnot& a, const ContourKnot& b,
                                    SignChange& nearest) {
  constexpr int most_steps = 40;
  double low = 0, high = 1, low_kappa = a.sample.kappa, high_kappa = b.sample.kappa;
  int last_side = 0;
  std::optional<ContourKnot> cusp;
  for (int i = 0; i < most_steps; ++i) {
    const double fraction = (low * high_kappa - high * low_kappa) / (high_kappa - low_kappa);
    if (!(fraction >= 0 && fraction <= 1)) break;
    const auto middle = between(ptex_face_, a, b, fraction);
    if (!middle) break;
    cusp = middle;
    const double kappa = middle->sample.kappa;
    if (std::abs(kappa) < at_cusp) break;
    const int side = sign(kappa) == a.after ? -1 : 1;
    (side < 0 ? low : high) = fraction;
    (side < 0 ? low_kappa : high_kappa) = kappa;
    (side < 0 ? nearest.before : nearest.behind) = *middle;
    if (side == last_side) (side < 0 ? high_kappa : low_kappa) /= 2;
    last_side = side;
  }
  if (!cusp || std::abs(cusp->sample.kappa) > .1) return linear_cusp(a, b);
  ContourKnot result = *cusp;
  result.before = a.after;
  result.after = b.before;
  return result;
}

}  // namespace illustrate
