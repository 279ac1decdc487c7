// A surface put together of objects of other surfaces, each moved: of copies of an original
// (surface/instances.h), of what has changed between two frames and what has not.
#pragma once

#include "core/similarity.h"
#include "surface/surface.h"

namespace illustrate {

// Where an object is taken from: one of several surfaces, and the object there.
struct ObjectSource {
  int surface = 0;
  int object = none;
  Similarity place;  // from there to here
};
using ObjectSources = std::vector<ObjectSource>;  // (objects)

// Some objects of one surface, as they are.
ObjectSources objects_as_they_are(const std::vector<int>& objects);

// Vertices, triangles and ptex faces are those of one object after another.
Surface joined(const std::vector<const Surface*>& surfaces, const ObjectSources& sources);

// Of the vertices of such a surface, from that of each surface: it falls as the scale grows.
Curvature joined(const std::vector<const Curvature*>& curvatures,
                 const std::vector<const Surface*>& surfaces, const ObjectSources& sources);

// (objects + 1) where the vertices, or the triangles, of each object begin.
std::vector<int> first_vertices(const Surface& surface);
std::vector<int> first_triangles(const Surface& surface);

}  // namespace illustrate
