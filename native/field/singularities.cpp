#include "field/singularities.h"

#include <algorithm>

#include "core/parallel.h"
#include "core/pi.h"

namespace illustrate {
namespace {

constexpr double quarter_turn = pi / 2;

// How much the cross turns from one end of an edge to the other, in the frame of the first.
double edge_turn(const FieldEdge& edge, const CrossNumbers& z) {
  const CrossNumber carried = product(edge.transport, mirrored_if(edge.mirrored, z[idx(edge.to)]));
  return std::arg(product(std::conj(z[idx(edge.from)]), carried)) / 4;
}

using CornerAngles = std::vector<std::array<double, 3>>;

CornerAngles corner_angles(const Surface& surface, const TangentFrames& frames, int threads,
                           const Progress& progress) {
  CornerAngles angles(surface.triangles.size());
  parallel_for(angles.size(), threads, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      for (int k = 0; k < 3; ++k) {
        const auto at = [&](int corner) { return idx(surface.triangles[t][idx(corner)]); };
        const Vec3& apex = surface.positions[at(k)];
        angles[t][idx(k)] =
            surface.corner_sign(static_cast<int>(t), k) *
            angle_about(frames.normals[at(k)], surface.positions[at(next_corner(k))] - apex,
                        surface.positions[at(previous_corner(k))] - apex);
      }
    }
  });
  return angles;
}

// The sum of the corner angles of each vertex, and where its least corner is.
struct Fan {
  double sum = 0;
  double least = 4;  // more than any angle
  int triangle = none;
  int corner = none;
};

void unfold(const Surface& surface, const TriangleEdges& edges, CornerAngles& angles) {
  std::vector<Fan> fans(surface.positions.size());
  for (std::size_t t = 0; t < angles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      Fan& fan = fans[idx(surface.triangles[t][k])];
      fan.sum += angles[t][k];
      if (angles[t][k] >= fan.least) continue;
      fan.least = angles[t][k];
      fan.triangle = static_cast<int>(t);
      fan.corner = static_cast<int>(k);
    }
  }
  // A fan that ends at a border has no full turn to keep.
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (edges.faces[e] != 1) continue;
    for (const int end : edges.vertices[e]) fans[idx(end)].triangle = none;
  }
  for (const Fan& fan : fans) {
    if (fan.triangle == none) continue;
    const double missing = 1 - std::nearbyint(fan.sum / (2 * pi));
    angles[idx(fan.triangle)][idx(fan.corner)] += 2 * pi * missing;
  }
}

bool has_repeated_corner(const TriangleEdges& edges, std::size_t t) {
  const std::array<int, 3>& sides = edges.of_triangle[t];
  return std::count(sides.begin(), sides.end(), none) > 0;
}

}  // namespace

double side_sign(const Surface& surface, std::size_t triangle, int k) {
  const Triangle& t = surface.triangles[triangle];
  const bool is_along = t[idx(k)] < t[idx(next_corner(k))];
  return is_along ? surface.corner_sign(static_cast<int>(triangle), k)
                  : -surface.corner_sign(static_cast<int>(triangle), next_corner(k));
}

std::vector<double> triangle_excess(const Surface& surface, const TriangleEdges& edges,
                                    const TangentFrames& frames, int threads,
                                    const Progress& progress) {
  CornerAngles angles = corner_angles(surface, frames, threads, progress);
  unfold(surface, edges, angles);
  std::vector<double> excess(angles.size(), 0);
  for (std::size_t t = 0; t < angles.size(); ++t) {
    if (!has_repeated_corner(edges, t)) excess[t] = angles[t][0] + angles[t][1] + angles[t][2] - pi;
  }
  return excess;
}

std::vector<int> triangle_indices(const Surface& surface, const TriangleEdges& triangle_edges,
                                  const std::vector<FieldEdge>& edges,
                                  const std::vector<double>& excess, const CrossNumbers& z,
                                  int threads, const Progress& progress) {
  std::vector<double> turns(triangle_edges.size());
  parallel_for(turns.size(), threads, progress.part(0, 0.6),
               [&](std::size_t begin, std::size_t end) {
                 for (std::size_t e = begin; e < end; ++e) turns[e] = edge_turn(edges[e], z);
               });
  std::vector<int> indices(excess.size(), 0);
  parallel_for(
      indices.size(), threads, progress.part(0.6, 1), [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
          if (has_repeated_corner(triangle_edges, t)) continue;
          double sum = excess[t];
          for (int k = 0; k < 3; ++k) {
            sum += side_sign(surface, t, k) * turns[idx(triangle_edges.of_triangle[t][idx(k)])];
          }
          indices[t] = static_cast<int>(std::nearbyint(sum / quarter_turn));
        }
      });
  return indices;
}

}  // namespace illustrate
