// Stage `surface`: subdivision to limit positions, normals and curvature (paper section 3, appendix
// A).
//
// Scheme `automatic` is Catmull-Clark when most faces are quads, Loop otherwise (other faces are
// split first), and `polygons` takes the mesh as it is. Refinement is OpenSubdiv's, uniform;
// vertices are pushed to the limit. Infinitely sharp edges become creases with one normal a side;
// semi-sharp ones are OpenSubdiv's own. Triangles of quads: split along the shorter diagonal of the
// limit points that lies inside, ties towards the first corner.
#pragma once

#include "core/progress.h"
#include "core/report.h"
#include "mesh/sanitize.h"
#include "surface/surface.h"

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

// Sanitized meshes to one surface with line curvature. Adds "triangles", "vertices", "level_<i>" to
// `report`, and "not_subdivided" meshes: vertices of more than 65535 edges are too much for
// OpenSubdiv, and such a mesh is taken as polygons. Throws InvalidInput where an explicit level
// makes more than 200 million triangles.
Surface refine(std::vector<SoundMesh> meshes, const SurfaceOptions& options, Counts& report,
               const Progress& progress = {});

}  // namespace illustrate
