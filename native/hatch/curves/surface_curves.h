// Field curves on the surface that the hatches of every view start from: ranked, nested, the same
// for all cameras.
//
// Radius after radius, from coarse to fine, curves are started at fixed seeds where no parallel one
// (tangents within 45 degrees, same side of the same object) is nearer than the radius, and follow
// the cross until one is nearer than 0.7 of it. What is placed at a radius depends on coarser
// curves, not on a chain of neighbours: the first curves of the list that are a spacing apart in a
// view stay much the same from view to view.
#pragma once

#include <memory>
#include <mutex>

#include "core/progress.h"
#include "core/ragged.h"
#include "field/cross_field.h"

namespace illustrate {

// The curves of one object.
struct SurfaceCurves {
  Ragged<SurfacePoint> curves;  // in rank order; points about `step` apart along a curve
  double step = 0;              // world units
  // Places to fill gaps from: the first n are spread evenly by area, for any n.
  std::vector<SurfacePoint> seeds;
  double area = 0;  // of the object
  // (curves) down_to(radius) has those with `radius` below this.
  std::vector<double> needed_below;
};

// (t) of the triangles as they are; 0 where not finite.
std::vector<double> triangle_areas(const Surface& surface);

// All curves of one object, made radius by radius, no further than anybody has asked. They depend
// on nothing but its surface, its field and `areas`.
class RankedCurves {
 public:
  // Refers to surface and field. `triangles`: those of the object. `areas`: of all triangles, as
  // seeds and radii count them: of the first frame of a mesh that deforms, whose curves then stay
  // where it rests. Those that differ from the object's own by more than a factor of two count for
  // nothing, nor do empty ones.
  RankedCurves(const Surface& surface, const CrossField& field, std::vector<int> triangles,
               const std::vector<double>& areas = {});
  ~RankedCurves();

  // The curves of all radii down to the first that is not above `radius` (world units), or to the
  // finest, of whose squares about 60,000 cover the object; with 2.5 seeds for each square. The
  // same whatever was asked before. Stays where it is. May be called by several threads; the work
  // is done on one core. Throws Cancelled through `progress` and can then be asked again.
  const SurfaceCurves& down_to(double radius, const Progress& progress = {});
  // The same without curves: what takes no time.
  const SurfaceCurves& seeds_to(double radius);

 private:
  class Builder;
  std::recursive_mutex mutex_;
  std::unique_ptr<Builder> builder_;
  // Down to each radius, null until asked.
  std::vector<std::unique_ptr<const SurfaceCurves>> made_, seeds_;
};

}  // namespace illustrate
