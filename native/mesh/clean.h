// What is no face goes: the first repairs of stage `mesh`.
#pragma once

#include "core/disjoint_sets.h"
#include "core/report.h"
#include "mesh/faces.h"
#include "mesh/polygon_mesh.h"

namespace illustrate {

// OpenSubdiv counts the corners of a face and the faces of a vertex with 16 bits.
constexpr int max_valence = 65535;

// Coordinates beyond this magnitude count as not finite: a product of two of them overflows.
constexpr double max_coordinate = 1e150;

// The faces with at least three corners, all finite and different; faces that come to a vertex
// twice in parts (split_polygon). Counts "nan_vertices", "nan_faces", "repeated_corners",
// "split_faces", "degenerate_faces", "huge_faces", "duplicate_faces", "isolated_vertices". A face
// counts as dropped where nothing of it is left.
Faces clean_faces(const PolygonMesh& mesh, Counts& report);

// Gives vertices that are one in `sets` the same number, the lowest, and numbers of the input with
// them; cleans the faces again. Counts "welded_vertices" besides.
void weld(DisjointSets& sets, const Points& positions, Faces& faces, std::vector<int>& numbers,
          Counts& report);

// Welds vertices of open edges that lie at the same position, to within rounding. Returns the new
// number of each vertex.
std::vector<int> weld_open_edges(Faces& faces, const Points& positions, Counts& report);

// Makes one vertex of the two ends of an edge that lie at the same position, to within rounding: a
// cap shrunk to a point becomes the tip that it is, where its faces, each without area, would cross
// each other in the last bits. Not for a cage, whose limit knows such vertices apart.
void collapse_edges(const Points& positions, Faces& faces, std::vector<int>& numbers,
                    Counts& report);

}  // namespace illustrate
