// Seams, where another family stays: of hatches that cross there one gives way.
#pragma once

#include "hatch/reduction/hatch_points.h"

namespace illustrate {

// (points) 1: kept. No two kept points of different hatches in single-hatch regions are
// perpendicular within a spacing on one sheet. Of two the one goes that the frame before did not
// draw, then the one nearer to an end of its hatch: hatches that run along a seam stay and those
// that end there are cut. Points in shadows and undercuts are all kept.
std::vector<std::uint8_t> kept_at_seams(const HatchPoints& points, const HatchScene& scene,
                                        double spacing_px);

}  // namespace illustrate
