#include "field/problem/alignment.h"

#include <algorithm>

#include "surface/edge_kinds.h"

namespace illustrate {
namespace {

constexpr std::size_t triangles_per_report = 262144;

// A side of a triangle where copies of the same two points may meet.
struct FeatureSide {
  Edge places;  // lower first
  Edge ends;    // vertices at those places
  int triangle;
  std::array<int, 2> corners;  // of `ends` in the triangle

  // The triangle's winding runs from the first end to the second.
  bool is_forward() const { return next_corner(corners[0]) == corners[1]; }
};

bool attracts(EdgeKind kind) { return kind == EdgeKind::boundary || kind == EdgeKind::crease; }

FeatureSide feature_side(const Surface& surface, int triangle, int corner) {
  const Triangle& vertices = surface.triangles[idx(triangle)];
  FeatureSide side{{}, {}, triangle, {corner, next_corner(corner)}};
  const auto place = [&](int c) { return surface.places[idx(vertices[idx(c)])]; };
  if (place(side.corners[1]) < place(side.corners[0])) std::swap(side.corners[0], side.corners[1]);
  for (std::size_t e = 0; e < 2; ++e) {
    side.places[e] = place(side.corners[e]);
    side.ends[e] = vertices[idx(side.corners[e])];
  }
  return side;
}

Vec3 side_vector(const Surface& surface, const FeatureSide& side) {
  return surface.positions[idx(side.ends[1])] - surface.positions[idx(side.ends[0])];
}

// The two sheets are turned over against each other when they run along the edge the same way.
void couple(const Surface& surface, const TangentFrames& frames, const FeatureSide& a,
            const FeatureSide& b, double weight, std::vector<FieldEdge>& couplings) {
  const bool turned_over = a.is_forward() == b.is_forward();
  for (std::size_t e = 0; e < 2; ++e) {
    if (a.ends[e] == b.ends[e]) continue;
    const bool signs_differ = surface.corner_sign(a.triangle, a.corners[e]) !=
                              surface.corner_sign(b.triangle, b.corners[e]);
    couplings.push_back(field_edge(frames, a.ends[e], b.ends[e], signs_differ != turned_over,
                                   side_vector(surface, a), weight));
  }
}

}  // namespace

Alignment align_to_features(const Surface& surface, const TangentFrames& frames,
                            const std::vector<double>& diagonals, double weight,
                            const Progress& progress) {
  Alignment result{CrossNumbers(frames.size(), 0), {}};
  if (weight <= 0) return result;
  const auto side_weight = [&](const FeatureSide& side) {
    const double unit = diagonals[idx(side.ends[0])] / 100;
    const double length = side_vector(surface, side).norm();
    return unit > 0 && std::isfinite(length) ? weight * length / unit : 0.0;
  };
  std::vector<FeatureSide> sides;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    if (t % triangles_per_report == 0) {
      progress.report(static_cast<double>(t) / static_cast<double>(surface.triangles.size()));
    }
    for (int k = 0; k < 3; ++k) {
      const EdgeKind kind = surface.edge_kinds[t][idx(k)];
      if (!parts_surface(kind)) continue;
      const FeatureSide side = feature_side(surface, static_cast<int>(t), k);
      sides.push_back(side);
      if (!attracts(kind)) continue;
      for (const int end : side.ends) {
        const auto i = idx(end);
        const CrossNumber along = direction_in_frame(frames, i, side_vector(surface, side), 0);
        result.pulls[i] += side_weight(side) * fourth_power(along);
      }
    }
  }
  // Copies of one edge side by side: two sides of a crease, or any number of fins at a seam, each
  // coupled to the one before.
  std::stable_sort(sides.begin(), sides.end(),
                   [](const FeatureSide& a, const FeatureSide& b) { return a.places < b.places; });
  for (std::size_t s = 1; s < sides.size(); ++s) {
    if (sides[s - 1].places != sides[s].places) continue;
    couple(surface, frames, sides[s - 1], sides[s], side_weight(sides[s]), result.couplings);
  }
  return result;
}

}  // namespace illustrate
