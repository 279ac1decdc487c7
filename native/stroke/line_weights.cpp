#include "stroke/line_weights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace illustrate {
namespace {

// Across an arc is across the chord from so many units of the graph before a place to as many
// behind it: the hooks near cusps are shorter.
constexpr double chord_units = 2;
constexpr double aside_units = 1.5;  // how far beside a line rays ask what is seen there
constexpr std::array<double, 3> asked_shares{0.25, 0.5, 0.75};  // of an arc's points
// Depths that this share of the lines' length is nearer, or farther than, do not count.
constexpr double far_out = 0.05;
// What is flatter than this share of the picture's width counts as being so deep.
constexpr double least_depth = 0.25;

Vec3 image_right(const Camera& camera) { return camera.view().row(0).head<3>().normalized(); }
Vec3 image_up(const Camera& camera) { return camera.view().row(1).head<3>().normalized(); }

// Unit direction to the right of the arc at point i, in the image, y down; zero where it has none.
Vec2 right_of(const Span<const Vec2>& image, std::size_t i, double reach) {
  std::size_t before = i, after = i;
  while (before > 0 && (image[i] - image[before]).norm() < reach) --before;
  while (after + 1 < image.size() && (image[after] - image[i]).norm() < reach) ++after;
  const Vec2 along = image[after] - image[before];
  const double length = along.norm();
  return length > 0 ? Vec2(Vec2(-along.y(), along.x()) / length) : Vec2(Vec2::Zero());
}

// Of an image direction as the viewer sees it at p, square to the line of sight.
Vec3 in_world(const Camera& camera, const Vec3& p, const Vec2& image) {
  const Vec3 flat = image.x() * image_right(camera) - image.y() * image_up(camera);
  const Vec3 to_eye = camera.to_eye(p).normalized();
  return (flat - flat.dot(to_eye) * to_eye).normalized();
}

// Which side of an arc its surface is not on: 1 right, -1 left, 0 both or neither.
int open_side(const GraphArc& arc) {
  return (arc.left_layers > arc.right_layers) - (arc.left_layers < arc.right_layers);
}

class SeenObjects {
 public:
  SeenObjects(const Surface& surface, const Bvh& bvh, const Camera& camera)
      : surface_(surface), bvh_(bvh), camera_(camera) {}

  // The object that is seen where p's image is, moved aside by so much; none: nothing.
  int beside(const Vec3& p, const Vec2& aside_px) {
    const Vec3 origin = p + camera_.pixel_size(p) * (aside_px.x() * image_right(camera_) -
                                                     aside_px.y() * image_up(camera_));
    const Vec3 towards = camera_.to_eye(origin);
    hits_.clear();
    bvh_.hits(origin, towards, -std::numeric_limits<double>::infinity(), camera_.ray_end(origin),
              hits_);
    const auto nearest =
        std::max_element(hits_.begin(), hits_.end(),
                         [](const RayHit& a, const RayHit& b) { return a.distance < b.distance; });
    return nearest == hits_.end() ? none : surface_.object_of(nearest->triangle);
  }

 private:
  const Surface& surface_;
  const Bvh& bvh_;
  const Camera& camera_;
  std::vector<RayHit> hits_;
};

// What is seen beside an arc changes at its nodes alone: a few places tell, by their majority.
bool is_inside(const LabelledGraph& graph, std::size_t arc, SeenObjects& seen) {
  const Span<const CurvePoint> points = graph.points[arc];
  const Span<const Vec2> image = graph.image[arc];
  int votes = 0;
  for (const double share : asked_shares) {
    const auto i = static_cast<std::size_t>(share * static_cast<double>(points.size() - 1));
    const Vec2 aside =
        aside_units * graph.unit_px * right_of(image, i, chord_units * graph.unit_px);
    const int right = seen.beside(points[i].position, aside);
    const int left = seen.beside(points[i].position, -aside);
    votes += left == right && left != none ? 1 : -1;
  }
  return votes > 0;
}

// Depths between which lines thin out, and how to compare them: as shares in perspective.
class DepthRange {
 public:
  DepthRange(const LabelledGraph& graph, const Camera& camera) : camera_(camera) {
    std::vector<std::pair<double, double>> seen;  // scaled depth, length in the image
    for (std::size_t a = 0; a < graph.arcs.size(); ++a) {
      if (layers_over(graph.arcs[a]) == 0) add(graph.points[a], graph.image[a], seen);
    }
    if (seen.empty()) return;
    std::sort(seen.begin(), seen.end());
    const double nearest = quantile(seen, far_out), farthest = quantile(seen, 1 - far_out);
    middle_ = (nearest + farthest) / 2;
    half_ = std::max(farthest - nearest, least_range()) / 2;
  }

  // 1 for the nearest, -1 for the farthest.
  double nearness(const Vec3& p) const {
    return half_ > 0 ? std::clamp((middle_ - scaled(p)) / half_, -1.0, 1.0) : 0.0;
  }

 private:
  void add(const Span<const CurvePoint>& points, const Span<const Vec2>& image,
           std::vector<std::pair<double, double>>& seen) const {
    const Vec2 frame(camera_.width_px(), camera_.height_px());
    for (std::size_t i = 0; i + 1 < image.size(); ++i) {
      const bool is_in_frame =
          (image[i].array() >= 0).all() && (image[i].array() <= frame.array()).all();
      const double depth = scaled(points[i].position);
      if (is_in_frame && std::isfinite(depth))
        seen.emplace_back(depth, (image[i + 1] - image[i]).norm());
    }
  }

  static double quantile(const std::vector<std::pair<double, double>>& sorted, double share) {
    double total = 0, gone = 0;
    for (const auto& [depth, length] : sorted) total += length;
    for (const auto& [depth, length] : sorted) {
      gone += length;
      if (gone >= share * total) return depth;
    }
    return sorted.back().first;
  }

  double scaled(const Vec3& p) const {
    return camera_.is_perspective() ? std::log(camera_.depth(p)) : camera_.depth(p);
  }

  // In perspective pixels are in proportion to depth: what they span there needs no place.
  double least_range() const {
    const Vec3 forward = -camera_.view().row(2).head<3>().normalized();
    const Vec3 ahead = camera_.is_perspective() ? Vec3(camera_.viewpoint().head<3>() + forward)
                                                : Vec3(Vec3::Zero());
    return least_depth * camera_.width_px() * camera_.pixel_size(ahead);
  }

  const Camera& camera_;
  double middle_ = 0;
  double half_ = 0;
};

}  // namespace

double light_from(const std::vector<Light>& lights, const Camera& camera, const Vec3& position,
                  const Vec3& direction) {
  double flow = 0, all = 0;
  for (const Light& light : lights) {
    if (light.kind == LightKind::ambient) {
      all += light.strength;
      continue;
    }
    Vec3 vector;
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 unit = Vec3::Unit(axis);
      vector[axis] =
          received(light, camera, position, unit) - received(light, camera, position, -unit);
    }
    flow += vector.dot(direction);
    all += vector.norm();
  }
  return all > 0 ? flow / all : 0;
}

Ragged<double> line_weights(const LabelledGraph& graph, const Surface& surface, const Bvh& bvh,
                            const Camera& camera, const std::vector<Light>& lights,
                            const LineWeightOptions& options) {
  const std::vector<Light> used = lights.empty() ? std::vector<Light>{Light{}} : lights;
  const DepthRange depths(graph, camera);
  SeenObjects seen(surface, bvh, camera);
  Ragged<double> weights;
  for (std::size_t a = 0; a < graph.arcs.size(); ++a) {
    const GraphArc& arc = graph.arcs[a];
    const Span<const CurvePoint> points = graph.points[a];
    const bool is_inner = options.inner_scale != 1 && layers_over(arc) == 0 && !points.empty() &&
                          is_inside(graph, a, seen);
    const int open = options.by_light > 0 ? open_side(arc) : 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec3& p = points[i].position;
      double weight = is_inner ? options.inner_scale : 1.0;
      const Vec2 right = right_of(graph.image[a], i, chord_units * graph.unit_px);
      if (open != 0 && !right.isZero()) {
        weight *=
            1 - options.by_light * light_from(used, camera, p, in_world(camera, p, open * right));
      }
      if (options.by_depth > 0) weight *= 1 + options.by_depth * depths.nearness(p);
      weights.push(weight);
    }
    weights.close_list();
  }
  return weights;
}

}  // namespace illustrate
