// Faces of a mesh split once as patches on the arcs of its edges (control/bent_points.h).
//
// Subdivision gives every edge the same parameter. Where long edges meet short ones, at the corner
// of a wall beside its narrow rounding, the limit of a vertex slides towards the long ones, farther
// than the rounding is wide: the rounding is drawn away from the wall, and the wall folds. There
// the surface is made of these patches, quadratic polynomials through the vertices and the points
// on arcs, in the spirit of PN triangles (Vlachos et al. 2001): no vertex slides, and what is level
// is level. They meet without a gap, and as smoothly as arcs that leave a vertex across one normal
// do; not to second order, as limit surfaces do where edges are alike.
#pragma once

#include "control/half_edges.h"

namespace illustrate {

struct ArcFaces {
  Points places;                // (n) of the split mesh
  Points sags;                  // (c) of the middle of each half-edge off its chord
  std::vector<double> weights;  // (n) of the patches in the surface: 0 the limit .. 1 the patches
};

// The patches of the faces of `parent`, each face split: `points` as bent_points has them;
// `weights` (n) of the parent, between its vertices linear.
ArcFaces arc_faces(const HalfEdges& parent, Points points, std::vector<double> weights,
                   Scheme scheme);

// With the derivatives of the patch by uv.
struct ArcPoint {
  Vec3 position, du, dv, duu, duv, dvv;
  double weight;
};

// On the face of the split mesh that has these vertices and starts at corner `first`; uv in the
// square, its corners counter-clockwise from (0, 0), or in the triangle (0, 0), (1, 0), (0, 1).
ArcPoint evaluate(const ArcFaces& arcs, Span<const int> vertices, int first, const Vec2& uv);

}  // namespace illustrate
