#include "surface/parts.h"

#include "core/spread.h"

namespace illustrate {
namespace {

// Gives the triangles that are connected with `first` its part's number; how far they reach.
Spread number_part(const Surface& surface, int first, int part, std::vector<int>& of_triangle) {
  Spread spread;
  std::vector<int> open{first};
  of_triangle[idx(first)] = part;
  while (!open.empty()) {
    const int triangle = open.back();
    open.pop_back();
    const Triangle& v = surface.triangles[idx(triangle)];
    spread.add(surface.positions[idx(v[0])], surface.positions[idx(v[1])],
               surface.positions[idx(v[2])]);
    for (const int other : surface.neighbours[idx(triangle)]) {
      if (other == none || of_triangle[idx(other)] != none) continue;
      of_triangle[idx(other)] = part;
      open.push_back(other);
    }
  }
  return spread;
}

}  // namespace

SurfaceParts surface_parts(const Surface& surface) {
  SurfaceParts parts;
  parts.of_triangle.assign(surface.triangles.size(), none);
  for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t) {
    if (parts.of_triangle[idx(t)] != none) continue;
    const auto part = static_cast<int>(parts.diagonals.size());
    const Spread spread = number_part(surface, t, part, parts.of_triangle);
    parts.diagonals.push_back(spread.diagonal());
    parts.middles.push_back(spread.middle());
    parts.areas.push_back(spread.area());
  }
  return parts;
}

}  // namespace illustrate
