// The light that comes back from every cell that is seen: what the lights send, shadows let through
// and surfaces throw back (paper section 6.1), or what an image says.
#pragma once

#include <memory>
#include <vector>

#include "core/progress.h"
#include "mesh/bvh.h"
#include "occlusion/visible_image.h"
#include "tone/light.h"
#include "tone/lightness.h"

namespace illustrate {

// What lies in the light. `casters`: what casts shadows; null: nothing. lightness: of the surface;
// null: white. reflectance: how much that counts, in [0, 1]. catchers: marked, by object; each is
// as light as the share of the light that others let through to it; empty: none.
struct LitScene {
  const Surface& surface;
  const Bvh* casters = nullptr;
  const Lightness* lightness = nullptr;
  double reflectance = 1;
  const std::vector<std::uint8_t>& catchers;
};

// (height * width), 0 where nothing is seen. No lights: a headlight. Shadows of lamps with an
// extent are soft, and are asked for at some cells only (tone/sparse_cells.h).
std::vector<double> light_of_cells(const LitScene& scene, const VisibleImage& visible,
                                   const Camera& camera, const std::vector<Light>& lights,
                                   int threads, const Progress& progress = {});

// The same as an image that fills the view has it.
std::vector<double> light_of_image(const Texture& image, const VisibleImage& visible,
                                   const Camera& camera, int threads,
                                   const Progress& progress = {});

}  // namespace illustrate
