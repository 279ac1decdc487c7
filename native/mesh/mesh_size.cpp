#include "mesh/mesh_size.h"

namespace illustrate {

void add_faces(const SoundMesh& mesh, const Similarity& placement, Spread& spread) {
  const auto corner = [&](int c) {
    return placement.point(mesh.positions[idx(mesh.corner_vertices[idx(c)])]);
  };
  int first = 0;
  for (const int size : mesh.face_sizes) {
    for (int k = 1; k + 1 < size; ++k)
      spread.add(corner(first), corner(first + k), corner(first + k + 1));
    first += size;
  }
}

double diagonal(const SoundMesh& mesh) {
  Spread spread;
  add_faces(mesh, {}, spread);
  return spread.diagonal();
}

}  // namespace illustrate
