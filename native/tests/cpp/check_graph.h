// The checker that every labelled graph must pass.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>

#include "visibility/labelled_graph.h"

namespace illustrate {

inline void check_crossing(const LabelledGraph& graph, const GraphNode& node) {
  const auto layers = [&](std::size_t i) { return graph.arcs[idx(node.arcs[i])].invisibility; };
  const GraphArc& front = graph.arcs[idx(node.arcs[0])];
  EXPECT_EQ(layers(0), layers(1)) << "the front curve keeps its label";
  EXPECT_EQ(std::abs(layers(3) - layers(2)), std::abs(front.left_layers - front.right_layers));
  EXPECT_GE(std::min(layers(2), layers(3)), layers(0)) << "behind is never less hidden";
}

// Arcs fit their nodes, labels are not negative, crossings and cusps obey their rules.
inline void check_graph(const LabelledGraph& graph) {
  ASSERT_EQ(graph.arcs.size(), graph.points.size());
  ASSERT_EQ(graph.arcs.size(), graph.image.size());
  std::vector<int> degree(graph.nodes.size(), 0);
  for (std::size_t a = 0; a < graph.arcs.size(); ++a) {
    const GraphArc& arc = graph.arcs[a];
    ASSERT_GE(graph.points[a].size(), 2U);
    ASSERT_EQ(graph.points[a].size(), graph.image[a].size());
    ASSERT_EQ(arc.start_node == none, arc.end_node == none);
    EXPECT_GE(arc.invisibility, 0);
    if (arc.start_node == none) continue;
    ++degree[idx(arc.start_node)];
    ++degree[idx(arc.end_node)];
    EXPECT_LT((graph.image[a].front() - graph.nodes[idx(arc.start_node)].image).norm(), 1e-3);
    EXPECT_LT((graph.image[a].back() - graph.nodes[idx(arc.end_node)].image).norm(), 1e-3);
  }
  for (std::size_t n = 0; n < graph.nodes.size(); ++n) {
    const GraphNode& node = graph.nodes[n];
    if (node.kind == NodeKind::crossing) {
      EXPECT_EQ(degree[n], 4);
      check_crossing(graph, node);
    } else if (node.kind == NodeKind::cusp) {
      EXPECT_EQ(degree[n], 2);
      EXPECT_EQ(graph.arcs[idx(node.arcs[1])].invisibility,
                graph.arcs[idx(node.arcs[0])].invisibility + 1);
    } else {
      EXPECT_GE(degree[n], node.kind == NodeKind::joint ? 2 : 1);
    }
  }
}

}  // namespace illustrate
