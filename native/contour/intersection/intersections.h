// Curves along which the triangulated surface passes through itself (paper section 4), within one
// mesh and between meshes.
//
// Touching is not crossing: whether triangles cross is decided, exactly, with every vertex moved
// inward, against its normal, by 2^-22 of the farthest distance from the middle (of a sixteenth of
// that from the origin where it is larger; at most 1/400 of the median edge), and the farther (at
// most twice as far) the later its connected part comes. So a solid that stands on another, up to
// the rounding of single precision, and a copy at the same place as its original, have no curve
// with it. The curves themselves lie on the surface as it is. Pairs of triangles that share a
// vertex are left out, coplanar ones too: a curve that reaches such a pair ends.
#pragma once

#include "core/progress.h"
#include "core/ragged.h"
#include "core/report.h"
#include "mesh/bvh.h"
#include "surface/surface.h"

namespace illustrate {

// Where an edge of one sheet pierces a triangle of the other; the same place on both sheets.
struct IntersectionPoint {
  Vec3 position;
  SurfacePoint a, b;
  Vec3 decided;  // the same edge's and triangle's place once everything is moved inward
};

// A curve's segment that passes, at `fraction` of its way, through a triangle of the third sheet,
// along its normal or against it.
struct Passage {
  int curve;
  int segment;
  double fraction;
  int through;
  bool along_normal;
};

struct TriplePoint {
  Vec3 position;
  std::vector<Passage> passages;  // three, or two where the third curve was not found
};

// Objects that meet, or one with itself.
using ObjectPair = std::array<int, 2>;  // ascending

struct IntersectionCurves {
  Ragged<IntersectionPoint> curves;  // closed ones do not repeat their first point
  std::vector<std::uint8_t> closed;  // (curves)
  // (points) the segment from each point to the next of its curve lies in these two triangles, in
  // which a and b of the point that it starts at lie; (none, none) for the last point of an open
  // curve, which lies in those before.
  std::vector<std::array<int, 2>> segment_triangles;
  std::vector<TriplePoint> triple_points;  // triple_points.h
  Points insets;  // (vertices) by which each was moved inward; what hides what is decided there too
  std::vector<ObjectPair> left_out;  // too much to follow, ascending
};

// Pairs of triangles that cross: crumpled meshes of tens of thousands of triangles have fewer, fur
// of half a million has more, and all that is made of them grows with them.
constexpr std::int64_t most_crossing_triangles = 500'000;

// bvh: over the surface's positions and triangles. Open curves first, then closed ones. Whenever
// there are more than `most` pairs of triangles that cross, the objects (or the one object) to
// which most of them belong are left out, until half remain. Adds "intersection_curves",
// "intersections_left_out": pairs of objects; and "intersection_ties": pairs of triangles left out
// because they could not be decided.
IntersectionCurves intersections(const Surface& surface, const Bvh& bvh, Counts& report,
                                 const Progress& progress = {},
                                 std::int64_t most = most_crossing_triangles);

}  // namespace illustrate
