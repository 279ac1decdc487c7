// Where silhouette chains pass through self-intersections, and how quantitative invisibility
// changes there.
#pragma once

#include "contour/exact/exact_silhouettes.h"
#include "contour/intersection/intersections.h"
#include "contour/network/surface_ways.h"
#include "view/camera.h"

namespace illustrate {

// A chain on one of the two sheets of an intersection curve passes through the other one. The chain
// goes behind that sheet (chain_change +1) or comes out in front of it (-1). The curve changes from
// the nearer of the two strands of surface that meet at the contour to the farther one
// (curve_change +1), or back.
struct Meeting {
  int chain, chain_segment;
  double chain_fraction;
  int curve, curve_segment;
  double curve_fraction;
  Vec3 position;
  int chain_change, curve_change;
};

// All of them, by intersection curve and its segment. Signs do not come from the triangles at the
// place, whose facing says little next to a contour. They are told from whole curves: along an
// intersection curve each of its sheets turns from front to back at its meetings with that sheet's
// contours and nowhere else; along a chain the nearer strand is another one behind each cusp, and
// behind pinch points.
std::vector<Meeting> find_meetings(const Surface& surface, const Silhouettes& silhouettes,
                                   const PiecesByTriangle& pieces,
                                   const IntersectionCurves& intersections, const Camera& camera);

}  // namespace illustrate
