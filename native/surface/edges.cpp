#include "surface/edges.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "core/tolerances.h"
#include "mesh/polygons.h"
#include "surface/edge_kinds.h"

namespace illustrate {
namespace {

// What lies this near a plane, as a share of the diagonal, lies in it: coordinates of single
// precision or six digits are no better, and edges as short as drawings show bend farther.
constexpr double near_plane = 1e-6;

// Unit, or zero where a triangle has no usable normal.
Vec3 triangle_normal(const Surface& surface, const Triangle& t) {
  const Vec3& a = surface.positions[idx(t[0])];
  const Vec3& b = surface.positions[idx(t[1])];
  const Vec3& c = surface.positions[idx(t[2])];
  const Vec3 across = (b - a).cross(c - a);
  const double longest =
      std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  if (!(across.norm() / 2 > tolerance::degenerate_area * longest)) return Vec3::Zero();
  return unit_or_zero(across);
}

// The edge of `neighbour` that is edge k of `triangle`, whose corners are `from`.
int edge_towards(const Surface& surface, int triangle, int neighbour, const Triangle& from, int k) {
  for (int j = 0; j < 3; ++j) {
    if (surface.neighbours[idx(neighbour)][idx(j)] != triangle) continue;
    const Triangle& t = surface.triangles[idx(neighbour)];
    const int a = surface.places[idx(t[idx(j)])];
    const int b = surface.places[idx(t[idx(next_corner(j))])];
    const int c = surface.places[idx(from[idx(k)])];
    const int d = surface.places[idx(from[idx(next_corner(k))])];
    if ((a == d && b == c) || (a == c && b == d)) return j;
  }
  return none;
}

bool agree(const Vec3& a, const Vec3& b) { return (a - b).norm() <= tolerance::flat_rad; }

// The normal of a triangle that may be part of a flat area, else zero. A strip of a smooth cylinder
// is flat, the cylinder is not: its normals turn across the strip.
Vec3 flat_normal(const Surface& surface, int t) {
  const Triangle& triangle = surface.triangles[idx(t)];
  const bool smooth = surface.is_smooth_at(t);
  const auto own = [&](int k) -> Vec3 {
    return surface.corner_sign(t, k) * surface.normals[idx(triangle[idx(k)])];
  };
  const auto turns = [&](int k) {
    // Near one normal they differ by twice flat_rad at most; a third is room for rounding.
    return (own(k) - own(0)).squaredNorm() > 9 * tolerance::flat_rad * tolerance::flat_rad;
  };
  if (smooth && (turns(1) || turns(2))) return Vec3::Zero();  // no normal is near to all three
  const Vec3 normal = triangle_normal(surface, triangle);
  for (int k = 0; smooth && k < 3; ++k) {
    if (!agree(own(k), normal)) return Vec3::Zero();
  }
  return normal;
}

class FlatAreas {
 public:
  FlatAreas(Surface& surface, int threads)
      : surface_(surface), threads_(threads), areas_(surface.triangles.size()) {
    covered_ =
        std::any_of(surface.flips.begin(), surface.flips.end(), [](int f) { return f != 0; });
  }

  void run() {
    find_candidates();
    bool any = false;
    for (int t = 0; t < static_cast<int>(areas_.size()); ++t) {
      if (areas_[idx(t)] == candidate) any |= grow(t);
    }
    if (!any) return;
    if (!covered_) take_in_slivers();
    for_each_triangle([&](int t) {
      for (int k = 0; k < 3; ++k) mark_if_outline(t, k);
    });
  }

 private:
  template <class Body>
  void for_each_triangle(const Body& body) const {
    parallel_for(surface_.triangles.size(), threads_, [&](std::size_t begin, std::size_t end) {
      for (std::size_t t = begin; t < end; ++t) body(static_cast<int>(t));
    });
  }

  void find_candidates() {
    for_each_triangle(
        [&](int t) { areas_[idx(t)] = flat_normal(surface_, t).isZero() ? none : candidate; });
  }

  // Two triangles of opposite sheets of a double cover run along their edge in the same direction.
  bool same_sheet(int t, int k, int neighbour) const {
    if (!covered_) return true;
    const int j = edge_towards(surface_, t, neighbour, surface_.triangles[idx(t)], k);
    if (j == none) return true;
    return surface_.places[idx(surface_.triangles[idx(t)][idx(k)])] !=
           surface_.places[idx(surface_.triangles[idx(neighbour)][idx(j)])];
  }

  // False for an area too small to count, which gives its triangles back.
  bool grow(int seed) {
    const Vec3 normal = flat_normal(surface_, seed);
    area_.assign(1, {seed, 1.0});
    areas_[idx(seed)] = seed;
    for (std::size_t i = 0; i < area_.size(); ++i) {
      const auto [t, sign] = area_[i];
      for (int k = 0; k < 3; ++k) {
        const int n = surface_.neighbours[idx(t)][idx(k)];
        if (n == none || areas_[idx(n)] != candidate || is_divided(t, k)) continue;
        const double turned = same_sheet(t, k, n) ? sign : -sign;
        if (!agree(normal, turned * flat_normal(surface_, n))) continue;
        areas_[idx(n)] = seed;
        area_.push_back({n, turned});
      }
    }
    // Two triangles are a single quad, which any smooth surface may have flat.
    if (area_.size() >= smallest_area) return true;
    for (const Member& member : area_) areas_[idx(member.triangle)] = candidate;
    return false;
  }

  // On a mesh that is no cage triangles beside an area that lie in its plane belong to it, whatever
  // their normals: needles, whose normals are rounding, and what the scheme folds within the plane.
  // Of two areas in one plane the larger takes in the other. Vertices of one area alone get its
  // normal.
  void take_in_slivers() {
    sizes_.assign(areas_.size(), 0);
    for (const int a : areas_) {
      if (a >= 0) ++sizes_[idx(a)];
    }
    std::vector<int> members;  // triangles of areas, those of larger ones first
    for (int t = 0; t < static_cast<int>(areas_.size()); ++t) {
      if (areas_[idx(t)] >= 0 && !is_cage(t)) members.push_back(t);
    }
    const auto size = [&](int t) { return sizes_[idx(areas_[idx(t)])]; };
    std::stable_sort(members.begin(), members.end(),
                     [&](int a, int b) { return size(a) > size(b); });
    for (std::size_t i = 0; i < members.size(); ++i) take_in_neighbours(members[i], members);
    flatten_normals();
  }

  bool is_cage(int t) const {
    return surface_.controls[idx(surface_.object_of(t))].mesh->mesh.cage;
  }

  void take_in_neighbours(int t, std::vector<int>& found) {
    const int seed = areas_[idx(t)];
    for (int k = 0; k < 3; ++k) {
      const int n = surface_.neighbours[idx(t)][idx(k)];
      if (n == none || is_divided(t, k) || !is_smaller(areas_[idx(n)], seed)) continue;
      if (!lies_in_plane(n, seed)) continue;
      areas_[idx(n)] = seed;
      found.push_back(n);
    }
  }

  bool is_smaller(int area, int than) const {
    return area < 0 || sizes_[idx(area)] < sizes_[idx(than)];
  }

  bool lies_in_plane(int t, int seed) const {
    const Vec3 normal = flat_normal(surface_, seed);
    const Vec3& origin = surface_.positions[idx(surface_.triangles[idx(seed)][0])];
    for (const int v : surface_.triangles[idx(t)]) {
      const double off = normal.dot(surface_.positions[idx(v)] - origin);
      if (!(std::abs(off) <= near_plane * surface_.diagonal)) return false;
    }
    return true;
  }

  void flatten_normals() {
    std::vector<int> vertex_areas(surface_.positions.size(), candidate);  // none: of several
    for (std::size_t t = 0; t < areas_.size(); ++t) {
      for (const int v : surface_.triangles[t]) {
        int& found = vertex_areas[idx(v)];
        found = found == candidate || found == areas_[t] ? area(static_cast<int>(t)) : none;
      }
    }
    for (std::size_t v = 0; v < vertex_areas.size(); ++v) {
      if (vertex_areas[v] < 0 || is_cage(vertex_areas[v])) continue;
      const Vec3 normal = area_normal(vertex_areas[v]);
      const Vec3 w1 = tangent_towards(surface_.curvature[v].w1, normal);
      surface_.normals[v] = normal;
      surface_.curvature[v] = {0, 0, w1, normal.cross(w1)};
    }
  }

  // That of its first triangle, which no other vertex of the area may change.
  Vec3 area_normal(int seed) const {
    return triangle_normal(surface_, surface_.triangles[idx(seed)]);
  }

  int area(int t) const { return std::max(areas_[idx(t)], none); }

  bool is_divided(int t, int k) const { return parts_surface(surface_.edge_kinds[idx(t)][idx(k)]); }

  void mark_if_outline(int t, int k) {
    const int n = surface_.neighbours[idx(t)][idx(k)];
    EdgeKind& kind = surface_.edge_kinds[idx(t)][idx(k)];
    if (n == none || kind != EdgeKind::smooth || area(t) == area(n)) return;
    kind = EdgeKind::flat_outline;
  }

  struct Member {
    int triangle;
    double sign;
  };
  static constexpr std::size_t smallest_area = 3;
  static constexpr int candidate = -2;  // flat, in no area yet

  Surface& surface_;
  int threads_;
  std::vector<int> areas_;  // first triangle of the area; negative outside
  std::vector<Member> area_;
  std::vector<int> sizes_;  // of areas as they were grown, by their first triangles
  bool covered_ = false;    // some sheets of a double cover meet
};

}  // namespace

void mark_flat_outlines(Surface& surface, int threads) { FlatAreas(surface, threads).run(); }

void collect_feature_edges(Surface& surface) {
  for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t) {
    for (int k = 0; k < 3; ++k) {
      const EdgeKind kind = surface.edge_kinds[idx(t)][idx(k)];
      const int n = surface.neighbours[idx(t)][idx(k)];
      if (kind == EdgeKind::smooth || (kind != EdgeKind::crease && n != none && n < t)) continue;
      const Triangle& triangle = surface.triangles[idx(t)];
      surface.feature_edges.push_back({triangle[idx(k)], triangle[idx(next_corner(k))]});
      surface.feature_kinds.push_back(kind);
    }
  }
}

}  // namespace illustrate
