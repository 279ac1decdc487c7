// How fine a surface is made.
#pragma once

#include "mesh/polygon_mesh.h"

namespace illustrate {

struct SurfaceOptions {
  Scheme scheme = Scheme::automatic;
  // -1: the first level whose median edge is at most edge_length, and on which chords over coarse
  // bends are short beside it (subdivision/coarse_bends.h), within the budget, at most 7.
  int level = -1;
  double edge_length = 0;  // world units; 0: 1/600 of the diagonal of all meshes (core/spread.h)
  // Binds automatic levels only, all meshes together: the mesh with the shortest edges gives up a
  // level first.
  int triangle_budget = 250000;
  int threads = 0;  // 0: all cores
};

// Throws InvalidInput naming the field.
void validate(const SurfaceOptions& options);

}  // namespace illustrate
