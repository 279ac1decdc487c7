#include "field/joined_field.h"

#include <algorithm>

namespace illustrate {
namespace {

// What one object has of the field that it is taken from.
void add_vertices(const CrossField& field, const Move& place, int first_vertex, int end_vertex,
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

void add_energies(const CrossField& field, std::size_t object, CrossField& result) {
  result.energy += field.object_energies[object];
  result.energy_initial += field.object_energies_initial[object];
  result.object_energies.push_back(field.object_energies[object]);
  result.object_energies_initial.push_back(field.object_energies_initial[object]);
}

}  // namespace

CrossField joined(const std::vector<const CrossField*>& fields,
                  const std::vector<const Surface*>& surfaces, const ObjectSources& sources) {
  CrossField result;
  result.converged = true;
  for (const CrossField* field : fields) {
    result.converged = result.converged && field->converged;
    result.evaluations += field->evaluations;
  }
  const auto visit = [&](const ObjectSource& source, int begin, int end) {
    const CrossField& field = *fields[idx(source.surface)];
    add_vertices(field, Move(source.place), begin, end, result);
    add_energies(field, idx(source.object), result);
  };
  visit_sources(surfaces, sources, first_vertices, visit);
  int next = 0;
  const auto visit_triangles = [&](const ObjectSource& source, int begin, int end) {
    const CrossField& field = *fields[idx(source.surface)];
    add_singularities(field, Move(source.place), begin, end, next - begin, result);
    next += end - begin;
  };
  visit_sources(surfaces, sources, first_triangles, visit_triangles);
  return result;
}

Families joined(const std::vector<const Families*>& families,
                const std::vector<const Surface*>& surfaces, const ObjectSources& sources) {
  Families result;
  const auto visit = [&](const ObjectSource& source, int begin, int end) {
    const auto from = families[idx(source.surface)]->begin();
    result.insert(result.end(), from + begin, from + end);
  };
  visit_sources(surfaces, sources, first_vertices, visit);
  return result;
}

}  // namespace illustrate
