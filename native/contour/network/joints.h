// Where curves of a network meet on the surface: the nodes, and the places on feature edges, chains
// and intersection curves that have to be cut there.
#pragma once

#include <optional>

#include "contour/contour_functions.h"
#include "contour/exact/exact_silhouettes.h"
#include "contour/intersection/intersections.h"
#include "contour/network/curve_network.h"
#include "contour/shape/feature_edges.h"
#include "contour/zero_curves.h"

namespace illustrate {

// A cut at `fraction` of a feature edge, from the first corner of its first side; `side` is the one
// whose curve makes it, empty for free lines and where a crease begins to be flush, which say
// nothing of the side.
struct EdgeCut {
  int feature;
  double fraction;
  int node;
  EdgeSide side;
};

// A cut of a polyline behind its point `segment`, at `fraction` of the way to the next one, where
// quantitative invisibility changes by `jump`, if that is known.
struct CurveCut {
  int curve;
  int segment;
  double fraction;
  int node;
  std::optional<int> jump;
};

// A stretch of a feature edge, in shares from the first corner of its first side, that lies within
// faces of other parts (flush.h), which are seen from their front.
struct FlushStretch {
  int feature;
  double from, to;
};

struct Joints {
  std::vector<NetworkNode> nodes;
  std::vector<EdgeCut> edges;           // sorted by feature, fraction
  std::vector<FlushStretch> flush;      // sorted by feature, share; those of a feature are apart
  std::vector<CurveCut> chains;         // sorted by curve, segment, fraction
  std::vector<CurveCut> intersections;  // sorted likewise
  std::vector<CurveCut> lines;          // of free lines, sorted likewise
  int first_line_node = 0;              // nodes from here on are only due to free lines
};

// Where a contour passes through another sheet it goes behind it (+1) or comes out in front of it
// (-1). There a self-intersection curve changes from the nearer of the two strands of surface that
// meet at the contour to the farther one (+1), or back.
//
// Nodes where chains end on or pass over feature edges, where self-intersection curves cross
// feature edges and chains, and at cusps; where either begins or ends to be flush; where free lines
// end or meet any of these.
Joints find_joints(const Surface& surface, const std::vector<FeatureEdge>& features,
                   const Silhouettes& silhouettes, const IntersectionCurves& intersections,
                   const FreeLines& free_lines, const Camera& camera);

}  // namespace illustrate
