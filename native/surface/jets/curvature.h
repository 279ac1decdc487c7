// Curvature from derivatives and from nearby points (paper section 3 and appendix A).
#pragma once

#include "core/progress.h"
#include "surface/limit/limit_point.h"
#include "surface/surface.h"

namespace illustrate {

// The two fundamental forms' eigenproblem, I^-1 II (paper eq. 2 with the inverse that it needs).
PrincipalCurvature principal_curvature(const Vec3& du, const Vec3& dv, const Vec3& duu,
                                       const Vec3& duv, const Vec3& dvv, const Vec3& normal);
// Of a limit surface; exactly 0 where it bends by no more than rounding.
PrincipalCurvature principal_curvature(const LimitPoint& p, const Vec3& normal);

// Curvature for hatching directions: a polynomial jet fitted to the vertices around, smoother than
// the line curvature. Departure from section 5, step 1: the support takes the place of a smoothed
// copy. On subdivided meshes it is measured in edges of the control mesh, whatever the level.
// Directions lie in the tangent plane of the vertex normal, for polygon meshes in that of the jet,
// which is nearer to the smooth surface that the vertices come from.
struct JetOptions {
  int rings = 3;  // of (control) edges, one-sided at creases and boundaries
  int threads = 0;
};
Curvature jet_curvature(const Surface& surface, const JetOptions& options,
                        const Progress& progress = {});

}  // namespace illustrate
