// Field curves on the surface that the hatches of every view start from: ranked, nested, the same
// for all cameras.
//
// Radius after radius, from coarse to fine, curves are started at fixed seeds where no parallel one
// (tangents within 45 degrees, same side of the same object) is nearer than the radius, and follow
// the cross until one is nearer than 0.7 of it. What is placed at a radius depends on coarser
// curves, not on a chain of neighbours: the first curves of the list that are a spacing apart in a
// view stay much the same from view to view.
#pragma once

#include "core/progress.h"
#include "core/ragged.h"
#include "field/cross_field.h"

namespace illustrate {

struct SurfaceCurves {
  Ragged<SurfacePoint> curves;  // in rank order; points about `step` apart along a curve
  double step = 0;              // world units
  // Places to fill gaps from: the first n are spread evenly by area, for any n.
  std::vector<SurfacePoint> seeds;
  double area = 0;  // of the surface
};

// One core; the finest radius is such that about 60,000 of its squares cover the surface. Throws
// Cancelled through `progress`. Nothing for a surface without area.
SurfaceCurves surface_curves(const Surface& surface, const CrossField& field,
                             const Progress& progress = {});

}  // namespace illustrate
