// Stage `hatch`, placement beyond the paper: hatches that are evenly spaced, long, and stay where
// they are when the camera moves a little.
//
// Ranked curves on the surface are placed where they are seen, gaps are filled from places fixed on
// the surface, ends that face each other are joined, and whole streamlines are relaxed sideways
// with a little drift off the cross; then they are cut where they come too near to each other, and
// run up to silhouettes and edges of tone. Each step is a header of its own. All lengths are in
// spacings: the same view in twice as many pixels, at twice the spacing, has the same hatches.
#pragma once

#include "core/progress.h"
#include "hatch/curves/object_curves.h"
#include "hatch/greedy/place_hatches.h"

namespace illustrate {

// (objects) how fine curves a view asks for: `curves` below are to be those down to these radii,
// world units; infinite where nothing of an object is seen and hatched.
std::vector<double> wanted_radii(const HatchScene& scene, const HatchOptions& options);

// `first`: what was placed for the drawing before this one (Hatches::placed), as points on this
// surface; where there is anything, what is there moves little. An object of which there is
// something needs only the seeds among `curves`. The rules of HatchOptions hold for both kinds of
// seeding. Adds "hatch_steps" and "hatches" to `counts`. Throws as place_hatches.
Hatches even_hatches(const HatchScene& scene, const CurvesOfObjects& curves,
                     const Ragged<SurfacePoint>& first, const HatchOptions& options, int threads,
                     Counts& counts, const Progress& progress = {});

// The same as a first look, in a quarter of the time: what `even_hatches` starts from, and clips.
// Gaps are not filled, nothing is evened out, and undercuts have none of their own. Nothing is told
// of what was placed (Hatches::placed), nor counted of steps.
Hatches draft_hatches(const HatchScene& scene, const CurvesOfObjects& curves,
                      const Ragged<SurfacePoint>& first, const HatchOptions& options, int threads,
                      Counts& counts, const Progress& progress = {});

}  // namespace illustrate
