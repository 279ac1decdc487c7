// What of the last drawing's hatches the next one starts from.
#pragma once

#include "stroke/drawing.h"
#include "surface/same_objects.h"

namespace illustrate {

// The hatches that a drawing was made of, but not those in undercuts, which go with the view. The
// paper's seeding leaves those that were drawn.
Ragged<SurfacePoint> placed_of(const Drawing& drawing);

// Lines of the last surface on this one, as far as their objects are the same.
Ragged<SurfacePoint> moved_lines(const Ragged<SurfacePoint>& lines, const SameObjects& same);

// The hatches of a drawing, where they are now.
Ragged<Vec3> drawn_hatches(const Drawing& drawing, const SameObjects& same);

}  // namespace illustrate
