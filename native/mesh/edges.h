// What edges and vertices of the input carry, on the edges and vertices of the sound mesh.
#pragma once

#include "core/report.h"
#include "mesh/faces.h"
#include "mesh/sanitize.h"

namespace illustrate {

// Fills edge_vertices, edge_sharpness, vertex_sharpness, corner_normals, marked_edges and seams of
// `sound`, whose positions, source_vertices, twins and kept stand. A mesh with normals, or that is
// no cage, is sharp where it is shaded so (mesh/creases.h); else the crease angle alone decides. A
// cage is sharp where its parts touch, too (mesh/held_places.h).
// faces: its faces; is_cut: FaceAdjacency's; numbers: of the vertices as welded. Of several
// sharpnesses on one edge the largest counts. Counts "open_edges", "ignored_creases",
// "ignored_marks", "angle_creases", "normal_creases", "breaks", "lone_bends", "fine_bends", "tips",
// "corners".
void carry_edges(const PolygonMesh& mesh, const Faces& faces,
                 const std::vector<std::uint8_t>& is_cut, const std::vector<int>& numbers,
                 SoundMesh& sound, Counts& report);

}  // namespace illustrate
