// Singularities that an artist prescribes: the connection between the vertices is adjusted until a
// field that is parallel by it has these singularities and no others (Crane et al. 2010, "Trivial
// connections on discrete surfaces").
//
// Each edge gets an angle delta by which the cross turns along it. The least deltas (sum of
// squares) for which the index of every triangle is the wanted one come from one Laplacian of the
// triangles; they replace c_ij by c_ij - 4 delta_ij in the energy. Closed parts need indices that
// sum to 4 chi; through a boundary any sum flows off.
#pragma once

#include "field/problem/edges.h"
#include "field/problem/guidance.h"
#include "field/problem/starts.h"
#include "mesh/bvh.h"

namespace illustrate {

struct PlacedSingularities {
  std::vector<int> index_of_triangle;   // (t) wanted index: -1, 0 or 1; empty: nothing prescribed
  std::vector<std::uint8_t> has_parts;  // (parts) 1: some are prescribed in this part
};

// A triangle cannot turn the cross by more than a quarter, nor can neighbours that both do be told
// apart: what is prescribed in a triangle beside another goes to the next one, and an index of
// several quarter turns becomes as many single ones in triangles close by that share no vertex.
// Throws InvalidInput where there is no room, and for a closed part whose indices do not sum to
// 4 chi, naming both sums.
PlacedSingularities place_singularities(const Surface& surface, const TriangleEdges& edges,
                                        const FieldParts& parts, const Bvh& bvh,
                                        const std::vector<double>& excess,
                                        const PrescribedSingularities& prescribed);

// (m) radians that the cross turns along each edge, from its lower end to the higher one in the
// frame of the lower; 0 in parts where nothing is prescribed.
std::vector<double> least_turns(const Surface& surface, const TriangleEdges& edges,
                                const std::vector<double>& excess, const FieldParts& parts,
                                const PlacedSingularities& placed);

// The field that is parallel along a tree of edges in each of the parts where something is
// prescribed, by the adjusted `edges`; elsewhere z stays.
void comb_along_tree(const std::vector<FieldEdge>& edges, const FieldParts& parts,
                     const std::vector<std::uint8_t>& chosen_parts, CrossNumbers& z);

}  // namespace illustrate
