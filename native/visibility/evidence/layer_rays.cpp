#include "visibility/evidence/layer_rays.h"

#include <algorithm>
#include <limits>

#include "mesh/polygons.h"
#include "surface/edge_kinds.h"
#include "surface/locate.h"
#include "visibility/reaches.h"

namespace illustrate {
namespace {

// Of the distance within which hits may be the curve's own surface: those nearer than this share
// are it, before or behind the curve as rounding has it.
constexpr double blind_rounding = 1e-6;
// Beside a curve a ray meets a sheet that the curve touches no farther than this many times that
// distance away, unless the sheet is seen edge-on.
constexpr double grazing = 10;
constexpr int most_steps = 64;  // from the triangle that a ray met to where the line of sight does

}  // namespace

// An edge of a polygon object is where it is.
bool LayerRays::is_interpolated(const Strand& strand, int triangle) const {
  return strand.kind == Kind::silhouette && surface_.is_smooth_at(triangle);
}

int LayerRays::part(int triangle) const {
  return insets_.parts[idx(surface_.triangles[idx(triangle)][0])];
}

// Image x runs along the view's first row, image y against its second.
Vec3 LayerRays::beside(const Vec3& p, const Vec2& along_px, double aside_px) const {
  const Vec2 right_px(-along_px.y(), along_px.x());  // y is down
  const double scale = aside_px * camera_.pixel_size(p) / std::max(right_px.norm(), 1e-300);
  const Vec3 x = camera_.view().row(0).head<3>().normalized();
  const Vec3 y = camera_.view().row(1).head<3>().normalized();
  return p + scale * (right_px.x() * x - right_px.y() * y);
}

double LayerRays::blind_distance(const Strand& strand, int triangle, const Vec3& p) const {
  const double pixels = reaches.blind * camera_.pixel_size(p);
  if (!is_interpolated(strand, triangle)) return pixels;
  return std::max(pixels, reach_of_own_curves(surface_, triangle));
}

// Of a triangle in whose plane the curve lies, up to rounding.
LayerRays::Side LayerRays::side_of_touch(int triangle, const Touching& curve) const {
  if (insets_.moves.empty() || curve.is_of_two) return Side::open;
  const int vertex = surface_.triangles[idx(triangle)][0];
  const Corners moved = moved_corners(triangle);
  const Vec3 normal = unit_or_zero((moved[1] - moved[0]).cross(moved[2] - moved[0]));
  const double inset = std::abs(normal.dot(insets_.moves[idx(vertex)]));
  if (std::abs(normal.dot(curve.position - surface_.positions[idx(vertex)])) > inset)
    return Side::apart;
  const double apart = normal.dot(curve.decided - moved[0]);
  const Vec3 to_eye = camera_.to_eye(curve.decided);
  const double slope = normal.dot(to_eye);
  const Vec3 met = curve.decided - apart / slope * to_eye;
  if (!met.allFinite()) return Side::open;
  if (is_beyond_rim(triangle, normal, met)) return Side::beside;
  if (std::abs(apart) < inset / 2) return Side::open;
  return (apart > 0) == (slope > 0) ? Side::behind : Side::before;
}

LayerRays::Corners LayerRays::moved_corners(int triangle) const {
  Corners moved;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t vertex = idx(surface_.triangles[idx(triangle)][k]);
    moved[k] = surface_.positions[vertex] + insets_.moves[vertex];
  }
  return moved;
}

// Goes from triangle to triangle towards the place, which is a few of them away at most: the ray
// that met the first one passed beside it.
bool LayerRays::is_beyond_rim(int triangle, const Vec3& normal, const Vec3& p) const {
  for (int step = 0; step < most_steps; ++step) {
    const Corners corners = moved_corners(triangle);
    bool is_past_rim = false;
    int next = triangle;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& from = corners[k];
      const Vec3& to = corners[idx(next_corner(static_cast<int>(k)))];
      if (normal.dot((to - from).cross(p - from)) >= 0) continue;
      const bool is_rim = parts_surface(surface_.edge_kinds[idx(triangle)][k]);
      is_past_rim = is_past_rim || is_rim;
      if (!is_rim) next = surface_.neighbours[idx(triangle)][k];
    }
    if (next == triangle || next == none) return is_past_rim;
    triangle = next;
  }
  return false;
}

// Asked of the plane: from beside a curve, rays meet what it stands on some way off.
bool LayerRays::lies_apart(int triangle, const Touching& curve) const {
  if (!curve.is_on_mesh) {
    if (insets_.parts.empty()) return false;
    if (part(triangle) == part(curve.triangle)) return false;
  }
  const Triangle& t = surface_.triangles[idx(triangle)];
  const Vec3& corner = surface_.positions[idx(t[0])];
  const Vec3 normal = unit_or_zero(
      (surface_.positions[idx(t[1])] - corner).cross(surface_.positions[idx(t[2])] - corner));
  return std::abs(normal.dot(curve.position - corner)) >
         reaches.blind_on_mesh * camera_.pixel_size(curve.position);
}

void LayerRays::cast(const Vec3& origin) {
  hits_.clear();
  bvh_.hits(origin, camera_.to_eye(origin), -std::numeric_limits<double>::infinity(),
            camera_.ray_end(origin), hits_);
  ++rays_;
}

LayerCount LayerRays::count_from(const Vec3& origin, double blind, const Touching& curve) {
  cast(origin);
  const double length = camera_.to_eye(origin).norm();
  LayerCount count{0, 0, 0, hits_.empty()};
  for (const RayHit& hit : hits_) {
    const double distance = hit.distance * length;
    const Side side = std::abs(distance) < blind ? side_of_touch(hit.triangle, curve) : Side::apart;
    if (side == Side::before || (side != Side::behind && distance > blind)) {
      ++count.layers;
    } else if (side != Side::behind && distance > blind_rounding * blind) {
      ++(lies_apart(hit.triangle, curve) ? count.layers : count.unsure);
    } else {
      ++count.behind;
    }
  }
  return count;
}

LayerCount LayerRays::count(const Arrangement& arrangement, const StrandPlace& place) {
  const CurveNetwork& network = arrangement.network();
  const Strand& strand = network.strands[idx(place.strand)];
  const std::size_t i = arrangement.point(place.strand, place.segment);
  const std::size_t j = arrangement.point(place.strand, place.segment + 1);
  const Vec3 p = arrangement.world_at(place);
  const int triangle = network.points.values[i].on.triangle;
  const Touching curve{p, arrangement.decided_at(place), strand.kind == Kind::intersection,
                       !is_interpolated(strand, triangle), triangle};
  const double blind = blind_distance(strand, triangle, p);
  if (strand.left_layers == strand.right_layers) {
    const LayerCount on_curve = count_from(p, blind, curve);
    return {on_curve.layers, on_curve.unsure, on_curve.behind, false};
  }
  const Vec2 along = arrangement.image().image[j] - arrangement.image().image[i];
  const Vec3 outside = beside(p, along, reaches.aside_first);
  LayerCount result = count_from(outside, blind, curve);
  const bool is_border = strand.kind == Kind::boundary && !insets_.parts.empty();
  const SheetHits met = is_border ? near_sheets(outside, blind) : SheetHits{};
  for (const double aside : {reaches.aside_second, reaches.aside_last}) {
    if (result.before() == 0) break;
    const LayerCount farther = count_from(beside(p, along, aside), blind, curve);
    const bool leaves_own_rim =
        farther.before() < result.before() && farther.behind < result.behind;
    if (leaves_own_rim) result = farther;
  }
  if (is_border) {
    const Vec3 inside = beside(p, along, -reaches.aside_first);
    cast(inside);
    add_adjoining_sheets(met, near_sheets(inside, blind), curve, result);
  }
  return result;
}

// Of those that the last ray met, which started at `origin`.
LayerRays::SheetHits LayerRays::near_sheets(const Vec3& origin, double blind) const {
  const double reach = grazing * blind / camera_.to_eye(origin).norm();
  SheetHits sheets;
  for (const RayHit& hit : hits_) {
    if (std::abs(hit.distance) >= reach) continue;
    RayHit& nearest = sheets.emplace(part(hit.triangle), hit).first->second;
    if (std::abs(hit.distance) < std::abs(nearest.distance)) nearest = hit;
  }
  return sheets;
}

// A ray beside a border meets nothing of sheets whose borders lie there too, as where faces of a
// solid are objects of their own. Of those that lie on the side of the border's own sheet: which
// are in front once all is moved?
void LayerRays::add_adjoining_sheets(const SheetHits& outside, const SheetHits& inside,
                                     const Touching& curve, LayerCount& count) const {
  for (const auto& [sheet, hit] : inside) {
    if (sheet == part(curve.triangle) || outside.count(sheet) > 0) continue;
    const Side side = side_of_touch(hit.triangle, curve);
    if (side == Side::before) {
      ++count.layers;
      count.beside_nothing = false;
    } else if (side == Side::open) {
      ++count.unsure;
    }
  }
}

}  // namespace illustrate
