#include "contour/exact/limit_contour.h"

#include <algorithm>
#include <cmath>

namespace illustrate {

double ContourValue::spread() const {
  return n.norm() / std::max(p.du.squaredNorm(), p.dv.squaredNorm());
}

std::optional<ContourValue> LimitContour::at(const BasePlace& place) {
  ++evaluations_;
  const std::optional<LimitPoint> p = limit_.evaluate(place);
  if (!p) return {};
  const Vec3 n = p->du.cross(p->dv), view = camera_.to_eye(p->position);
  const double scale = n.norm() * view.norm();
  if (!(scale > 0) || !std::isfinite(scale)) return {};
  const Vec2 gradient = Vec2((p->duu.cross(p->dv) + p->du.cross(p->duv)).dot(view),
                             (p->duv.cross(p->dv) + p->du.cross(p->dvv)).dot(view)) /
                        scale;
  return ContourValue{*p, n, view, n.dot(view) / scale, gradient};
}

ContourSample LimitContour::sample(const ContourValue& value) {
  ContourSample s;
  s.position = value.p.position;
  s.g = value.g;
  s.gradient = value.gradient;
  const Vec3 along = s.gradient.y() * value.p.du - s.gradient.x() * value.p.dv;
  const double length = along.norm();
  s.tangent = length > 0 ? Vec3(along / length) : Vec3::Zero();
  const Vec3 sight = -value.view.normalized();
  s.across = value.n.cross(sight).normalized();
  s.kappa = s.tangent.dot(s.across);
  s.rho = s.tangent.dot(sight);
  s.spread = value.spread();
  return s;
}

std::optional<ContourSample> LimitContour::on_line(int ptex_face, Vec2& uv, const Vec2& along,
                                                   double reach) {
  constexpr int most_steps = 10;
  double moved = 0;
  const Vec2 start = uv;
  for (int i = 0; i < most_steps; ++i) {
    uv = start + moved * along;
    const std::optional<ContourValue> value = at({ptex_face, uv});
    if (!value) return {};
    if (std::abs(value->g) < on_contour) return sample(*value);
    const double step = -value->g / value->gradient.dot(along);
    if (!std::isfinite(step)) return {};
    moved += step;
    if (std::abs(moved) > reach) return {};
  }
  return {};
}

}  // namespace illustrate
