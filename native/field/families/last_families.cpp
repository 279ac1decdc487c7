#include "field/families/last_families.h"

#include <cmath>

#include "surface/same_objects.h"

namespace illustrate {
namespace {

// (n) the kept directions, each moved as a sum of the edges at its vertex; any length, zero where
// the object is another.
Points moved_directions(const Surface& surface, const SameObjects& same, const LastFamilies& last) {
  const Points &from = last.surface->positions, &to = surface.positions;
  Points moved(to.size(), Vec3::Zero());
  for (const Triangle& triangle : surface.triangles) {
    for (int k = 0; k < 3; ++k) {
      const std::size_t v = idx(triangle[idx(k)]);
      if (same.last_vertex(v) == none) continue;
      const std::size_t before_v = idx(same.last_vertex(v));
      const Vec3 kept = (*last.families)[before_v] > 0
                            ? last.field->directions[before_v]
                            : across(*last.surface, *last.field, before_v);
      for (const int corner : {next_corner(k), previous_corner(k)}) {
        const std::size_t w = idx(triangle[idx(corner)]);
        const Vec3 before = from[idx(same.last_vertex(w))] - from[before_v], now = to[w] - to[v];
        const double size = before.squaredNorm();
        if (size > 0) moved[v] += before.dot(kept) / size * now;
      }
    }
  }
  return moved;
}

}  // namespace

Families last_families(const Surface& surface, const CrossField& field, const LastFamilies& last) {
  if (!last.surface || !last.field || !last.families) return {};
  const SameObjects same(*last.surface, surface, last.objects);
  if (!same.any()) return {};
  const Points moved = moved_directions(surface, same, last);
  Families families;
  for (std::size_t v = 0; v < moved.size(); ++v) {
    // Where the last direction runs between both, or is zero, it is taken to run along.
    const double along = std::abs(field.directions[v].dot(moved[v]));
    const bool is_along = along >= std::abs(across(surface, field, v).dot(moved[v]));
    families.push_back(same.last_vertex(v) == none ? std::int8_t{0}
                                                   : static_cast<std::int8_t>(is_along ? 1 : -1));
  }
  return families;
}

}  // namespace illustrate
