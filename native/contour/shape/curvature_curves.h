// Lines of shape on smooth surfaces, as zero sets of functions of curvature: suggestive contours
// (DeCarlo et al. 2003), ridges and valleys (Ohtake et al. 2004). Beyond the paper.
//
// Each function is known at the vertices and linear along edges, so every triangle carries at most
// one segment of each family. The lines hide nothing and bound nothing: what is weaker than a
// threshold is left out and lines end freely, with hysteresis, and short ones are left out. Polygon
// objects have none.
#pragma once

#include "contour/intersection/intersections.h"
#include "contour/zero_curves.h"
#include "surface/jets/curvature_derivative.h"
#include "view/camera.h"

namespace illustrate {

// The thresholds have no unit: curvature is measured against the diagonal d of the object
// (core/spread.h). Larger ones leave fewer and shorter lines.
struct CurvatureCurveOptions {
  bool suggestive_contours = false;
  bool ridges = false;
  bool valleys = false;
  // Least derivative of the radial curvature towards the eye, times d^2.
  double suggestive_threshold = 20;
  // Least curvature across the line, times d.
  double ridge_threshold = 15;
  double valley_threshold = 15;

  bool any() const { return suggestive_contours || ridges || valleys; }
  bool wants(Kind kind) const {
    return kind == Kind::suggestive ? suggestive_contours : kind == Kind::ridge ? ridges : valleys;
  }
};
void validate(const CurvatureCurveOptions& options);  // throws InvalidInput naming the field

// Suggestive contours: the radial curvature is 0 and grows towards the eye, on the side of the
// surface that is seen. Ridges and valleys: the larger principal curvature is largest along its own
// direction; what is a ridge from one side is a valley from the other, so the lines of both are
// found together when either is wanted, and told apart point by point. Backs that cannot be seen
// have none. `derivative`: of the surface's vertices.
FreeLines curvature_curves(const Surface& surface, const CurvatureDerivative& derivative,
                           const IntersectionCurves& intersections, const Camera& camera,
                           const CurvatureCurveOptions& options);

}  // namespace illustrate
