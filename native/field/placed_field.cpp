#include "field/placed_field.h"

#include <algorithm>

namespace illustrate {
namespace {

// What one object has of the field of its original.
void add_object(const CrossField& field, const Similarity& place, int first_vertex, int end_vertex,
                CrossField& result) {
  for (std::size_t v = idx(first_vertex); v < idx(end_vertex); ++v) {
    result.theta.push_back(field.theta[v]);
    result.reference.push_back(place.direction(field.reference[v]));
    result.directions.push_back(place.direction(field.directions[v]));
    result.reliable.push_back(field.reliable[v]);
  }
}

// Singularities by the original that they are on; their triangles ascend.
void add_singularities(const CrossField& field, const Similarity& place, int first_triangle,
                       int end_triangle, int shift, CrossField& result) {
  const auto& triangles = field.singular_triangles;
  const auto begin = std::lower_bound(triangles.begin(), triangles.end(), first_triangle);
  for (auto it = begin; it != triangles.end() && *it < end_triangle; ++it) {
    const auto s = static_cast<std::size_t>(it - triangles.begin());
    result.singular_triangles.push_back(*it + shift);
    result.singular_indices.push_back(field.singular_indices[s]);
    result.singular_positions.push_back(place.point(field.singular_positions[s]));
  }
}

}  // namespace

CrossField placed(const CrossField& field, const Surface& originals, const Instances& instances) {
  const std::vector<int> vertices = first_vertices(originals);
  const std::vector<int> triangles = first_triangles(originals);
  CrossField result;
  result.converged = field.converged;
  result.evaluations = field.evaluations;
  int next_triangle = 0;
  for (std::size_t o = 0; o < instances.originals.size(); ++o) {
    const std::size_t original = idx(instances.originals[o]);
    const Similarity& place = instances.placements[o];
    add_object(field, place, vertices[original], vertices[original + 1], result);
    add_singularities(field, place, triangles[original], triangles[original + 1],
                      next_triangle - triangles[original], result);
    next_triangle += triangles[original + 1] - triangles[original];
    result.energy += field.object_energies[original];
    result.energy_initial += field.object_energies_initial[original];
    result.object_energies.push_back(field.object_energies[original]);
    result.object_energies_initial.push_back(field.object_energies_initial[original]);
  }
  return result;
}

Families placed(const Families& families, const Surface& originals, const Instances& instances) {
  const std::vector<int> vertices = first_vertices(originals);
  Families result;
  for (const int original : instances.originals) {
    result.insert(result.end(), families.begin() + vertices[idx(original)],
                  families.begin() + vertices[idx(original) + 1]);
  }
  return result;
}

}  // namespace illustrate
