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

// (objects + 1) where the vertices, or the triangles, of each object begin.
std::vector<int> first_vertices(const Surface& surface);
std::vector<int> first_triangles(const Surface& surface);

// Calls visit(source, begin, end) for each object of such a surface, with the numbers that its
// vertices (`first`: first_vertices) or triangles (first_triangles) have where it is taken from.
template <class First, class Visit>
void visit_sources(const std::vector<const Surface*>& surfaces, const ObjectSources& sources,
                   const First& first, const Visit& visit) {
  std::vector<std::vector<int>> begins;
  for (const Surface* surface : surfaces) begins.push_back(first(*surface));
  for (const ObjectSource& source : sources) {
    const int* const begin = &begins[idx(source.surface)][idx(source.object)];
    visit(source, begin[0], begin[1]);
  }
}

// Of the vertices of such a surface, from that of each surface: it falls as the scale grows.
Curvature joined(const std::vector<const Curvature*>& curvatures,
                 const std::vector<const Surface*>& surfaces, const ObjectSources& sources);

}  // namespace illustrate
