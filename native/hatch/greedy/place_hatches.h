// Stage `hatch`, placement (paper sections 6.2, 6.4): evenly spaced curves along the cross field,
// on the surface.
//
// Seeds lie on critical curves (hatches leave them as nearly at right angles as the cross allows,
// one spacing_px apart) and beside other hatches at spacing_px; a fill pass follows until no wanted
// area is farther than about 3/4 spacing from a stroke. A hatch ends at a critical curve, at the
// edge of its tone, when its world direction has turned too far, at its greatest length, where it
// would be hidden, or near a parallel hatch: within test_factor * spacing in the image, no visible
// critical curve between, world tangents within 45 degrees.
#pragma once

#include "core/progress.h"
#include "core/report.h"
#include "hatch/hatches.h"
#include "hatch/view/hatch_scene.h"

namespace illustrate {

// Where hatches start from.
enum class HatchSeeding : std::uint8_t {
  surface_curves,   // curves made once on the surface, then evened (even_hatches.h)
  critical_curves,  // the paper's: silhouettes and other hatches
};

struct HatchOptions {
  HatchSeeding seeding = HatchSeeding::surface_curves;
  double spacing_px = 8;           // d_sep
  double undercut_spacing_px = 5;  // d_sep inside undercuts
  double least_spacing_px = 4;     // on small parts (small_parts.h)
  double test_factor = 0.6;        // d_test; like min_length_px of the paper's seeding
  double step_px = 1.5;            // a tracing step of the paper's seeding
  double max_turn_deg = 150;       // of the world direction against the first one
  double max_length_px = 2500;     // a hatch gets .6 to 1 times this: ends must not line up
  double min_length_px = 8;        // shorter strokes are dropped; in undercuts half as long
};
void validate(const HatchOptions& options);  // throws InvalidInput naming the field

// Adds "hatch_steps", "hatches" to `counts`. Throws InvalidInput for a scene or options that are
// not valid, and Cancelled through `progress`.
Hatches place_hatches(const HatchScene& scene, const HatchOptions& options, Counts& counts,
                      const Progress& progress = {});

}  // namespace illustrate
