// The labelled graph: every curve of a view cut into arcs of constant quantitative invisibility.
#pragma once

#include <algorithm>

#include "contour/network/curve_network.h"
#include "core/report.h"

namespace illustrate {

struct GraphNode {
  NodeKind kind;
  Vec2 image;
  // crossing: front in, front out, back in, back out ("in" arcs end here, "out" arcs start); cusp:
  // near, far, none, none; else none: arc_nodes decides.
  std::array<int, 4> arcs{none, none, none, none};
};

struct GraphArc {
  Kind kind;
  int object;
  int strand;             // of the network it comes from
  int start_node = none;  // both none: a closed loop without nodes
  int end_node = none;
  int invisibility = 0;  // layers of surface in front
  int left_layers = 0;   // as in Strand
  int right_layers = 0;
  bool is_flush = false;  // as in Strand
};

// Layers that hide an arc as a line: those in front and, where it is flush, the face that it lies
// within, whichever of the two comes first. Whoever asks whether an arc is seen asks this.
inline int layers_over(const GraphArc& arc) {
  return arc.is_flush ? std::max(arc.invisibility, 1) : arc.invisibility;
}

// points[i] and image[i] run along arcs[i]; closed loops do not repeat their first point.
struct LabelledGraph {
  std::vector<GraphNode> nodes;
  std::vector<GraphArc> arcs;
  Ragged<CurvePoint> points;
  Ragged<Vec2> image;
  double repair_max_px = 0;  // the farthest that a repair moved a point
  double unit_px = 1;        // pixels of the unit in which tolerances of its image are measured
};

}  // namespace illustrate
