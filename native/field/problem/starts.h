// What the field starts from: principal directions or the default direction, and which vertices
// keep theirs (paper section 5, steps 2 and 3).
#pragma once

#include "field/cross_field.h"
#include "field/problem/alignment.h"
#include "field/problem/energy.h"

namespace illustrate {

struct FieldParts {
  std::vector<int> of_vertex;  // (n) part connected by edges: creases divide
  int count = 0;
};
FieldParts connected_parts(std::size_t vertices, const std::vector<FieldEdge>& edges,
                           const Progress& progress = {});

// (n) of each vertex's object, how large it is (core/spread.h).
std::vector<double> object_diagonals(const Surface& surface);

// One of the directions of each cross is at right angles to w2, even where w1 and w2 lie in another
// plane than the frame.
struct PrincipalCrosses {
  CrossNumbers directions;            // (n) that one; 0 where undefined
  CrossNumbers z;                     // (n) the default direction where undefined
  std::vector<std::uint8_t> defined;  // (n)
};
PrincipalCrosses principal_crosses(const TangentFrames& frames, const Curvature& curvature,
                                   const CrossNumbers& default_crosses,
                                   const Progress& progress = {});

// The projection of `direction`, of another axis where it is parallel to the normal.
CrossNumbers default_crosses(const TangentFrames& frames, const Vec3& direction,
                             const Progress& progress = {});

// Step 2: quasi-parabolic, curved enough to tell, and not in the middle of a singularity.
std::vector<std::uint8_t> reliable_vertices(const Curvature& curvature,
                                            const std::vector<FieldEdge>& edges,
                                            const PrincipalCrosses& principal,
                                            const std::vector<double>& diagonals,
                                            const FieldOptions& options,
                                            const Progress& progress = {});

// E of each part.
std::vector<double> part_energies(const FieldParts& parts, const std::vector<FieldEdge>& edges,
                                  const CrossNumbers& z);

// Turns all crosses of a part by one angle, which does not change E, so that they agree best with
// `wanted` (n; the length is the weight). `may_turn` (parts). Parts where nothing is wanted, or
// nothing prevails, stay.
void turn_parts(const FieldParts& parts, const std::vector<std::uint8_t>& may_turn,
                const CrossNumbers& wanted, CrossNumbers& z);

}  // namespace illustrate
