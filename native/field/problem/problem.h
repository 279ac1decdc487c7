// Everything that is known before the search for a field.
#pragma once

#include "field/problem/plane_crosses.h"
#include "field/problem/prescribed.h"
#include "field/problem/starts.h"

namespace illustrate {

struct FieldProblem {
  TangentFrames frames;
  TriangleEdges triangle_edges;
  std::vector<FieldEdge> edges;  // adjusted where singularities are prescribed
  std::vector<double> turns;     // (m) by which they are; empty: nowhere
  std::vector<double> excess;    // (t) of the triangles' corner angles
  FieldParts parts;
  Alignment alignment;
  CrossNumbers guide_pulls;  // (n)
  PlacedSingularities prescribed;
  CrossNumbers by_default;
  PrincipalCrosses principal;
  std::vector<std::uint8_t> reliable;  // (n)
  PlaneCrosses planes;
  CrossNumbers initial;

  // Whether the vertex keeps its cross.
  bool is_held(std::size_t vertex) const {
    return reliable[vertex] || planes.planes[vertex] != none;
  }
};

FieldProblem state_problem(const Surface& surface, const Curvature& curvature,
                           const FieldOptions& options, const FieldAids& aids,
                           const Progress& progress);

// (parts) what is minimised, and the least that it could be: all edges parallel, all guides
// followed.
std::vector<double> part_energies(const FieldProblem& p, const CrossNumbers& z);
std::vector<double> least_energies(const FieldProblem& p);

// (parts) 1: nothing is held, and all crosses may turn by one angle without a change of energy.
std::vector<std::uint8_t> parts_that_may_turn(const FieldProblem& p);

// (parts) 1: some crosses are pulled or coupled by creases, boundaries or seams.
std::vector<std::uint8_t> parts_with_features(const FieldProblem& p);

// The edges before they were adjusted.
std::vector<FieldEdge> plain_edges(const FieldProblem& p);

}  // namespace illustrate
