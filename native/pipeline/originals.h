// Which meshes share one surface: instances of one original (mesh/instance.h).
#pragma once

#include "pipeline/prepare.h"

namespace illustrate {

struct OriginalMeshes {
  std::vector<const PolygonMesh*> meshes;  // each once; owned by the meshes asked for
  Instances instances;
};
OriginalMeshes find_originals(const std::vector<MeshPointer>& meshes);

// Tells each original where it is drawn, and how long its edges may be, in world units, where it is
// drawn largest, so that they are short enough for every object.
void set_placements(const std::vector<MeshPointer>& meshes, const Instances& instances,
                    std::vector<SoundMesh>& originals);

}  // namespace illustrate
