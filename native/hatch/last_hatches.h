// What the frame before drew, seen by this one's camera: hatches that were there are given up later
// than others would be begun, so that those on the edge of being drawn do not flicker.
#pragma once

#include "core/ragged.h"
#include "hatch/greedy/neighbour_grid.h"
#include "hatch/hatches.h"
#include "hatch/view/resting.h"
#include "view/camera.h"

namespace illustrate {

// A hatch that was there stays down to this length, in spacings; it shrinks before it goes.
constexpr double least_lived = 1;

class LastHatches {
 public:
  // strokes: their points where the surface has them now, world. Refers to the camera and to where
  // the view rests (null: nowhere).
  LastHatches(const Ragged<Vec3>& strokes, const Camera& camera, double spacing_px,
              const RestingPlaces* resting = nullptr);

  // Whether a hatch was drawn there: a parallel one near enough that no other fits between; where
  // the view rests, through the very point.
  bool was_at(const HatchPoint& point, const Vec3& tangent, double spacing_px) const;
  // Whether it was for most of these points.
  bool was_along(Span<const HatchPoint> points, double spacing_px) const;

 private:
  const Camera& camera_;
  const RestingPlaces* resting_;
  NeighbourGrid grid_;
  std::vector<double> depths_;  // by HatchNode::point
};

}  // namespace illustrate
