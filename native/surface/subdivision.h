// A mesh refined uniformly by OpenSubdiv, level by level, and its limit surface anywhere (paper
// section 3).
#pragma once

#include <memory>
#include <optional>

#include "core/progress.h"
#include "surface/refined_mesh.h"

namespace illustrate {

// The limit surface and its derivatives in the coordinates of a ptex face.
struct LimitPoint {
  Vec3 position, du, dv, duu, duv, dvv;
};

class Subdivision {
 public:
  // scheme: catmull_clark, or loop for a mesh of triangles. Reports progress from level to level.
  Subdivision(const SoundMesh& mesh, Scheme scheme, int levels, const Progress& progress = {});
  ~Subdivision();

  // False where OpenSubdiv refuses the mesh: a vertex or a face with more than 65535 edges.
  bool is_valid() const;

  // Level 0 is the mesh itself.
  RefinedMesh level(int level) const;

  // The vertex that `vertex` of level `from` has become on level `to`.
  int descendant(int vertex, int from, int to) const;

  // The corner on level 1 of a corner of level 0 (which `parent` is).
  int child_corner(const RefinedMesh& parent, int corner) const;

  // First ptex face of each base face, and the number of all.
  const std::vector<int>& ptex_faces() const;

  // Nothing where the limit surface is not defined.
  std::optional<LimitPoint> evaluate(const BasePlace& place) const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace illustrate
