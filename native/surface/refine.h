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
#include "surface/subdivision/levels.h"
#include "surface/surface.h"

namespace illustrate {

// Decides schemes, and splits the meshes of Loop's into triangles.
std::vector<LevelWish> level_wishes(std::vector<SoundMesh>& meshes, const SurfaceOptions& options);

struct Refined {
  Surface surface;
  std::vector<int> levels;  // (meshes) that were made
};
// Meshes of decided schemes on decided levels.
Refined refine_to(std::vector<SoundMesh> meshes, const std::vector<LevelWish>& wishes,
                  const std::vector<int>& levels, const SurfaceOptions& options,
                  const Progress& progress = {});

// Of such a surface: "triangles", "vertices", "level_<i>", and "not_subdivided" meshes: vertices of
// more than 65535 edges are too much for OpenSubdiv, and such a mesh is taken as polygons.
void report_refined(const Surface& surface, const std::vector<LevelWish>& wishes,
                    const std::vector<int>& levels, Counts& report);

// All of it: sanitized meshes to one surface with line curvature, and its report. Throws
// InvalidInput where an explicit level makes more than 200 million triangles.
Surface refine(std::vector<SoundMesh> meshes, const SurfaceOptions& options, Counts& report,
               const Progress& progress = {});

}  // namespace illustrate
