// How far folds run on to where they end.
#include "tone/fold_extents.h"

#include <gtest/gtest.h>

#include "tests/cpp/cameras.h"

namespace illustrate {
namespace {

// An arc between two nodes, straight in the image, or a closed square without nodes.
void add_fold(LabelledGraph& graph, int start, int end, const std::vector<Vec2>& image) {
  GraphArc arc{Kind::silhouette, 0, 0, start, end};
  arc.right_layers = 2;
  graph.arcs.push_back(arc);
  for (const Vec2& p : image) graph.image.push(p);
  graph.image.close_list();
}

GraphNode node_at(const Vec2& image) { return {NodeKind::cusp, image}; }

FoldExtents extents_of(const LabelledGraph& graph) {
  return fold_extents(graph, cameras::orthographic(Vec3::UnitZ(), 1, 200));
}

TEST(FoldExtents, RunToTheNearestEndInTheFrame) {
  LabelledGraph graph;
  graph.nodes = {node_at({20, 50}), node_at({60, 50}), node_at({300, 50})};
  add_fold(graph, 0, 1, {{20, 50}, {60, 50}});
  add_fold(graph, 2, 1, {{300, 50}, {60, 50}});
  const FoldExtents extents = extents_of(graph);
  EXPECT_NEAR(extents.to_end(0, 10), 10, 1e-9);
  EXPECT_NEAR(extents.to_end(0, 30), 30, 1e-9) << "the other one goes on, out of the frame";
  EXPECT_NEAR(extents.to_end(1, 200), 80, 1e-9);

  graph.arcs[1].invisibility = 1;
  EXPECT_NEAR(extents_of(graph).to_end(0, 30), 10, 1e-9);
}

TEST(FoldExtents, LoopsReachAnEighthOfTheirLength) {
  LabelledGraph graph;
  add_fold(graph, none, none, {{20, 20}, {30, 20}, {30, 30}, {20, 30}});
  const FoldExtents extents = extents_of(graph);
  for (const double along : {0.0, 17.0, 40.0}) EXPECT_NEAR(extents.to_end(0, along), 5, 1e-9);
}

}  // namespace
}  // namespace illustrate
