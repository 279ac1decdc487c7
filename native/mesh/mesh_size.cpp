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

double diagonal(const Faces& faces, const Points& positions) {
  Spread spread;
  for (int f = 0; f < faces.size(); ++f) {
    const auto face = faces[f];
    for (std::size_t k = 1; k + 1 < face.size(); ++k)
      spread.add(positions[idx(face[0])], positions[idx(face[k])], positions[idx(face[k + 1])]);
  }
  return spread.diagonal();
}

}  // namespace illustrate
