// What the tests of lines of curvature share.
#pragma once

#include <gtest/gtest.h>

#include <cmath>

#include "contour/shape/curvature_curves.h"

namespace illustrate::curvature_lines {

constexpr double crest = 0.07;  // not where a row of vertices is

inline double wave(double x) { return 0.1 * std::cos(4 * (x - crest)); }

inline CurvatureCurveOptions everything(double threshold) {
  CurvatureCurveOptions options;
  options.suggestive_contours = options.ridges = options.valleys = true;
  options.suggestive_threshold = options.ridge_threshold = options.valley_threshold = threshold;
  return options;
}

inline CurvatureCurveOptions ridges_and_valleys(double threshold) {
  CurvatureCurveOptions options = everything(threshold);
  options.suggestive_contours = false;
  return options;
}

// Segments lie in the triangles that they name, and points where they say.
inline void check_curves(const Surface& surface, const FreeLines& found) {
  ASSERT_EQ(found.kinds.size(), found.lines.curves.size());
  ASSERT_EQ(found.lines.closed.size(), found.lines.curves.size());
  for (const ZeroPoint& p : found.lines.curves.values) {
    EXPECT_LT((position_at(surface, p.on) - p.position).norm(), 1e-9 * surface.diagonal);
    EXPECT_GE(p.strength, 0);
  }
}

}  // namespace illustrate::curvature_lines
