// Glass: objects that hide nothing.
#pragma once

#include "pipeline/draw.h"

namespace illustrate {

bool any_is_seen_through(const std::vector<ObjectStyle>& styles);

// What `draw` does where some objects are seen through: two drawings in one. Of the first these are
// left out; its graph, tone and hatches are the result's. The second has their lines alone, with
// every object opaque, so that a bottle's own far side and what stands before it hide them.
DrawResult draw_seen_through(const Prepared& prepared, const Camera& camera,
                             const DrawOptions& options, const std::vector<Light>& lights,
                             const Progress& progress, const Drawing* previous);

}  // namespace illustrate
