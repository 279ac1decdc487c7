// Which arcs of the labelled graph are drawn, and how they run on through its nodes (paper section
// 4.4, "segments").
#pragma once

#include "stroke/make_strokes.h"

namespace illustrate {

// One end of an arc.
struct ArcEnd {
  int arc = none;
  bool at_start = true;
};

// Arcs one after another; reversed[i]: arcs[i] is run from its end to its start.
struct Chain {
  std::vector<int> arcs;
  std::vector<std::uint8_t> reversed;
  bool closed = false;
  int start_node = none;  // both none where closed
  int end_node = none;
};

// In pixels, round the whole loop where it is closed.
double image_length(const LabelledGraph& graph, int arc);

// (arcs) 1 where the arc is drawn: its kind, object and number of layers are asked for. Seams never
// are.
std::vector<std::uint8_t> drawn_arcs(const LabelledGraph& graph,
                                     const std::vector<std::uint8_t>& undrawn,
                                     const StrokeOptions& options);

// (nodes) the ends of the drawn arcs at each node, in the order of the arcs.
Ragged<ArcEnd> ends_at_nodes(const LabelledGraph& graph, const std::vector<std::uint8_t>& drawn);

// Each drawn arc in one chain. Two ends at a node are one line where kind, object and layers agree:
// at a crossing front in and front out, back in and back out; elsewhere the pairs with the smallest
// turn. A tail, the last less than `speck_px` of a line before a free end, is a chain of its own
// where another line starts that the rest of its line can go on in: so an outline runs on past a
// swallowtail. Free ends less than a unit of the graph apart that face each other are joined.
std::vector<Chain> chain_arcs(const LabelledGraph& graph, const std::vector<std::uint8_t>& drawn,
                              const Ragged<ArcEnd>& ends, double speck_px);

}  // namespace illustrate
