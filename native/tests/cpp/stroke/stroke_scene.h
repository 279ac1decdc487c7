// Graphs by hand, and what is drawn of them.
#pragma once

#include <cmath>

#include "core/pi.h"
#include "stroke/make_strokes.h"

namespace illustrate::stroke_scene {

inline constexpr int size_px = 100;

// World x, y in [0, 100] are the image's, y up; looks down -z.
inline Camera flat_camera() {
  Mat4 projection = Mat4::Identity();
  projection(0, 0) = projection(1, 1) = 2.0 / size_px;
  projection(0, 3) = projection(1, 3) = -1;
  projection(2, 2) = -0.01;
  return {projection, Mat4::Identity(), size_px, size_px};
}

// A graph by hand: nodes at image points, arcs as polylines through image points.
struct GraphBuilder {
  LabelledGraph graph;

  int node(NodeKind kind, const Vec2& image) {
    graph.nodes.push_back({kind, image});
    return static_cast<int>(graph.nodes.size()) - 1;
  }

  int arc(const std::vector<Vec2>& image, int start, int end, int invisibility = 0,
          Kind kind = Kind::silhouette, int object = 0) {
    for (const Vec2& p : image) {
      graph.image.push(p);
      graph.points.push({Vec3(p.x(), size_px - p.y(), 0), {}});
    }
    graph.image.close_list();
    graph.points.close_list();
    graph.arcs.push_back({kind, object, 0, start, end, invisibility, 2, 0});
    return static_cast<int>(graph.arcs.size()) - 1;
  }

  // Between two nodes, straight.
  int line(int start, int end, int invisibility = 0, Kind kind = Kind::silhouette, int object = 0) {
    const auto image = [&](int n) { return graph.nodes[static_cast<std::size_t>(n)].image; };
    return arc({image(start), image(end)}, start, end, invisibility, kind, object);
  }
};

inline std::vector<Vec2> circle(const Vec2& centre, double radius, int count) {
  std::vector<Vec2> points;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * pi * i / count;
    points.push_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  return points;
}

inline Drawing strokes_of(const LabelledGraph& graph, const StrokeOptions& options = {},
                          const std::vector<double>& width_scale = {},
                          const std::vector<std::uint8_t>& undrawn = {}) {
  return make_strokes(graph, {}, {}, flat_camera(), width_scale, undrawn, options);
}

inline std::size_t count_of(const Drawing& drawing) { return drawing.kinds.size(); }

inline Vec2 first_of(const Drawing& drawing, std::size_t stroke) {
  return drawing.image[static_cast<std::size_t>(drawing.offsets[stroke])];
}

inline Vec2 last_of(const Drawing& drawing, std::size_t stroke) {
  return drawing.image[static_cast<std::size_t>(drawing.offsets[stroke + 1]) - 1];
}

// A front line from left to right over a back line that is hidden by two layers above it.

}  // namespace illustrate::stroke_scene
