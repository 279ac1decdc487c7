// Hatch strokes as exact curves on the surface.
#pragma once

#include "core/ragged.h"
#include "core/types.h"

namespace illustrate {

struct HatchPoint {
  Vec3 position;
  SurfacePoint on;
  Vec2 image;
};

struct Hatches {
  Ragged<HatchPoint> curves;
  std::vector<Kind> kinds;  // hatch, cross_hatch or undercut
  std::vector<int> objects;
  Ragged<SurfacePoint> placed;  // by even_hatches: the streamlines that these were cut from

  void add(Span<const HatchPoint> curve, Kind kind, int object) {
    curves.add(curve);
    kinds.push_back(kind);
    objects.push_back(object);
  }
  // One of others, or all of them; what others were cut from stays with them.
  void add(const Hatches& others, std::size_t hatch) {
    add(others.curves[hatch], others.kinds[hatch], others.objects[hatch]);
  }
  void add(const Hatches& others) {
    for (std::size_t h = 0; h < others.kinds.size(); ++h) add(others, h);
  }
};

}  // namespace illustrate
