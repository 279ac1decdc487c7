#include "visibility/layer_rays.h"

#include <algorithm>

namespace illustrate {
namespace {

constexpr double aside_px = 0.7;   // how far beside a fold the ray starts
constexpr double blind_px = 3;     // hits nearer than this are the curve's own surface
constexpr double blind_edges = 3;  // the same in edges of the curve's triangle, for silhouettes
constexpr double blind_diagonals = 0.01;  // and never more than this share of everything's diagonal

double longest_edge(const Surface& surface, int triangle) {
  double longest = 0;
  const Triangle& t = surface.triangles[idx(triangle)];
  for (int k = 0; k < 3; ++k) {
    const Vec3& a = surface.positions[idx(t[idx(k)])];
    const Vec3& b = surface.positions[idx(t[idx(next_corner(k))])];
    longest = std::max(longest, (b - a).norm());
  }
  return longest;
}

}  // namespace

// Image x runs along the view's first row, image y against its second.
Vec3 LayerRays::beside(const Vec3& p, const Vec2& along_px) const {
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

int LayerRays::count(const Arrangement& arrangement, const StrandPlace& place) {
  const CurveNetwork& network = *arrangement.network;
  const Strand& strand = network.strands[idx(place.strand)];
  const std::size_t i = arrangement.point(place.strand, place.segment);
  const std::size_t j = arrangement.point(place.strand, place.segment + 1);
  const Vec3 p = arrangement.world_at(place);
  const bool fold = strand.left_layers != strand.right_layers;
  const Vec3 origin = fold ? beside(p, arrangement.image.image[j] - arrangement.image.image[i]) : p;
  const Vec3 towards = camera_.to_eye(origin);
  const double blind = blind_distance(strand, network.points.values[i].on.triangle, p);
  hits_.clear();
  bvh_.hits(origin, towards, blind / towards.norm(), camera_.ray_end(origin), hits_);
  ++rays_;
  return static_cast<int>(hits_.size());
}

}  // namespace illustrate
