// One view of a prepared scene: lines, tone (pipeline/view.h), hatches, strokes.
#pragma once

#include "pipeline/view.h"

namespace illustrate {

// How much is made of a view. Lines are those of the whole drawing. A draft has hatches, too, but
// as they are first placed (hatch/even_hatches.h: draft_hatches): something to look at while the
// whole is made. The paper's seeding knows no draft and makes the whole.
enum class Detail : std::uint8_t { lines, draft, whole };

struct DrawResult {
  Drawing drawing;
  LabelledGraph graph;
  ToneMap tone;     // of no size where nothing is hatched
  Counts counts;    // exact work, the same on every machine
  Timings timings;  // seconds: contour, visibility, tone, hatch, stroke; disjoint
};

// No lights: one headlight. `previous`: the drawing of the frame before, whose strokes live on
// (stroke/tracks.h); the hatches of objects that are the same (surface/same_objects.h), moved or
// not, are kept where they can be. Where `prepared` lacks its intersections or field, they are made
// first, on its own account. Throws InvalidInput for wrong options and lights.
DrawResult draw(const Prepared& prepared, const Camera& camera, const DrawOptions& options,
                const std::vector<Light>& lights = {}, const Progress& progress = {},
                const Drawing* previous = nullptr);

// The same from a view that is there. What follows a draft places its hatches anew.
DrawResult draw(const View& view, const Progress& progress = {}, const Drawing* previous = nullptr,
                Detail detail = Detail::whole);

// The triangles that carry silhouettes, by the dual search, or `brute_force` from the signs at the
// corners of every triangle.
std::vector<int> silhouette_triangles(const Prepared& prepared, const Camera& camera,
                                      bool brute_force);

}  // namespace illustrate
