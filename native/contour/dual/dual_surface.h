// The dual surface of a scene in octrees: the few triangles and edges that can carry the
// silhouettes of a view, without a look at the others (paper section 4.3).
#pragma once

#include "contour/dual/dual_tree.h"
#include "contour/shape/feature_edges.h"
#include "core/progress.h"
#include "view/camera.h"

namespace illustrate {

// Each object has octrees of its own, in a frame of its own (the centre and half the diagonal of
// its box), so that neither far objects nor a great distance from the world's origin cost accuracy.
// The items of a smooth object are its triangles, with the duals of their vertices, turned where a
// corner sees its vertex from the other sheet; those of a polygon object the edges between two
// faces, with the duals of the faces' planes.
class DualSurface {
 public:
  // The same for any number of threads (0: all cores). Throws Cancelled through `progress`.
  explicit DualSurface(const Surface& surface, int threads = 0, const Progress& progress = {});

  // Everything that carries a silhouette by the rules of `ContourFunctions` (triangles of smooth
  // objects) and `is_front_face` (edges of polygon objects, from the triangle of the lower number),
  // and little else; ascending, each once.
  std::vector<int> triangles(const Camera& camera) const;
  std::vector<EdgeSide> edges(const Camera& camera) const;

  // How many triangles and edges every view has to look at, since no face of the hypercube holds
  // them.
  std::size_t always_count() const;

 private:
  enum class Sort : std::uint8_t { smooth, faceted };
  struct Part {
    Vec3 origin;
    double unit;
    Sort sort;
    DualTree tree;  // of triangles t, or of edges 3 t + corner
  };
  // Of the parts of a sort, the items that their trees find.
  std::vector<int> find(const Camera& camera, Sort sort) const;

  std::vector<Part> parts_;
  std::size_t triangles_ = 0;  // of the surface
};

}  // namespace illustrate
