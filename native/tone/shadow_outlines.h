// Outlines of cast shadows, for light_contours.h only.
#pragma once

#include "tone/light_contours.h"

namespace illustrate {

// What the light sees of `casters` in one of its views as an outline, carried on to the surface
// behind it, if that is seen: a ray beside a place of the outline says which triangle that is, and
// from there the outline's planes through the light are followed over the surface
// (contour/shape/plane_section.h) as far as it goes. The points lie where the light's own rays meet
// the triangles; where the viewer sees the other side of the surface than the light they are
// unseen. Closed outlines whose shadow falls on one surface give closed lines.
void add_shadow_outlines(const Surface& seen, const LightCasters& casters, const Light& light,
                         const Camera& view, const Camera& viewer, int threads,
                         const Progress& progress, FreeLines& result);

}  // namespace illustrate
