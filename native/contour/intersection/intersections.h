// Curves along which the triangulated surface passes through itself (paper section 4), within one
// mesh and between meshes.
//
// Touching is not crossing: whether triangles cross is decided, exactly, with every vertex moved
// inward, against its normal, by 2^-22 of the farthest distance from the middle (of a sixteenth of
// that from the origin where it is larger; at most 1/400 of the median edge), and the farther (at
// most twice as far) the later its connected part comes; and borders draw back within their sheet.
// So a solid that stands on another, up to the rounding of single precision, a copy at the same
// place as its original, and faces of a solid that are parts of their own have no curve with each
// other. The curves themselves lie on the surface as it is. Pairs of triangles that share a
// vertex are left out, coplanar ones too: a curve that reaches such a pair ends.
#pragma once

#include "contour/shape/feature_edges.h"
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
  Vec3 decided;           // the same edge's and triangle's place once everything is moved inward
  Edge edge{none, none};  // places of its ends
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

// Two triangles of different connected parts in one plane that face the same way; their boxes
// touch.
struct FlushTriangles {
  std::array<int, 2> triangles;
  std::array<int, 2> parts;
};

// A stretch of a crease, in shares of the side's edge from its corner to the next one, that
// lies within faces of other parts: they are in the plane of the side's triangle, on both
// sides of the crease (flush.h).
struct FlushEdge {
  EdgeSide side;
  double from, to;
  int plane;  // a triangle of these faces
};

// Objects that meet, or one with itself.
using ObjectPair = std::array<int, 2>;  // ascending

// What tells surfaces apart that touch, here and where it is decided what hides what.
struct Insets {
  Points moves;            // (vertices) by which each was moved
  std::vector<int> parts;  // (vertices) connected part of each
};

struct IntersectionCurves {
  Ragged<IntersectionPoint> curves;  // closed ones do not repeat their first point
  std::vector<std::uint8_t> closed;  // (curves)
  // (points) the segment from each point to the next of its curve lies in these two triangles, in
  // which a and b of the point that it starts at lie; (none, none) for the last point of an open
  // curve, which lies in those before.
  std::vector<std::array<int, 2>> segment_triangles;
  std::vector<TriplePoint> triple_points;  // triple_points.h
  Insets insets;
  std::vector<FlushTriangles> flush_triangles;  // ascending
  double reach = 0;      // how far apart planes may be that count as one, world units,
  double one_plane = 0;  // and those of sheets that are moved alike, by rounding
  std::vector<FlushEdge> flush_edges;
  std::vector<std::uint8_t> flush_segments;  // (points) flush.h
  std::vector<ObjectPair> left_out;          // too much to follow, ascending
};

// Pairs of triangles that cross: crumpled meshes of tens of thousands of triangles have fewer, fur
// of half a million has more, and all that is made of them grows with them.
constexpr std::int64_t most_crossing_triangles = 500'000;

// Fills what follows from the curves and from their flush triangles: triple points, flush edges and
// segments.
void complete(const Surface& surface, IntersectionCurves& curves, const Progress& progress = {});

// bvh: over the surface's positions and triangles. Open curves first, then closed ones. Whenever
// there are more than `most` pairs of triangles that cross, the objects (or the one object) to
// which most of them belong are left out, until half remain. Adds "intersection_curves",
// "intersections_left_out": pairs of objects; and "intersection_ties": pairs of triangles left out
// because they could not be decided.
IntersectionCurves intersections(const Surface& surface, const Bvh& bvh, Counts& report,
                                 const Progress& progress = {},
                                 std::int64_t most = most_crossing_triangles);

}  // namespace illustrate
