// Which corners of the input the corners of faces under repair are.
#pragma once

#include "mesh/faces.h"
#include "mesh/polygon_mesh.h"

namespace illustrate {

// Where the corners of a face stand in the face that it comes from. numbers: what the vertices of
// the input were welded to. Both must outlive it.
class SourceCorners {
 public:
  SourceCorners(const PolygonMesh& mesh, const std::vector<int>& numbers)
      : mesh_(mesh), numbers_(numbers), offsets_{0} {
    for (const int size : mesh.face_sizes) offsets_.push_back(offsets_.back() + size);
  }

  // The corner of an input face at a vertex of `numbers`, nearest to where the last one was found:
  // faces read their corners in order, forward or backward.
  int find(int source_face, int vertex) {
    const int first = offsets_[source_face], size = offsets_[source_face + 1] - first;
    last_ %= size;
    for (int step = 0; step <= size / 2; ++step) {
      for (const int k : {(last_ + step) % size, (last_ + size - step) % size}) {
        if (numbers_[mesh_.corner_vertices[first + k]] != vertex) continue;
        last_ = k;
        return first + k;
      }
    }
    return none;
  }

 private:
  const PolygonMesh& mesh_;
  const std::vector<int>& numbers_;
  std::vector<int> offsets_;
  int last_ = 0;
};

// The unit normal that the input gives to one of its corners; zero where it gives none, and for no
// corner.
inline Vec3 given_normal(const PolygonMesh& mesh, int corner) {
  if (mesh.corner_normals.empty() || corner == none) return Vec3::Zero();
  const Vec3& normal = mesh.corner_normals[idx(corner)];
  return normal.allFinite() ? Vec3(normal.stableNormalized()) : Vec3(Vec3::Zero());
}

}  // namespace illustrate
