#include "surface/edges.h"

#include <algorithm>
#include <cmath>

#include "core/tolerances.h"
#include "surface/polygons.h"

namespace illustrate {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

// Unit, or zero where a triangle has no usable normal.
Vec3 triangle_normal(const Surface& surface, const Triangle& t) {
  const Vec3& a = surface.positions[index(t[0])];
  const Vec3& b = surface.positions[index(t[1])];
  const Vec3& c = surface.positions[index(t[2])];
  const Vec3 across = (b - a).cross(c - a);
  const double longest =
      std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  if (!(across.norm() / 2 > tolerance::degenerate_area * longest)) return Vec3::Zero();
  return unit_or_zero(across);
}

// The edge of `neighbour` that is edge k of `triangle`, whose corners are `from`.
int edge_towards(const Surface& surface, int triangle, int neighbour, const Triangle& from, int k) {
  for (int j = 0; j < 3; ++j) {
    if (surface.neighbours[index(neighbour)][index(j)] != triangle) continue;
    const Triangle& t = surface.triangles[index(neighbour)];
    const int a = surface.places[index(t[index(j)])];
    const int b = surface.places[index(t[index(next_corner(j))])];
    const int c = surface.places[index(from[index(k)])];
    const int d = surface.places[index(from[index(next_corner(k))])];
    if ((a == d && b == c) || (a == c && b == d)) return j;
  }
  return none;
}

// The normal of a triangle that may be part of a flat area, else zero. A strip of a smooth cylinder
// is flat, the cylinder is not: its normals turn across the strip.
Vec3 flat_normal(const Surface& surface, int t) {
  const Triangle& triangle = surface.triangles[index(t)];
  const Vec3 normal = triangle_normal(surface, triangle);
  if (!surface.object_is_smooth[index(surface.triangle_objects[index(t)])]) return normal;
  for (int k = 0; k < 3; ++k) {
    const Vec3 own = surface.corner_sign(t, k) * surface.normals[index(triangle[index(k)])];
    if ((own - normal).norm() > tolerance::flat_rad) return Vec3::Zero();
  }
  return normal;
}

class FlatAreas {
 public:
  explicit FlatAreas(Surface& surface) : surface_(surface), areas_(surface.triangles.size(), none) {
    for (int t = 0; t < static_cast<int>(areas_.size()); ++t) {
      normals_.push_back(flat_normal(surface, t));
    }
    covered_ =
        std::any_of(surface.flips.begin(), surface.flips.end(), [](int f) { return f != 0; });
  }

  void run() {
    for (int t = 0; t < static_cast<int>(areas_.size()); ++t) {
      if (areas_[index(t)] == none && !normals_[index(t)].isZero()) grow(t);
    }
    for (int t = 0; t < static_cast<int>(areas_.size()); ++t) {
      for (int k = 0; k < 3; ++k) mark_if_outline(t, k);
    }
  }

 private:
  // Two triangles of opposite sheets of a double cover run along their edge in the same direction.
  bool same_sheet(int t, int k, int neighbour) const {
    if (!covered_) return true;
    const int j = edge_towards(surface_, t, neighbour, surface_.triangles[index(t)], k);
    if (j == none) return true;
    return surface_.places[index(surface_.triangles[index(t)][index(k)])] !=
           surface_.places[index(surface_.triangles[index(neighbour)][index(j)])];
  }

  // An area too small to count gives its triangles back.
  void grow(int seed) {
    area_.assign(1, {seed, 1.0});
    areas_[index(seed)] = seed;
    for (std::size_t i = 0; i < area_.size(); ++i) {
      const auto [t, sign] = area_[i];
      for (int k = 0; k < 3; ++k) {
        const int n = surface_.neighbours[index(t)][index(k)];
        if (n == none || areas_[index(n)] != none || is_divided(t, k)) continue;
        const double turned = same_sheet(t, k, n) ? sign : -sign;
        if (!agree(normals_[index(seed)], turned * normals_[index(n)])) continue;
        areas_[index(n)] = seed;
        area_.push_back({n, turned});
      }
    }
    if (area_.size() >= smallest_area) return;
    for (const Member& member : area_) areas_[index(member.triangle)] = none;
  }

  bool is_divided(int t, int k) const {
    const EdgeKind kind = surface_.edge_kinds[index(t)][index(k)];
    return kind == EdgeKind::crease || kind == EdgeKind::boundary || kind == EdgeKind::seam;
  }

  static bool agree(const Vec3& a, const Vec3& b) {
    return !b.isZero() && (a - b).norm() <= tolerance::flat_rad;
  }

  void mark_if_outline(int t, int k) {
    const int n = surface_.neighbours[index(t)][index(k)];
    EdgeKind& kind = surface_.edge_kinds[index(t)][index(k)];
    if (n == none || kind != EdgeKind::smooth || areas_[index(t)] == areas_[index(n)]) return;
    kind = EdgeKind::flat_outline;
  }

  struct Member {
    int triangle;
    double sign;
  };
  static constexpr std::size_t smallest_area = 3;

  Surface& surface_;
  Points normals_;
  std::vector<int> areas_;  // first triangle of the area, `none` outside
  std::vector<Member> area_;
  bool covered_ = false;  // some sheets of a double cover meet
};

}  // namespace

void mark_flat_outlines(Surface& surface) { FlatAreas(surface).run(); }

void collect_feature_edges(Surface& surface) {
  for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t) {
    for (int k = 0; k < 3; ++k) {
      const EdgeKind kind = surface.edge_kinds[index(t)][index(k)];
      const int n = surface.neighbours[index(t)][index(k)];
      if (kind == EdgeKind::smooth || (kind != EdgeKind::crease && n != none && n < t)) continue;
      const Triangle& triangle = surface.triangles[index(t)];
      surface.feature_edges.push_back({triangle[index(k)], triangle[index(next_corner(k))]});
      surface.feature_kinds.push_back(kind);
    }
  }
}

}  // namespace illustrate
