// Edges of a sound mesh: which polygon corners they join and of what kind they are.
#pragma once

#include "mesh/edge_table.h"
#include "mesh/sanitize.h"
#include "surface/surface.h"

namespace illustrate {

// Kinds of edges known from the mesh itself, strongest first: open (boundary or seam), crease,
// mark, material.
class BaseEdgeKinds {
 public:
  explicit BaseEdgeKinds(const SoundMesh& mesh);

  // face_a, face_b: faces on both sides; face_b is `none` at an open edge.
  EdgeKind kind(int vertex_a, int vertex_b, int face_a, int face_b) const;

 private:
  const SoundMesh& mesh_;
  EdgeTable creases_, marks_, seams_;
};

// Whether some part of the mesh is on both sheets.
bool has_double_cover(const SoundMesh& mesh);

}  // namespace illustrate
