// Polygon meshes as a modelling program holds them, and their soundness after mending.
#pragma once

#include <memory>
#include <optional>

#include "core/report.h"
#include "core/similarity.h"
#include "core/types.h"
#include "mesh/reflectance.h"

namespace illustrate {

// polygons: no subdivision, the mesh is drawn as it is (public name "none").
enum class Scheme : std::uint8_t { automatic, catmull_clark, loop, polygons };

// How a subdivision surface ends at a boundary (OpenSubdiv's EDGE_AND_CORNER and EDGE_ONLY).
enum class BoundaryRule : std::uint8_t { corners, edges };

// OpenSubdiv's scale: from this value on an edge stays sharp at every level.
constexpr double infinitely_sharp = 10.0;

// Any polygon mesh, in world space, whatever its defects.
struct PolygonMesh {
  Points positions;                      // (n)
  std::vector<int> face_sizes;           // (f) corners per face
  std::vector<int> corner_vertices;      // (sum of face_sizes) vertex of each corner
  std::vector<Edge> edge_vertices;       // (e) edges that carry a sharpness
  std::vector<double> edge_sharpness;    // (e) 0 smooth .. 10 infinitely sharp
  std::vector<double> vertex_sharpness;  // (n) or empty
  std::vector<Edge> marked_edges;        // (m) drawn as Kind::mark when asked for
  std::vector<Edge> loose_edges;         // (l) of no face, drawn as Kind::loose when asked for
  std::vector<int> face_materials;       // (f) or empty; their borders are Kind::material
  std::vector<int> hole_faces;           // (h) faces that shape the limit and are not there
  // (sum of face_sizes) or empty: shading normals of any length at the corners, in the space of
  // positions; where one is zero or not finite the face's own stands in.
  Points corner_normals;
  Reflectance reflectance;
  // The vertices are the control mesh of a subdivision surface, which goes near them; else the
  // surface keeps to the mesh, and its boundaries have corners by their angle, whatever `boundary`.
  bool cage = true;
  BoundaryRule boundary = BoundaryRule::corners;
  // Edges that turn more become infinitely sharp; 180: none. With corner_normals, or where the mesh
  // is no cage: only between faces that are shaded flat (mesh/creases.h).
  double crease_angle_deg = 180;
  std::optional<Scheme> scheme;  // this mesh's own, instead of the options'
  std::optional<int> level;
  // World units: three units of paper where it is nearest. What is rounded within half of it has a
  // line (mesh/fine_bends.h).
  std::optional<double> edge_length;
  std::string name;
  // Of an instance (mesh/instance.h): what it is a copy of, and from there to here.
  std::shared_ptr<const PolygonMesh> original;
  Similarity placement;
};

// Throws InvalidInput, naming the argument and the index, where arrays do not fit together:
// face_sizes that are negative or do not sum up to the corners, sharpness, materials or normals of
// another length, indices of faces, corners, edges and textures out of range.
void validate(const PolygonMesh& mesh);

}  // namespace illustrate
