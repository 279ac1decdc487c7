// Vertices pushed to the limit: positions, one-sided normals and line curvature (paper section 3,
// appendix A).
#pragma once

#include "core/progress.h"
#include "surface/limit/ring.h"

namespace illustrate {

// For every sector of a mesh.
struct SectorLimits {
  Points positions;                     // (s) the same bits for all sectors of a place
  Points normals;                       // (s) unit
  Curvature curvature;                  // (s) zero where `needs_jet`
  std::vector<std::uint8_t> needs_jet;  // (s) 1: no closed form
};

SectorLimits limits(const Subdivision& subdivision, const RefinedMesh& mesh, const Sectors& sectors,
                    int level, int threads, const Progress& progress);

// Polygons as they are: positions of the vertices, normals weighted by the angles of the corners.
SectorLimits polygonal_limits(const RefinedMesh& mesh, const Sectors& sectors, int threads);

}  // namespace illustrate
