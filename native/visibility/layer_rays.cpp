#include "visibility/layer_rays.h"

#include <algorithm>

#include "surface/locate.h"

namespace illustrate {
namespace {

// How far beside a fold rays start. The interpolated contour of a rim narrower than the triangles
// runs up to a pixel inside their outline; a farther ray then finds fewer layers, in front and
// behind. Fewer in front alone: another curve runs between.
constexpr std::array<double, 3> asides_px{0.2, 0.7, 2.0};
constexpr double blind_px = 3;     // hits nearer than this may be the curve's own surface
constexpr double blind_edges = 3;  // so may those be that are nearer than so many edges of the
                                   // curve's triangle, for silhouettes
constexpr double blind_diagonals = 0.01;  // and never more than this share of everything's diagonal
constexpr double rounding = 1e-6;         // share of that: hits nearer than this are the curve's
                                          // own surface, before or behind it as rounding has it

}  // namespace

// Image x runs along the view's first row, image y against its second.
Vec3 LayerRays::beside(const Vec3& p, const Vec2& along_px, double aside_px) const {
  const Vec2 right_px(-along_px.y(), along_px.x());  // y is down
  const double scale = aside_px * camera_.pixel_size(p) / std::max(right_px.norm(), 1e-300);
  const Vec3 x = camera_.view().row(0).head<3>().normalized();
  const Vec3 y = camera_.view().row(1).head<3>().normalized();
  return p + scale * (right_px.x() * x - right_px.y() * y);
}

double LayerRays::blind_distance(const Strand& strand, int triangle, const Vec3& p) const {
  const double pixels = blind_px * camera_.pixel_size(p);
  if (strand.kind != Kind::silhouette) return pixels;
  const double edges = blind_edges * longest_edge(surface_, triangle);
  return std::max(pixels, std::min(edges, blind_diagonals * surface_.diagonal));
}

LayerCount LayerRays::count_from(const Vec3& origin, double blind) {
  const Vec3 towards = camera_.to_eye(origin);
  const double length = towards.norm();
  hits_.clear();
  bvh_.hits(origin, towards, -2 * surface_.diagonal / length, camera_.ray_end(origin), hits_);
  ++rays_;
  const auto farther_than = [&](double distance) {
    return static_cast<int>(std::count_if(hits_.begin(), hits_.end(), [&](const RayHit& hit) {
      return hit.distance > distance / length;
    }));
  };
  const int layers = farther_than(blind);
  const int unsure = farther_than(rounding * blind) - layers;
  return {layers, unsure, static_cast<int>(hits_.size()) - layers - unsure, hits_.empty()};
}

LayerCount LayerRays::count(const Arrangement& arrangement, const StrandPlace& place) {
  const CurveNetwork& network = *arrangement.network;
  const Strand& strand = network.strands[idx(place.strand)];
  const std::size_t i = arrangement.point(place.strand, place.segment);
  const std::size_t j = arrangement.point(place.strand, place.segment + 1);
  const Vec3 p = arrangement.world_at(place);
  const double blind = blind_distance(strand, network.points.values[i].on.triangle, p);
  if (strand.left_layers == strand.right_layers) {
    const LayerCount on_curve = count_from(p, blind);
    return {on_curve.layers, on_curve.unsure, on_curve.behind, false};
  }
  const Vec2 along = arrangement.image.image[j] - arrangement.image.image[i];
  LayerCount result = count_from(beside(p, along, asides_px[0]), blind);
  for (std::size_t k = 1; k < asides_px.size() && result.before() > 0; ++k) {
    const LayerCount farther = count_from(beside(p, along, asides_px[k]), blind);
    const bool leaves_own_rim =
        farther.before() < result.before() && farther.behind < result.behind;
    if (leaves_own_rim) result = farther;
  }
  return result;
}

}  // namespace illustrate
