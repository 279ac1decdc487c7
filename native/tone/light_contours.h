// Light as lines: terminators, where a form turns away from a light, and outlines of cast shadows
// on what receives them. Beyond the paper, which hatches light (section 6.1).
//
// A terminator is the contour that the light sees. What the light sees as an outline, labelled as
// the viewer's own lines are, is carried on along its rays to the next surface.
#pragma once

#include "contour/network/network.h"
#include "mesh/bvh.h"
#include "tone/light.h"

namespace illustrate {

struct LightContourOptions {
  bool terminators = false;
  bool shadow_outlines = false;

  bool any() const { return terminators || shadow_outlines; }
};

// What keeps the light from a scene that is seen: this scene, or one with more than is seen. The
// vertices of both surfaces are the same.
struct LightCasters {
  const ContourScene& scene;
  const Bvh& bvh;  // of its surface
  // (t) what its triangles are in the scene that is seen, none: not seen; empty: the same ones
  std::vector<int> seen = {};

  int seen_triangle(int triangle) const { return seen.empty() ? triangle : seen[idx(triangle)]; }
};

// Of the lights with `contours`; of areas with an extent from their middle. Terminators are left
// out where something else keeps the light away, and shadow outlines of lights that cast none. What
// is on backs that cannot be seen, or on the side that the viewer does not see, says so
// (ZeroPoint::unseen).
FreeLines light_contours(const ContourScene& scene, const LightCasters& casters,
                         const std::vector<Light>& lights, const Camera& camera,
                         const LightContourOptions& options, int threads,
                         const Progress& progress = {});

}  // namespace illustrate
