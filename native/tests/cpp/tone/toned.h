// Levels and bands of a scene.
#pragma once

#include "tone/tone_regions.h"

namespace illustrate {

inline ToneMap toned(const ToneScene& scene, const LabelledGraph& graph,
                     const ToneOptions& options = {}) {
  ToneMap tone = tone_levels(scene, options);
  add_bands(scene, graph, options, tone);
  return tone;
}

}  // namespace illustrate
