#include "hatch/last_hatches.h"

#include <algorithm>
#include <cmath>

namespace illustrate {
namespace {

// In spacings: how far a hatch moves sideways and is still the same, how deep, and between points.
constexpr double reach = 0.4;
constexpr double depth_reach = 3;
constexpr double step = 0.25;
// Of a hatch that has not moved: more than half a step, less than points of hatches are apart.
constexpr double resting_reach = 0.15;

}  // namespace

LastHatches::LastHatches(const Ragged<Vec3>& strokes, const Camera& camera, double spacing_px,
                         const RestingPlaces* resting)
    : camera_(camera), resting_(resting), grid_(camera.width_px(), camera.height_px(), spacing_px) {
  for (std::size_t s = 0; s < strokes.size(); ++s) {
    const Span<const Vec3> line = strokes[s];
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const Vec3 way = line[i + 1] - line[i];
      if (!(camera.near_distance(line[i]) > 0) || !(camera.near_distance(line[i + 1]) > 0))
        continue;
      const double length = (camera.project(line[i + 1]).xy - camera.project(line[i]).xy).norm();
      const double parts = std::max(1.0, std::ceil(length / (step * spacing_px)));
      for (double k = 0.5; k < parts; ++k) {  // in the world: depths are then those of the hatch
        const ImagePoint seen = camera.project(line[i] + k / parts * way);
        grid_.add({seen.xy, way.normalized(), static_cast<int>(depths_.size())});
        depths_.push_back(seen.depth);
      }
    }
  }
}

bool LastHatches::was_at(const HatchPoint& point, const Vec3& tangent, double spacing_px) const {
  const double depth = camera_.depth(point.position);
  const double most = depth_reach * spacing_px * camera_.pixel_size(point.position);
  const bool rests = resting_ && resting_->rests(point.image);
  return grid_.any_within(
      point.image, (rests ? resting_reach : reach) * spacing_px, [&](const HatchNode& node) {
        const double cosine = tangent.dot(node.tangent);
        return 2 * cosine * cosine > 1 && std::abs(depths_[idx(node.point)] - depth) < most;
      });
}

bool LastHatches::was_along(Span<const HatchPoint> points, double spacing_px) const {
  std::size_t found = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t before = i == 0 ? 0 : i - 1, after = std::min(i + 1, points.size() - 1);
    const Vec3 way = points[after].position - points[before].position;
    found += was_at(points[i], way.normalized(), spacing_px);
  }
  return 2 * found > points.size();
}

}  // namespace illustrate
