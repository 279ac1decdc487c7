#include "hatch/greedy/trace_hatch.h"

#include <algorithm>
#include <cmath>

#include "core/angles.h"

namespace illustrate {
namespace {

// Samples nearer than this share of a step have no direction between them.
constexpr double least_step = 0.05;

// Hatches end this far before a critical curve: on their own side of it, where neighbours beyond
// are out of sight. In units of the graph.
constexpr double curve_margin = 0.02;

}  // namespace

bool Tracer::is_near_parallel(const HatchSample& sample, double radius) const {
  const Vec2& image = sample.point.image;
  const Vec3 normal = normal_at(surface_, sample.point.on);
  return grid_.any_within(image, radius, [&](const HatchNode& node) {
    return are_parallel(sample.tangent, normal, node.tangent) &&
           !curves_.separate(image, node.image);
  });
}

// The same for the hatch itself, where it comes round again.
bool Tracer::closes_in(const HatchLine& line, const HatchSample& sample,
                       const HatchRules& rules) const {
  const double apart = rules.test_px / rules.step_px;  // samples
  const auto recent = static_cast<std::size_t>(std::ceil(3 * apart));
  const auto stride = static_cast<std::size_t>(std::max(1.0, apart / 2));
  for (std::size_t i = 0; i + recent < line.size(); i += stride) {
    const HatchSample& other = line[i];
    const double distance = (other.point.image - sample.point.image).squaredNorm();
    if (distance >= rules.test_px * rules.test_px) continue;
    const Vec3 normal = normal_at(surface_, sample.point.on);
    if (are_parallel(sample.tangent, normal, other.tangent) &&
        !curves_.separate(sample.point.image, other.point.image)) {
      return true;
    }
  }
  return false;
}

// Appends samples step by step until a rule ends the hatch. Where a critical curve does, the last
// sample lies at it.
void Tracer::extend(HatchLine& line, Walk walk, const HatchRules& rules, double& rest_px) const {
  const Vec3 first_tangent = walk.tangent;
  const double least_cosine = std::cos(radians(options_.max_turn_deg));
  const bool may_turn = options_.max_turn_deg >= 180;
  while (rest_px > least_step * rules.step_px) {
    const Walk before = walk;
    const Vec2 from = line.back().point.image;
    ++steps_;
    const double step = std::min(rules.step_px, rest_px);
    rest_px -= step;
    WalkEnd end = walker_.advance(walk, step);
    HatchSample sample{walker_.point(walk.on), walk.tangent};
    if (!area_.is_in_frame(sample.point)) return;
    double reach = (sample.point.image - from).norm();
    const double crossing = curves_.first_crossing(from, sample.point.image);
    if (crossing <= 1 || end == WalkEnd::silhouette) {
      reach = reach * std::min(1.0, crossing) - curve_margin * curves_.unit_px();
      if (!(reach > 0)) return;
      walk = before;
      walker_.advance(walk, reach);
      sample = {walker_.point(walk.on), walk.tangent};
      end = WalkEnd::silhouette;
    }
    if (!may_turn && walk.tangent.dot(first_tangent) < least_cosine) return;
    if (!area_.may_pass(sample.point, rules.area)) return;
    if (!area_.suits(sample.point, sample.tangent)) return;
    if (is_near_parallel(sample, rules.test_px) || closes_in(line, sample, rules)) return;
    if (reach > least_step * rules.step_px) line.push_back(sample);
    if (end != WalkEnd::whole) return;
  }
}

HatchLine Tracer::trace(const SurfacePoint& seed, const Vec3& towards,
                        const HatchRules& rules) const {
  const Walk start = walker_.start(seed, towards);
  const HatchSample first{walker_.point(seed), start.tangent};
  double rest_px = rules.max_length_px;
  HatchLine line{first};
  extend(line, start, rules, rest_px);
  std::reverse(line.begin(), line.end());
  for (HatchSample& sample : line) sample.tangent = -sample.tangent;
  extend(line, Walker::turned(start), rules, rest_px);
  return line;
}

}  // namespace illustrate
