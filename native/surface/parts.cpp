#include "surface/parts.h"

namespace illustrate {
namespace {

// Gives the triangles that are connected with `first` its part's number; the box round them.
Eigen::AlignedBox3d number_part(const Surface& surface, int first, int part,
                                std::vector<int>& of_triangle) {
  Eigen::AlignedBox3d box;
  std::vector<int> open{first};
  of_triangle[idx(first)] = part;
  while (!open.empty()) {
    const int triangle = open.back();
    open.pop_back();
    for (const int vertex : surface.triangles[idx(triangle)]) {
      box.extend(surface.positions[idx(vertex)]);
    }
    for (const int other : surface.neighbours[idx(triangle)]) {
      if (other == none || of_triangle[idx(other)] != none) continue;
      of_triangle[idx(other)] = part;
      open.push_back(other);
    }
  }
  return box;
}

}  // namespace

SurfaceParts surface_parts(const Surface& surface) {
  SurfaceParts parts;
  parts.of_triangle.assign(surface.triangles.size(), none);
  for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t) {
    if (parts.of_triangle[idx(t)] != none) continue;
    const auto part = static_cast<int>(parts.diagonals.size());
    parts.diagonals.push_back(
        number_part(surface, t, part, parts.of_triangle).sizes().stableNorm());
  }
  return parts;
}

}  // namespace illustrate
