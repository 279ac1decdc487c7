// Limit positions of the vertices of a mesh that is split at least once.
#pragma once

#include "control/half_edges.h"

namespace illustrate {

struct LimitPlaces {
  Points positions;  // (n)
  // (n) unit or zero: the normal at smooth vertices, the tangent along creases.
  Points directions;
  enum class Rule : std::uint8_t { smooth, crease, corner };
  std::vector<Rule> rules;  // (n)
};

// Of a mesh of quads (Catmull-Clark) or triangles (Loop) with these points, by the schemes' masks;
// semi-sharp edges count as smooth ones, and at the end of a single crease the mask is the smooth
// one, which is not the limit but near it.
LimitPlaces limit_places(const SoundMesh& mesh, const HalfEdges& edges,
                         const VertexSectors& sectors, const Points& points, Scheme scheme);

}  // namespace illustrate
