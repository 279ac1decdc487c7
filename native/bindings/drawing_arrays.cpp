#include "bindings/drawing_arrays.h"

namespace illustrate::bindings {

DrawingArrays::DrawingArrays(DrawResult drawn) : result(std::move(drawn)) {
  for (const SurfacePoint& p : result.drawing.on) {
    triangles.push_back(p.triangle);
    barycentrics.push_back({static_cast<float>(p.b1), static_cast<float>(p.b2)});
  }
  for (const GraphNode& node : result.graph.nodes) {
    node_kind.push_back(static_cast<std::uint8_t>(node.kind));
    node_image.push_back(node.image);
    node_arcs.push_back(node.arcs);
  }
  for (const GraphArc& arc : result.graph.arcs) {
    arc_nodes.push_back({arc.start_node, arc.end_node});
    arc_kind.push_back(static_cast<std::uint8_t>(arc.kind));
    arc_object.push_back(arc.object);
    arc_invisibility.push_back(arc.invisibility);
    arc_flush.push_back(arc.is_flush ? 1 : 0);
    arc_layers_over.push_back(layers_over(arc));
  }
  for (const CurvePoint& p : result.graph.points.values) arc_points.push_back(p.position);
}

}  // namespace illustrate::bindings
