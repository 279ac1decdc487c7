// Lines with weight: how much wider or thinner than its kind says a line is at each of its points.
//
// By light: wider on the side of a form that is turned from the light. What counts is the flow of
// light across the line towards the side where its surface is not, as a share of all light there:
// 1 facing the only light, -1 turned from it, 0 where light comes from everywhere or from the eye.
// It knows no cast shadows, textures or exposure, so that an outline swells evenly.
// By depth: wider where nearer, between the nearest and the farthest lines that are seen.
// Inside: lines with the same object on both sides, as the eye has it.
#pragma once

#include <vector>

#include "mesh/bvh.h"
#include "surface/surface.h"
#include "tone/light.h"
#include "view/camera.h"
#include "visibility/labelled_graph.h"

namespace illustrate {

struct LineWeightOptions {
  double by_light = 0;     // share by which lines swell away from the light, [0, 1]
  double by_depth = 0;     // share by which the nearest swell and the farthest thin out, [0, 1]
  double inner_scale = 1;  // of lines inside an object's outline, at least 0

  bool any() const { return by_light > 0 || by_depth > 0 || inner_scale != 1; }
};

// (arcs)(points) factors of the width, for each point of the graph. `surface` and its `bvh`: all
// that can be seen. No lights: one headlight.
Ragged<double> line_weights(const LabelledGraph& graph, const Surface& surface, const Bvh& bvh,
                            const Camera& camera, const std::vector<Light>& lights,
                            const LineWeightOptions& options);

// What of all light at a place flows towards `direction` (unit), in [-1, 1]; 0 without light.
double light_from(const std::vector<Light>& lights, const Camera& camera, const Vec3& position,
                  const Vec3& direction);

}  // namespace illustrate
