#include "field/singularities.h"

#include <algorithm>

#include "core/parallel.h"

namespace illustrate {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double quarter_turn = pi / 2;

// How much the cross turns from the lower end of an edge to the higher one, in the lower end's
// frame.
double edge_turn(const Surface& surface, const TriangleEdges& edges, const TangentFrames& frames,
                 const Points& directions, std::size_t e) {
  const auto i = static_cast<std::size_t>(edges.vertices[e][0]);
  const auto j = static_cast<std::size_t>(edges.vertices[e][1]);
  const Vec3 along = surface.positions[j] - surface.positions[i];
  const double sign = edges.mirrored[e] ? -1 : 1;
  const double turn = sign * angle_about(frames.normals[j], along, directions[j]) -
                      angle_about(frames.normals[i], along, directions[i]);
  return turn - quarter_turn * std::nearbyint(turn / quarter_turn);
}

using CornerAngles = std::vector<std::array<double, 3>>;

CornerAngles corner_angles(const Surface& surface, const TangentFrames& frames, int threads) {
  CornerAngles angles(surface.triangles.size());
  parallel_for(angles.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      for (int k = 0; k < 3; ++k) {
        const auto at = [&](int corner) {
          return static_cast<std::size_t>(surface.triangles[t][static_cast<std::size_t>(corner)]);
        };
        const Vec3& apex = surface.positions[at(k)];
        angles[t][static_cast<std::size_t>(k)] =
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
      Fan& fan = fans[static_cast<std::size_t>(surface.triangles[t][k])];
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
    for (const int end : edges.vertices[e]) fans[static_cast<std::size_t>(end)].triangle = none;
  }
  for (const Fan& fan : fans) {
    if (fan.triangle == none) continue;
    const double missing = 1 - std::nearbyint(fan.sum / (2 * pi));
    angles[static_cast<std::size_t>(fan.triangle)][static_cast<std::size_t>(fan.corner)] +=
        2 * pi * missing;
  }
}

// Sum of the turns of the sides, seen from the front of the triangle.
double turn_around(const Surface& surface, const TriangleEdges& edges,
                   const std::vector<double>& turns, std::size_t t) {
  double sum = 0;
  for (int k = 0; k < 3; ++k) {
    const int e = edges.of_triangle[t][static_cast<std::size_t>(k)];
    const int a = surface.triangles[t][static_cast<std::size_t>(k)];
    const int b = surface.triangles[t][static_cast<std::size_t>(next_corner(k))];
    const int triangle = static_cast<int>(t);
    sum +=
        turns[static_cast<std::size_t>(e)] *
        (a < b ? surface.corner_sign(triangle, k) : -surface.corner_sign(triangle, next_corner(k)));
  }
  return sum;
}

}  // namespace

void find_singularities(const Surface& surface, const TriangleEdges& edges,
                        const TangentFrames& frames, int threads, CrossField& field) {
  std::vector<double> turns(edges.size());
  parallel_for(edges.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e) {
      turns[e] = edge_turn(surface, edges, frames, field.directions, e);
    }
  });
  CornerAngles angles = corner_angles(surface, frames, threads);
  unfold(surface, edges, angles);
  for (std::size_t t = 0; t < angles.size(); ++t) {
    const std::array<int, 3>& sides = edges.of_triangle[t];
    if (std::count(sides.begin(), sides.end(), none) > 0) continue;  // a corner is repeated
    const double excess = angles[t][0] + angles[t][1] + angles[t][2] - pi;
    const auto index = static_cast<int>(
        std::nearbyint((turn_around(surface, edges, turns, t) + excess) / quarter_turn));
    if (index == 0) continue;
    field.singular_triangles.push_back(static_cast<int>(t));
    field.singular_indices.push_back(index);
  }
}

}  // namespace illustrate
