// The meshes of a scene, each once however many objects are placed copies of it (mesh/instance.h),
// and their surface. What has not changed since the last frame, or has moved as a rigid body, is
// not made again.
#pragma once

#include <memory>

#include "pipeline/last_frame.h"
#include "surface/instances.h"
#include "surface/refine.h"

namespace illustrate {

using MeshPointer = std::shared_ptr<const PolygonMesh>;

std::vector<std::string> names_of(const std::vector<MeshPointer>& meshes);

struct Original {
  MeshPointer given;                   // in this frame
  MeshPointer made_from;               // in the frame in which its surface was made
  Similarity motion;                   // rigid, from there to here
  std::vector<Similarity> placements;  // where it is drawn
  // That its edges may have where it is drawn largest, world units.
  std::optional<double> edge_length;
  Counts mended;
  LevelWish wish;
  int chosen_level = 0, level = 0;  // within the budget, and the one that was made
  int last = none;                  // of the last frame's originals, the one that it may be
  bool is_kept = false;             // it is that one, moved

  double largest_scale() const;
};

struct Originals {
  std::vector<MeshPointer> objects;
  std::vector<Original> each;
  Instances instances;
  std::vector<int> last_objects;           // (objects) which of the last frame it may be, or none
  std::shared_ptr<const Surface> surface;  // whose objects the originals are
  EarlierObjects earlier;                  // (originals) of the last frame; empty: there is none

  void report(Counts& counts) const;  // of all objects' repairs, and of the originals' surface
};

// Objects are found again in the last frame by their names (surface/same_objects.h).
// Originals are kept where they have the same form and ask for the same edges, and no level depends
// on the size of the scene. last: null where there is none.
Originals find_originals(const std::vector<MeshPointer>& meshes, const SurfaceOptions& options,
                         const Originals* last);

// (originals) those that are not kept.
std::vector<SoundMesh> sanitize_fresh(Originals& originals, const Progress& progress);

// Makes the surface. What would have another level than in the last frame is not kept after all.
void refine_fresh(Originals& originals, std::vector<SoundMesh> sound, const SurfaceOptions& options,
                  const Originals* last, const Progress& progress);

}  // namespace illustrate
