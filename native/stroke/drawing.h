// The finished drawing: strokes with width, in the image and in the world.
#pragma once

#include "core/report.h"
#include "core/types.h"

namespace illustrate {

// Stroke i is points[offsets[i] .. offsets[i + 1]); closed strokes do not repeat their first point.
struct Drawing {
  Points points;                     // (p) world
  ImagePoints image;                 // (p) px
  std::vector<float> widths;         // (p) px
  std::vector<SurfacePoint> on;      // (p) where on the surface
  std::vector<int> offsets{0};       // (s + 1)
  std::vector<Kind> kinds;           // (s)
  std::vector<std::uint8_t> closed;  // (s)
  std::vector<int> objects;          // (s)
  std::vector<int> invisibility;     // (s) 0 = visible, else the number of layers in front
};

}  // namespace illustrate
