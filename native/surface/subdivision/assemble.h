// Triangles and vertices of one refined mesh, appended to the surface of all.
#pragma once

#include "surface/limit/limit.h"

namespace illustrate {

struct RefinedObject {
  const SoundMesh& base;
  const RefinedMesh& mesh;
  const std::vector<int>& corner_sectors;  // of `mesh`, into `limits`
  SectorLimits limits;
  // (faces of `base`) 1: triangles of the face are on no patch; empty: none are.
  std::vector<std::uint8_t> without_patch;
  // (faces of `base`) 1: the surface is not the limit there, its vertices have no place on it;
  // empty: it is everywhere.
  std::vector<std::uint8_t> off_limit;
  int object = 0;
  int first_ptex_face = 0;
};

// Faces that are holes or belong to the sheet of a double cover that is not kept are left out. Of
// two vertices that lie on each other on both sheets, the one of the lower sector stays. Adds the
// vertices that need a jet to `needs_jet`. threads: 0 = all cores.
void assemble(RefinedObject object, int threads, Surface& surface, std::vector<int>& needs_jet);

}  // namespace illustrate
