#include "field/problem/starts.h"

#include <algorithm>

#include "core/disjoint_sets.h"
#include "core/parallel.h"

namespace illustrate {
namespace {

// A direction that is shorter than this after projection (of unit length before) is taken for the
// normal.
constexpr double least_start_projection = 1e-3;

// Wanted crosses that cancel to less than this share of their weight prefer no angle.
constexpr double least_agreement = 0.05;

// Mean of 1 + e over the edges of each vertex, by their weights, in [0, 2].
std::vector<double> mean_edge_energies(const std::vector<FieldEdge>& edges, const CrossNumbers& z,
                                       const Progress& progress) {
  std::vector<double> sums(z.size(), 0), weights(z.size(), 0);
  parallel_for(edges.size(), 1, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e) {
      const double weight = std::sqrt(std::norm(edges[e].transport));
      const double excess = weight + edge_energy(edges[e], z);
      for (const int vertex : {edges[e].from, edges[e].to}) {
        sums[idx(vertex)] += excess;
        weights[idx(vertex)] += weight;
      }
    }
  });
  for (std::size_t i = 0; i < z.size(); ++i) sums[i] /= weights[i] > 0 ? weights[i] : 1;
  return sums;
}

}  // namespace

FieldParts connected_parts(std::size_t vertices, const std::vector<FieldEdge>& edges,
                           const Progress& progress) {
  DisjointSets joined(vertices);
  parallel_for(edges.size(), 1, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e) {
      joined.join(edges[e].from, edges[e].to);
    }
  });
  FieldParts parts{std::vector<int>(vertices), 0};
  for (std::size_t i = 0; i < vertices; ++i) {  // a root is the lowest vertex of its part
    const auto r = idx(joined.root(static_cast<int>(i)));
    parts.of_vertex[i] = r == i ? parts.count++ : parts.of_vertex[r];
  }
  return parts;
}

std::vector<double> object_diagonals(const Surface& surface) {
  std::vector<double> diagonals;
  diagonals.reserve(surface.objects.size());
  for (const int object : surface.objects)
    diagonals.push_back(surface.object_diagonals[idx(object)]);
  return diagonals;
}

PrincipalCrosses principal_crosses(const TangentFrames& frames, const Curvature& curvature,
                                   const CrossNumbers& default_crosses, const Progress& progress) {
  PrincipalCrosses result{CrossNumbers(frames.size(), 0), default_crosses,
                          std::vector<std::uint8_t>(frames.size(), 0)};
  parallel_for(frames.size(), 1, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      // By w2: where a form is quasi-parabolic that is its straight direction, and what is across
      // runs round the form.
      const Vec3 across = curvature[i].w2.cross(frames.normals[i]);
      const CrossNumber w = direction_in_frame(frames, i, across, 0, 0.5);
      result.defined[i] = w != CrossNumber(0) && std::isfinite(curvature[i].k1) &&
                          std::isfinite(curvature[i].k2) && curvature[i].k1 != 0;
      if (!result.defined[i]) continue;
      result.directions[i] = w;
      result.z[i] = fourth_power(w);
    }
  });
  return result;
}

CrossNumbers default_crosses(const TangentFrames& frames, const Vec3& direction,
                             const Progress& progress) {
  const Vec3 first = direction.normalized();
  const Vec3 second(first.z(), first.x(), first.y());  // the axis before, when the first is an axis
  CrossNumbers z(frames.size());
  parallel_for(z.size(), 1, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const CrossNumber instead = direction_in_frame(frames, i, second);
      z[i] = fourth_power(direction_in_frame(frames, i, first, instead, least_start_projection));
    }
  });
  return z;
}

std::vector<std::uint8_t> reliable_vertices(const Curvature& curvature,
                                            const std::vector<FieldEdge>& edges,
                                            const PrincipalCrosses& principal,
                                            const std::vector<double>& diagonals,
                                            const FieldOptions& options, const Progress& progress) {
  std::vector<std::uint8_t> reliable(principal.z.size(), 0);
  if (options.parabolic_ratio <= 0) return reliable;
  const std::vector<double> mean_energies = mean_edge_energies(edges, principal.z, progress);
  for (std::size_t i = 0; i < reliable.size(); ++i) {
    const double k1 = std::abs(curvature[i].k1), k2 = std::abs(curvature[i].k2);
    const bool is_parabolic = k2 <= options.parabolic_ratio * k1;
    const bool is_curved = k1 * diagonals[i] >= options.least_curvature;
    const bool is_regular = mean_energies[i] <= options.largest_energy;
    reliable[i] = principal.defined[i] && is_parabolic && is_curved && is_regular;
  }
  return reliable;
}

std::vector<double> part_energies(const FieldParts& parts, const std::vector<FieldEdge>& edges,
                                  const CrossNumbers& z) {
  std::vector<double> sums(idx(parts.count), 0);
  for (const FieldEdge& edge : edges) {
    const int part = parts.of_vertex[idx(edge.from)];
    sums[idx(part)] += edge_energy(edge, z);
  }
  return sums;
}

void turn_parts(const FieldParts& parts, const std::vector<std::uint8_t>& may_turn,
                const CrossNumbers& wanted, CrossNumbers& z) {
  CrossNumbers turns(idx(parts.count), 0);
  std::vector<double> weights(turns.size(), 0);
  for (std::size_t i = 0; i < z.size(); ++i) {
    const auto part = idx(parts.of_vertex[i]);
    turns[part] += product(wanted[i], std::conj(z[i]));
    weights[part] += std::abs(wanted[i]);
  }
  for (std::size_t part = 0; part < turns.size(); ++part) {
    const bool prevails = std::abs(turns[part]) > least_agreement * weights[part];
    turns[part] = may_turn[part] && prevails ? normalized(turns[part], 1) : CrossNumber(1);
  }
  for (std::size_t i = 0; i < z.size(); ++i) {
    const CrossNumber turn = turns[idx(parts.of_vertex[i])];
    if (turn != CrossNumber(1)) z[i] = product(turn, z[i]);
  }
}

}  // namespace illustrate
