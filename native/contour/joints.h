// Where curves of a network meet on the surface: the nodes, and the places on feature edges, chains
// and intersection curves that have to be cut there.
#pragma once

#include "contour/contour_functions.h"
#include "contour/curvature_curves.h"
#include "contour/curve_network.h"
#include "contour/exact_silhouettes.h"
#include "contour/feature_edges.h"
#include "contour/intersections.h"

namespace illustrate {

// A cut at `fraction` of a feature edge, from the first corner of its first side; `side` is the one
// whose curve makes it, empty where the curve is one of curvature and says nothing of the side.
struct EdgeCut {
  int feature;
  double fraction;
  int node;
  EdgeSide side;
};

// A cut of a polyline behind its point `segment`, at `fraction` of the way to the next one.
struct CurveCut {
  int curve;
  int segment;
  double fraction;
  int node;
};

struct Joints {
  std::vector<NetworkNode> nodes;
  std::vector<EdgeCut> edges;           // sorted by feature, fraction
  std::vector<CurveCut> chains;         // sorted by curve, segment, fraction
  std::vector<CurveCut> intersections;  // sorted likewise
  std::vector<CurveCut> lines;          // of curvature curves, sorted likewise
  int first_line_node = 0;              // nodes from here on are only due to curvature curves
};

// Nodes where chains end on or pass over feature edges, where self-intersection curves cross
// feature edges and chains, and at cusps; where curvature curves end or meet any of these.
Joints find_joints(const Surface& surface, const std::vector<FeatureEdge>& features,
                   const Silhouettes& silhouettes, const IntersectionCurves& intersections,
                   const CurvatureCurves& curvature_curves);

}  // namespace illustrate
