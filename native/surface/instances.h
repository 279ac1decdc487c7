// Objects that have their surface in common: it is made once, and placed for each of them.
#pragma once

#include "core/similarity.h"
#include "surface/surface.h"

namespace illustrate {

// Which of the surfaces that were made, the originals, each object has, and where.
struct Instances {
  std::vector<int> originals;          // (objects)
  std::vector<Similarity> placements;  // (objects) from the original to the object
  // Every object is its own original, where it is: nothing has to be placed.
  bool are_trivial = true;
};

// The surface of all objects from that of the originals, in which these are the objects. Vertices,
// triangles and ptex faces are those of one object after another.
Surface placed(const Surface& originals, const Instances& instances);

// Curvature of the originals' vertices as that of all objects' vertices: it falls as the scale
// grows.
Curvature placed(const Curvature& curvature, const Surface& originals, const Instances& instances);

// (objects + 1) where the vertices, or the triangles, of each object begin.
std::vector<int> first_vertices(const Surface& surface);
std::vector<int> first_triangles(const Surface& surface);

}  // namespace illustrate
