// The network's strands in the image, exactly: points rounded to the integer grid on which
// crossings are decided.
#pragma once

#include "contour/network/curve_network.h"
#include "surface/surface.h"
#include "view/camera.h"

namespace illustrate {

// Units of 2^-16 px, y up. Points that stand for the same node have the same id.
struct GridPoint {
  std::int64_t x;
  std::int64_t y;
  int id;
};

// An image coordinate, kept to where whole numbers of grid units can be multiplied; 0 where it is
// not finite.
double within_reach(double px);

// Aligned with network.points.values.
struct ImageStrands {
  std::vector<Vec2> image;  // px
  std::vector<double> depth;
  std::vector<GridPoint> places;  // the image, rounded
  // What crossings are decided on: towards the points `decided`, where they are given.
  std::vector<GridPoint> grid;
  std::vector<double> decided_depth;
  Points decided;         // empty: the network's own points
  double touching = 0;    // depths that differ by no more are of curves that touch,
  double same_depth = 0;  // and by no more than this of curves at one place
  bool perspective = false;
};

// `decided`: where the points are taken to be for decisions, aligned with them too; empty:
// where they are. In near views, where that would be farther in the image than is told apart, a
// share of the way there.
ImageStrands project_strands(const CurveNetwork& network, const Camera& camera,
                             Points decided = {});

// The points of a network on the surface whose vertices are moved by `insets` (IntersectionCurves).
// Surfaces that touch are then apart: a wall that stands on a floor is above it, and of two flush
// faces the earlier part's is in front, all along and at every crossing. Strands that share a node
// share its place. Empty where there are no insets.
Points inset_points(const CurveNetwork& network, const Surface& surface, const Points& insets);

using ImageSegment = std::array<Vec2, 2>;  // px

struct StrandSegment {
  int strand;
  int segment;  // of the strand
  int a;        // its two points among all points
  int b;
};

// Strand by strand, each in order; a closed one's last segment leads back to its start.
std::vector<StrandSegment> all_segments(const CurveNetwork& network);

// From a share of a segment's image to the share of the segment itself: depths at its two ends.
double world_fraction(double image_fraction, double depth_a, double depth_b, bool perspective);

}  // namespace illustrate
