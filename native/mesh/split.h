// Edges with more than two faces and vertices with more than one fan are taken apart.
#pragma once

#include "core/report.h"
#include "mesh/faces.h"

namespace illustrate {

// Joins the two faces of an edge, whatever their winding. Of more than two faces those that
// continue each other best are joined: first pairs whose windings agree, then the straightest, then
// the convex before the concave (solids that touch along an edge come apart). The rest stays open.
// At vertices of more than max_valence corners nothing is joined. Counts "split_edges".
FaceAdjacency join_faces(const Faces& faces, const Points& positions, Counts& report);

// Numbers the fans of consistently wound faces: faces.corners become numbers of fans, in the order
// of the vertices they stem from. Returns the vertex of each fan. Opens edges that would still have
// more than two faces.
std::vector<int> split_vertices(Faces& faces, FaceAdjacency& adjacency, std::size_t vertex_count);

}  // namespace illustrate
