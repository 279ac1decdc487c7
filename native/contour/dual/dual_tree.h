// Octrees over pieces of a dual surface, on the faces of the hypercube (paper section 4.3).
//
// The tangent plane at p with normal n is the point N = [n, -(p . n)] of homogeneous 4-space. The
// viewpoint C = (eye, 1), or (direction, 0), lies in that plane where C . N = 0, so the silhouette
// is where the plane C . x = 0 meets the dual surface. Divided by its largest component a dual
// point lies on one of the eight 3D faces of the 4D hypercube, x_i = 1 or x_i = -1, and each face
// has an octree.
//
// Departure from section 4.3: an item (a triangle, an edge) is not put on every face where it has a
// vertex but on the one face to which all of it projects best, from the centre of the hypercube and
// beyond that face's border where it must; the boxes of the nodes fit their items, not the octants,
// so nothing is lost. What spans too much for any face is cut until it fits.
#pragma once

#include <optional>

#include "core/types.h"

namespace illustrate {

// A piece of the dual surface on one face: component i is 1 on face 2 i, -1 on face 2 i + 1; the
// box bounds the three other components, in their order.
struct DualItem {
  int id = none;
  int face = none;
  std::array<float, 3> low{};
  std::array<float, 3> high{};
};

// The item with the corners given (an edge has two of them the same). Nothing where no face holds
// all of it, or a corner is not finite.
std::optional<DualItem> dual_item(int id, const std::array<Vec4, 3>& corners);

class DualTree {
 public:
  // An id may have several items. `always`: ids that every view has to look at. The same tree for
  // any number of threads.
  DualTree(const std::vector<DualItem>& items, std::vector<int> always, int threads);

  // Adds the ids of all items that have corners on both sides of the plane viewpoint . x = 0 or
  // within `margin` of it (before any division), and some more nearby; repeated where several items
  // share an id; in no particular but always the same order.
  void find(const Vec4& viewpoint, double margin, std::vector<int>& found) const;

  std::size_t always_count() const { return always_.size(); }

 private:
  // A box in steps of its face's grid, rounded outward: a quarter of a line of the processor's
  // cache, since a view looks at many of them, far apart. Children stand side by side.
  struct Node {
    std::array<std::uint16_t, 6> box{};      // low, high
    std::uint32_t is_leaf : 1, is_last : 1;  // of its parent's children
    std::uint32_t first : 30;                // child, or item of a leaf
  };
  // Step s of a face lies at origin + s * step.
  struct Grid {
    std::array<double, 3> origin{}, step{};
  };
  class Builder;
  class Plane;

  void find_leaves(int root, const Plane& plane, std::vector<int>& leaves) const;

  std::vector<Node> nodes_;
  std::array<int, 8> roots_{};  // of each face, none where it has no items
  std::array<Grid, 8> grids_;
  std::vector<int> ids_;  // of the items; the last one of a leaf as its complement
  std::vector<int> always_;
};

}  // namespace illustrate
