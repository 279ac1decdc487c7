// What is hidden for certain in a view, whatever it is.
//
// As in a z-pyramid (Greene, Kass and Miller 1993, "Hierarchical z-buffer visibility"), what lies
// behind the farthest of the depths that are seen all over a region of the image is seen nowhere in
// it. The depths are sampled: what shows through slits narrower than a cell alone is taken for
// hidden.
#pragma once

#include "occlusion/visible_image.h"

namespace illustrate {

class OcclusionMap {
 public:
  // image: of the surface. reach: cells all round a place that have to be covered too, so that
  // curves are still known a little beyond the edge that they pass behind. A triangle of a curved
  // surface hides what is farther behind it than reach_of_own_curves: those do not quite lie on it.
  OcclusionMap(const Surface& surface, const VisibleImage& image, int reach);
  // Without any reach: a triangle begins to hide farther back, by as much as its plane recedes in
  // two cells, so that a steep one does not hide the rim of its own surface.
  OcclusionMap(const Surface& surface, const VisibleImage& image, const Camera& camera);
  OcclusionMap with_more_reach(int cells) const;

  // Whether all that lies in the box from `low` to `high` (px of the image), at `depth` or farther,
  // is behind a surface. Never where the box leaves the image, or has more cells than are looked
  // at.
  bool hides(const Vec2& low, const Vec2& high, double depth) const;

 private:
  int width_, height_;
  double cell_px_;
  std::vector<float> farthest_;  // (cells) within reach; infinity where nothing is seen
};

}  // namespace illustrate
