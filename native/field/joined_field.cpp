#include "field/joined_field.h"

#include <algorithm>

namespace illustrate {
namespace {

// What one object has of the field that it is taken from.
void add_object(const CrossField& field, const Move& place, int first_vertex, int end_vertex,
                CrossField& result) {
  for (std::size_t v = idx(first_vertex); v < idx(end_vertex); ++v) {
    result.theta.push_back(field.theta[v]);
    result.reference.push_back(place.direction(field.reference[v]));
    result.directions.push_back(place.direction(field.directions[v]));
    result.reliable.push_back(field.reliable[v]);
  }
}

// Singularities by the object that they are on; their triangles ascend.
void add_singularities(const CrossField& field, const Move& place, int first_triangle,
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

CrossField joined(const std::vector<const CrossField*>& fields,
                  const std::vector<const Surface*>& surfaces, const ObjectSources& sources) {
  std::vector<std::vector<int>> vertices, triangles;
  CrossField result;
  result.converged = true;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    vertices.push_back(first_vertices(*surfaces[i]));
    triangles.push_back(first_triangles(*surfaces[i]));
    result.converged = result.converged && fields[i]->converged;
    result.evaluations += fields[i]->evaluations;
  }
  int next_triangle = 0;
  for (const auto& [surface, object, place] : sources) {
    const CrossField& field = *fields[idx(surface)];
    const Move move(place);
    const std::size_t o = idx(object);
    const int* vertex = &vertices[idx(surface)][o];
    const int* triangle = &triangles[idx(surface)][o];
    add_object(field, move, vertex[0], vertex[1], result);
    add_singularities(field, move, triangle[0], triangle[1], next_triangle - triangle[0], result);
    next_triangle += triangle[1] - triangle[0];
    result.energy += field.object_energies[o];
    result.energy_initial += field.object_energies_initial[o];
    result.object_energies.push_back(field.object_energies[o]);
    result.object_energies_initial.push_back(field.object_energies_initial[o]);
  }
  return result;
}

Families joined(const std::vector<const Families*>& families,
                const std::vector<const Surface*>& surfaces, const ObjectSources& sources) {
  std::vector<std::vector<int>> vertices;
  for (const Surface* surface : surfaces) vertices.push_back(first_vertices(*surface));
  Families result;
  for (const auto& [surface, object, place] : sources) {
    const auto begin = families[idx(surface)]->begin();
    const int* vertex = &vertices[idx(surface)][idx(object)];
    result.insert(result.end(), begin + vertex[0], begin + vertex[1]);
  }
  return result;
}

}  // namespace illustrate
