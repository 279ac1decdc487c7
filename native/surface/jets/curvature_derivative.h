// How curvature changes along the surface (Rusinkiewicz 2004, "Estimating curvatures and their
// derivatives on triangle meshes").
#pragma once

#include "core/progress.h"
#include "surface/jets/curvature.h"

namespace illustrate {

// The derivative of the second fundamental form II at a vertex, symmetric in its three arguments:
// C(w1, w1, w1), C(w1, w1, w2), C(w1, w2, w2), C(w2, w2, w2), world units ^ -2. Like curvature it
// changes sign with the normal.
using CubicForm = std::array<double, 4>;

// C(t, t, t) of the tangent t = x w1 + y w2.
constexpr double along(const CubicForm& c, double x, double y) {
  return x * x * (x * c[0] + 3 * y * c[1]) + y * y * (3 * x * c[2] + y * c[3]);
}

struct CurvatureDerivative {
  Curvature curvature;            // what it is the derivative of
  std::vector<CubicForm> cubics;  // (n) in the frame w1, w2 of `curvature`
  std::vector<double> second;     // (n) derivative of C(w1, w1, w1) along w1, world units ^ -3
};

// The curvature is smoothed first, by diffusion of II over .009 of each object's diagonal, since
// the derivative of noise is noise. Then least squares over the neighbours of each vertex, II
// brought into the vertex's own tangent plane; one-sided at creases and boundaries, on the vertex's
// own sheet where a surface cannot be oriented.
CurvatureDerivative curvature_derivative(const Surface& surface, const Curvature& curvature,
                                         int threads, const Progress& progress = {});

}  // namespace illustrate
