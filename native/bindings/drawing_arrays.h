// A drawing with everything as plain arrays, made once for each drawing.
#pragma once

#include "pipeline/draw.h"

namespace illustrate::bindings {

struct DrawingArrays {
  explicit DrawingArrays(DrawResult drawn);

  DrawResult result;
  std::vector<int> triangles;                      // (p)
  std::vector<std::array<float, 2>> barycentrics;  // (p)
  std::vector<std::uint8_t> node_kind;             // (k)
  ImagePoints node_image;                          // (k)
  std::vector<std::array<int, 4>> node_arcs;       // (k)
  std::vector<Edge> arc_nodes;                     // (a)
  std::vector<std::uint8_t> arc_kind;              // (a)
  std::vector<int> arc_object;                     // (a)
  std::vector<int> arc_invisibility;               // (a)
  std::vector<std::uint8_t> arc_flush;             // (a)
  std::vector<int> arc_layers_over;                // (a)
  Points arc_points;                               // (q)
};

}  // namespace illustrate::bindings
