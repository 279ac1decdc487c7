// A mesh refined uniformly by OpenSubdiv, level by level (paper section 3).
#pragma once

#include <memory>

#include "core/progress.h"
#include "surface/subdivision/refined_mesh.h"

namespace illustrate {

class Subdivision {
 public:
  // scheme: catmull_clark, or loop for a mesh of triangles. threads: 0 = all cores. Reports
  // progress from level to level.
  Subdivision(const SoundMesh& mesh, Scheme scheme, int levels, int threads,
              const Progress& progress = {});
  ~Subdivision();

  // False where OpenSubdiv refuses the mesh: a vertex or a face with more than 65535 edges.
  bool is_valid() const;

  // Level 0 is the mesh itself.
  const RefinedMesh& level(int level) const;

  // The vertex that `vertex` of level `from` has become on level `to`.
  int descendant(int vertex, int from, int to) const;

  const SoundMesh& base() const;
  Scheme scheme() const;
  int ptex_faces() const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace illustrate
