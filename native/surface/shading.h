// Normals that are not the limit's own: of polygons, of degenerate places, across seams.
#pragma once

#include "surface/limit/limit.h"

namespace illustrate {

// Normals of all sectors from the polygons at their corners, weighted by angle.
void polygon_normals(const RefinedMesh& mesh, const Sectors& sectors, int threads, Points& normals);

// Gives normals that are zero those of the refined faces around, else of the vertices around; then
// sides that meet at a seam, where they turn by less than 60 degrees, the mean of theirs, so that
// shading does not crack.
void mend_normals(const RefinedMesh& mesh, const Sectors& sectors, int threads,
                  SectorLimits& limits);

// World units, over the edges of all faces.
double mean_edge(const RefinedMesh& mesh);

// The place that all sectors of a vertex, and all copies of a vertex split along a seam, share.
int place_of(const RefinedMesh& mesh, int vertex);

// Gives all sectors of a place the same position: that of a sheet that goes on there, else of the
// first. A fin that a seam joins to a sheet so stays on it, though their limits differ.
void share_positions(const RefinedMesh& mesh, const Sectors& sectors, Points& positions);

}  // namespace illustrate
