// What an edge's kind means: which line is drawn along it, and whether the surface ends there.
#pragma once

#include <algorithm>

#include "surface/surface.h"

namespace illustrate {

// A smooth edge is drawn only where it parts a front face from a back one, of polygon objects.
constexpr Kind line_kind(EdgeKind kind) {
  switch (kind) {
    case EdgeKind::boundary:
      return Kind::boundary;
    case EdgeKind::crease:
      return Kind::crease;
    case EdgeKind::seam:
      return Kind::seam;
    case EdgeKind::mark:
      return Kind::mark;
    case EdgeKind::material:
      return Kind::material;
    case EdgeKind::flat_outline:
      return Kind::flat_outline;
    case EdgeKind::smooth:
      break;
  }
  return Kind::silhouette;
}

// Edges at which a smooth surface ends: what lies beyond has other vertices at the same places, or
// there is nothing.
constexpr bool parts_surface(EdgeKind kind) {
  return kind == EdgeKind::boundary || kind == EdgeKind::crease || kind == EdgeKind::seam;
}

inline bool has_crease(const Surface& surface, int triangle) {
  const auto& kinds = surface.edge_kinds[idx(triangle)];
  return std::find(kinds.begin(), kinds.end(), EdgeKind::crease) != kinds.end();
}

}  // namespace illustrate
