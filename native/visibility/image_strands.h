// The network's strands in the image, exactly: points rounded to the integer grid on which
// crossings are decided.
#pragma once

#include "contour/curve_network.h"
#include "view/camera.h"

namespace illustrate {

// Units of 2^-16 px, y up. Points that stand for the same node have the same id.
struct GridPoint {
  std::int64_t x;
  std::int64_t y;
  int id;
};

// Aligned with network.points.values.
struct ImageStrands {
  std::vector<Vec2> image;  // px
  std::vector<double> depth;
  std::vector<GridPoint> grid;
  bool perspective = false;
};

ImageStrands project_strands(const CurveNetwork& network, const Camera& camera);

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
