// How many levels of refinement each mesh gets.
#pragma once

#include "mesh/sanitize.h"
#include "surface/surface_options.h"

namespace illustrate {

// What the level of a mesh goes by.
struct LevelWish {
  Scheme scheme = Scheme::polygons;
  int level = 0;                            // that the mesh would have alone
  bool is_automatic = false;                // may be given up for the budget
  std::int64_t triangles = 0, corners = 0;  // of drawn faces
  int copies = 1;                           // where it is drawn
  double median_edge = 0;                   // world units, where it is drawn largest
  bool has_long_edges = false;              // so many that their bends have to be looked at
};

// Whether a mesh's level depends on how large the scene is.
bool goes_by_the_scene(const SurfaceOptions& options, std::optional<int> own_level,
                       std::optional<double> own_edge_length);

// The edges that automatic levels go by where neither mesh nor options give a length: a share of
// the diagonal of all meshes (core/spread.h), world units.
double usual_edge_length(const std::vector<SoundMesh>& meshes);

// Of a mesh of this scheme; one of Loop's is of triangles. Throws InvalidInput where an explicit
// level makes more triangles than indices can count.
LevelWish level_wish(const SoundMesh& mesh, Scheme scheme, const SurfaceOptions& options,
                     double usual_edge_length);

// Of each mesh, within the budget for all.
std::vector<int> choose_levels(const std::vector<LevelWish>& wishes, int triangle_budget);

}  // namespace illustrate
