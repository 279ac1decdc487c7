// How far drawings' strokes are from places in the image.
#pragma once

#include <algorithm>
#include <limits>

#include "pipeline/draw.h"

namespace illustrate {

// From p to the nearest stroke, px.
inline double distance_px(const Drawing& drawing, const Vec2& p) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t s = 0; s < drawing.kinds.size(); ++s) {
    const int first = drawing.offsets[s], count = drawing.offsets[s + 1] - first;
    for (int i = 0; i < count - (drawing.closed[s] ? 0 : 1); ++i) {
      const Vec2& a = drawing.image[idx(first + i)];
      const Vec2 along = drawing.image[idx(first + (i + 1) % count)] - a;
      const double t = (p - a).dot(along) / std::max(along.squaredNorm(), 1e-12);
      nearest = std::min(nearest, (a + std::clamp(t, 0., 1.) * along - p).norm());
    }
  }
  return nearest;
}

// The farthest that a point of one drawing's strokes, or the middle between two, is from the
// other's, px.
inline double farthest_px(const Drawing& drawing, const Drawing& other) {
  double farthest = 0;
  for (std::size_t s = 0; s < drawing.kinds.size(); ++s) {
    for (int i = drawing.offsets[s]; i < drawing.offsets[s + 1]; ++i) {
      const Vec2& p = drawing.image[idx(i)];
      farthest = std::max(farthest, distance_px(other, p));
      if (i + 1 < drawing.offsets[s + 1])
        farthest = std::max(farthest, distance_px(other, (p + drawing.image[idx(i + 1)]) / 2));
    }
  }
  return farthest;
}

}  // namespace illustrate
