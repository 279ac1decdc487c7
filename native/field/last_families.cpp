#include "field/last_families.h"

#include <cmath>

#include "surface/same_vertices.h"

namespace illustrate {
namespace {

// (n) the kept directions, each moved as a sum of the edges at its vertex; any length.
Points moved_directions(const Surface& surface, const LastFamilies& last) {
  const Points &from = last.surface->positions, &to = surface.positions;
  Points moved(to.size(), Vec3::Zero());
  for (const Triangle& triangle : surface.triangles) {
    for (int k = 0; k < 3; ++k) {
      const std::size_t v = idx(triangle[idx(k)]);
      const Vec3 kept = (*last.families)[v] > 0 ? last.field->directions[v]
                                                : across(*last.surface, *last.field, v);
      for (const int corner : {next_corner(k), previous_corner(k)}) {
        const std::size_t w = idx(triangle[idx(corner)]);
        const Vec3 before = from[w] - from[v], now = to[w] - to[v];
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
  if (last.families->size() != surface.positions.size()) return {};
  if (!has_same_vertices(*last.surface, surface)) return {};
  const Points moved = moved_directions(surface, last);
  Families families;
  for (std::size_t v = 0; v < moved.size(); ++v) {
    const double along = std::abs(field.directions[v].dot(moved[v]));
    families.push_back(along >= std::abs(across(surface, field, v).dot(moved[v])) ? 1 : -1);
  }
  return families;
}

}  // namespace illustrate
