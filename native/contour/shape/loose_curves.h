// Edges of no face as curves: wires, strands of hair, construction lines. Not in the paper, all of
// whose curves lie on the surface.
//
// They are no part of the network that the labels of a view are found on: that asks of each curve
// on which side its surface lies. They are cut and labelled afterwards (visibility/loose_labels.h).
#pragma once

#include "contour/network/curve_network.h"
#include "mesh/polygon_mesh.h"

namespace illustrate {

// PolygonMesh::loose_edges of the meshes with wanted[i] != 0, chained at vertices where just two of
// them meet and no face does. Strands are Kind::loose, hide nothing and lie on no triangle. Nodes
// are ends where one edge stops in free space, else joints. Left out are edges without length and
// such with an end that is not finite; edges given twice count once.
CurveNetwork loose_curves(const std::vector<std::shared_ptr<const PolygonMesh>>& meshes,
                          const std::vector<std::uint8_t>& wanted);

}  // namespace illustrate
