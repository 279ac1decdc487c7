// What a view is hatched on, and with.
#pragma once

#include "field/families/families.h"
#include "hatch/last_hatches.h"
#include "hatch/view/critical_curves.h"
#include "hatch/view/resting.h"
#include "tone/tone_regions.h"

namespace illustrate {

// References: what they name must outlive the scene and all that is made with it.
struct HatchScene {
  const Surface& surface;
  const CrossField& field;
  const Families& families;  // of the field: which stays where tone asks for one
  const Camera& camera;
  const VisibleImage& visible;
  const ToneMap& tone;
  const LabelledGraph& graph;
  const CriticalCurves& curves;                // of the graph
  const std::vector<float>& spacing_scale;     // (t) one factor per triangle, empty: 1
  const std::vector<std::uint8_t>& unhatched;  // one flag per object, empty: all are hatched
  const LastHatches* last = nullptr;           // what the frame before drew; null: nothing
  const RestingPlaces* resting = nullptr;      // where it showed the same; null: nowhere

  bool is_hatched(int object) const { return unhatched.empty() || !unhatched[idx(object)]; }
  // Of a triangle.
  double scale_on(int triangle) const {
    return spacing_scale.empty() ? 1 : double(spacing_scale[idx(triangle)]);
  }
  // `spacing_px` there; never less than a pixel.
  double spacing_on(int triangle, double spacing_px) const {
    return std::max(1.0, spacing_px * scale_on(triangle));
  }
};

// Throws InvalidInput where the lists do not fit the surface.
void validate(const HatchScene& scene);

}  // namespace illustrate
