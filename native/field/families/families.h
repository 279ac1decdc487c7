// Which of the two families of the cross stays where there is room for one (paper section 6.5), as
// a property of the surface.
//
// Labels of least cost: strokes show a form best that run round it, and each vertex whose other
// family bends more costs its area times the difference of the bends, in radians a length; seams,
// where the family changes, cost their length. An odd number of seams ends at each singularity of
// the field; creases, whose sides have vertices of their own, are seams that cost nothing. What
// bends alike in both directions goes with its connected piece's longer way, then with the
// direction nearer to the upright.
//
// Departure from section 6.5, where hatches are deleted view by view: what is kept then changes
// from view to view.
#pragma once

#include "field/cross_field.h"

namespace illustrate {

// (n) 1: the family along `CrossField::directions` stays; -1: the one across it.
using Families = std::vector<std::int8_t>;

// The direction of a cross beside `CrossField::directions`.
inline Vec3 across(const Surface& surface, const CrossField& field, std::size_t vertex) {
  return surface.normals[vertex].cross(field.directions[vertex]);
}

// Of the last frame: families of objects that are the same (surface/same_objects.h) stay and only
// seams move a little. All null where there was none.
struct LastFamilies {
  const Surface* surface = nullptr;
  const CrossField* field = nullptr;
  const Families* families = nullptr;
  std::vector<int> objects = {};  // (objects) which of that surface each may be, or none
};

// Throws Cancelled through `progress`. Each connected piece (creases part pieces) is labelled as if
// it were alone, several at a time (threads: 0 for all cores). `curvature`: for hatching
// (surface/jets/curvature.h).
Families find_families(const Surface& surface, const Curvature& curvature, const CrossField& field,
                       const LastFamilies& last = {}, int threads = 0,
                       const Progress& progress = {});

// How clearly a tangent at a point runs with the family that stays, in [-1, 1]: 1 along it, -1
// across it, 0 at a seam.
double kept_share(const Surface& surface, const CrossField& field, const Families& families,
                  const SurfacePoint& at, const Vec3& tangent);

}  // namespace illustrate
