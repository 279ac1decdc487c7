// Open edges of a mesh, and which may be sides of one edge: what gaps and junctions are found by.
#pragma once

#include "mesh/faces.h"
#include "mesh/polygon_mesh.h"

namespace illustrate {

struct BorderEdge {
  int half_edge, tail, head;
  Vec3 tail_normal, head_normal;  // unit: as given in the input, else the face's
  bool is_flat;                   // those are the face's own
  // How far away its other side may be: a ten-thousandth of the mesh's diagonal, and half of the
  // height of its face over it (a thin strip is no gap).
  double reach;
};

class BorderEdges {
 public:
  // numbers: what the vertices of the input were welded to.
  BorderEdges(const PolygonMesh& mesh, const Faces& faces, const std::vector<int>& numbers);

  const BorderEdge& operator[](int edge) const { return edges_[idx(edge)]; }
  int size() const { return static_cast<int>(edges_.size()); }

  double widest_reach() const { return widest_; }  // of all edges

  // Whether the faces of two edges are shaded as one surface where they have these normals: flat
  // ones if they turn by less than the crease angle and 30 degrees, others if the normals differ by
  // less than crease_normals_deg.
  bool shaded_alike(const BorderEdge& a, const Vec3& normal_of_a, const BorderEdge& b,
                    const Vec3& normal_of_b) const;

 private:
  std::vector<BorderEdge> edges_;
  double crease_cosine_;
  double widest_ = 0;
};

}  // namespace illustrate
