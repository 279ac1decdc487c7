#include "field/problem/edges.h"

#include <algorithm>

#include "core/parallel.h"

namespace illustrate {
namespace {

constexpr std::size_t vertices_per_report = 65536;

// One side of a triangle, in the list of its lower vertex.
struct Side {
  int higher;
  int triangle;
  int corner;
};

Ragged<Side> sides_by_lower_vertex(const std::vector<Triangle>& triangles, std::size_t vertices) {
  return sorted_into<Side>(vertices, [&](const auto& put) {
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      for (int k = 0; k < 3; ++k) {
        const int a = triangles[t][idx(k)];
        const int b = triangles[t][idx(next_corner(k))];
        if (a != b) put(std::min(a, b), Side{std::max(a, b), static_cast<int>(t), k});
      }
    }
  });
}

bool ends_on_different_sheets(const Surface& surface, const Side& side) {
  return surface.corner_sign(side.triangle, side.corner) !=
         surface.corner_sign(side.triangle, next_corner(side.corner));
}

}  // namespace

TriangleEdges triangle_edges(const Surface& surface, const Progress& progress) {
  TriangleEdges edges;
  edges.of_triangle.assign(surface.triangles.size(), {none, none, none});
  progress.report(0);
  Ragged<Side> lists = sides_by_lower_vertex(surface.triangles, surface.positions.size());
  edges.vertices.reserve(surface.triangles.size() * 3 / 2);
  for (std::size_t lower = 0; lower < lists.size(); ++lower) {
    if (lower % vertices_per_report == 0) {
      progress.report(0.4 + 0.6 * static_cast<double>(lower) / static_cast<double>(lists.size()));
    }
    const Span<Side> sides = lists[lower];
    std::stable_sort(sides.begin(), sides.end(),
                     [](const Side& a, const Side& b) { return a.higher < b.higher; });
    for (const Side& side : sides) {
      const Edge edge{static_cast<int>(lower), side.higher};
      if (edges.vertices.empty() || edges.vertices.back() != edge) {
        edges.vertices.push_back(edge);
        edges.faces.push_back(0);
        edges.mirrored.push_back(ends_on_different_sheets(surface, side));
      }
      ++edges.faces.back();
      edges.of_triangle[idx(side.triangle)][idx(side.corner)] = static_cast<int>(edges.size()) - 1;
    }
  }
  return edges;
}

FieldEdge field_edge(const TangentFrames& frames, int from, int to, bool mirrored,
                     const Vec3& direction, double weight) {
  const auto at = [&](int vertex) {
    return fourth_power(direction_in_frame(frames, idx(vertex), direction));
  };
  const CrossNumber back = std::conj(mirrored_if(mirrored, at(to)));
  return {from, to, mirrored, weight * product(at(from), back)};
}

std::vector<FieldEdge> field_edges(const Surface& surface, const TriangleEdges& edges,
                                   const TangentFrames& frames, const std::vector<double>& weights,
                                   int threads, const Progress& progress) {
  std::vector<FieldEdge> result(edges.size());
  parallel_for(edges.size(), threads, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e) {
      const auto [i, j] = edges.vertices[e];
      const Vec3 along = surface.positions[idx(j)] - surface.positions[idx(i)];
      const double weight = weights.empty() ? 1 : weights[e];
      result[e] = field_edge(frames, i, j, edges.mirrored[e], along, weight);
    }
  });
  return result;
}

}  // namespace illustrate
