#include "contour/limit_contour.h"

#include <algorithm>
#include <cmath>

namespace illustrate {

std::optional<ContourSample> LimitContour::at(const BasePlace& place) {
  ++evaluations_;
  const std::optional<LimitPoint> p = limit_.evaluate(place);
  if (!p) return {};
  const Vec3 n = p->du.cross(p->dv), view = camera_.to_eye(p->position);
  const double scale = n.norm() * view.norm();
  if (!(scale > 0) || !std::isfinite(scale)) return {};
  ContourSample s;
  s.position = p->position;
  s.g = n.dot(view) / scale;
  s.gradient = Vec2((p->duu.cross(p->dv) + p->du.cross(p->duv)).dot(view),
                    (p->duv.cross(p->dv) + p->du.cross(p->dvv)).dot(view)) /
               scale;
  const Vec3 along = s.gradient.y() * p->du - s.gradient.x() * p->dv;
  const double length = along.norm();
  s.tangent = length > 0 ? Vec3(along / length) : Vec3::Zero();
  const Vec3 sight = -view.normalized();
  s.across = n.cross(sight).normalized();
  s.kappa = s.tangent.dot(s.across);
  s.rho = s.tangent.dot(sight);
  s.spread = n.norm() / std::max(p->du.squaredNorm(), p->dv.squaredNorm());
  return s;
}

std::optional<ContourSample> LimitContour::on_line(int ptex_face, Vec2& uv, const Vec2& along,
                                                   double reach) {
  constexpr int most_steps = 10;
  double moved = 0;
  const Vec2 start = uv;
  for (int i = 0; i < most_steps; ++i) {
    uv = start + moved * along;
    const std::optional<ContourSample> s = at({ptex_face, uv});
    if (!s) return {};
    if (std::abs(s->g) < on_contour) return s;
    const double step = -s->g / s->gradient.dot(along);
    if (!std::isfinite(step)) return {};
    moved += step;
    if (std::abs(moved) > reach) return {};
  }
  return {};
}

}  // namespace illustrate
