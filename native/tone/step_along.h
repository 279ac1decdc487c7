// Evenly spaced samples of a curve in the image.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/ragged.h"
#include "core/types.h"

namespace illustrate {

// A rectangle of the image.
struct Frame {
  Vec2 low;
  Vec2 high;
};

// The part [from, to] of the segment a + t (b - a), 0 <= t <= 1, inside the frame; false where
// there is none.
inline bool clip_to_frame(const Frame& frame, const Vec2& a, const Vec2& b, double& from,
                          double& to) {
  from = 0, to = 1;
  for (int axis = 0; axis < 2; ++axis) {
    const double start = a[axis], run = b[axis] - a[axis];
    if (run == 0) {
      if (start < frame.low[axis] || start > frame.high[axis]) return false;
      continue;
    }
    double enter = (frame.low[axis] - start) / run, leave = (frame.high[axis] - start) / run;
    if (enter > leave) std::swap(enter, leave);
    from = std::max(from, enter);
    to = std::min(to, leave);
  }
  return from <= to;
}

// A place on a polyline: between points `segment` and the next.
struct CurveSample {
  std::size_t segment;
  double fraction;
  Vec2 image;
  Vec2 heading;  // unit
};

// Calls visit(CurveSample) every `step` px along the polyline, inside the frame only; closed: the
// last point is joined to the first.
template <class Visit>
void step_along(Span<const Vec2> line, bool closed, double step, const Frame& frame,
                const Visit& visit) {
  double next = step / 2;  // distance from the segment's start to the next sample
  const std::size_t segments = line.size() < 2 ? 0 : line.size() - (closed ? 0 : 1);
  for (std::size_t i = 0; i < segments; ++i) {
    const Vec2& a = line[i];
    const Vec2& b = line[i + 1 == line.size() ? 0 : i + 1];
    const double length = (b - a).norm();
    double from, to;
    if (!(length > 0) || !clip_to_frame(frame, a, b, from, to)) continue;
    next = std::max(next, from * length);
    for (; next <= to * length; next += step) {
      const double fraction = next / length;
      visit(CurveSample{i, fraction, a + fraction * (b - a), (b - a) / length});
    }
    next = to < 1 ? step / 2 : next - length;
  }
}

}  // namespace illustrate
