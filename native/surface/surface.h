// The triangulated smooth surface that every later stage works on: points of the limit surface with
// its normals and curvature (paper section 3).
#pragma once

#include <algorithm>
#include <memory>

#include "core/similarity.h"
#include "core/types.h"
#include "mesh/sanitize.h"

namespace illustrate {

// What an edge of a triangle is.
enum class EdgeKind : std::uint8_t { smooth, boundary, crease, flat_outline, seam, mark, material };

// Principal curvatures at a vertex: |k1| >= |k2|, positive where the surface bends towards the
// normal's side; w1, w2 unit tangents of the principal directions. Where undefined, k1 and k2 are 0
// and w1, w2 any. One line of the processor's cache: silhouettes read few vertices, far apart.
struct alignas(64) PrincipalCurvature {
  double k1 = 0, k2 = 0;
  Vec3 w1 = Vec3::Zero(), w2 = Vec3::Zero();

  bool operator==(const PrincipalCurvature& other) const {
    return k1 == other.k1 && k2 == other.k2 && w1 == other.w1 && w2 == other.w2;
  }
};
using Curvature = std::vector<PrincipalCurvature>;  // (n)

// Where a triangle lies on the limit surface: its corners on one ptex face, in steps of 2^-15.
struct PatchTriangle {
  static constexpr int steps = 32768;
  int ptex_face = none;  // of all meshes, one after another; none: of no single patch
  std::array<std::array<std::uint16_t, 2>, 3> corners{};

  Vec2 uv(int corner) const {
    const auto& c = corners[idx(corner)];
    return Vec2(c[0], c[1]) / steps;
  }
};

// A flat face of a mesh, of many polygons perhaps (surface/planes/plane_faces.h).
struct PlaneFace {
  int object = 0;
  Vec3 normal = Vec3::UnitZ();
  bool ends_sharply = true;  // at creases and boundaries, all round
  double rim_length = 0;
  Vec3 direction = Vec3::UnitX();  // unit, in the plane: one of the cross that the rim asks for
  double agreement = 0;            // share of the rim that runs along or across it
  Vec3 centre = Vec3::Zero();      // of the rectangle round it, along the direction
  Vec2 half = Vec2::Zero();        // sides, along and across
};

// What a mesh was subdivided from.
struct ControlMesh {
  SoundMesh mesh;  // for Loop's scheme split into triangles
  Scheme scheme = Scheme::polygons;
  int level = 0;
  int ptex_faces = 0;
  // (ptex faces) 1: the surface is not the limit there (surface/limit/lay_on_arcs.h); empty: it is.
  std::vector<std::uint8_t> off_limit;
};

// The control mesh of one object: several may share one, each at a place of its own.
struct PlacedControl {
  std::shared_ptr<const ControlMesh> mesh;
  int first_ptex_face = 0;  // its ptex faces among those of all objects
  Similarity placement;     // from the control mesh to the object
};

// All meshes in one. A vertex on a crease stands once for each smooth side, with that side's normal
// and curvature. On a surface that cannot be oriented the kept sheets share their vertices: the
// normal of a vertex belongs to one sheet, and `flips` says which corners see it from the other.
struct Surface {
  Points positions;          // (n) on the limit surface
  Points normals;            // (n) unit
  std::vector<int> objects;  // (n) mesh of each vertex
  // (n) Copies of one point (crease sides, split vertices) share the number of the first of them.
  std::vector<int> places;

  std::vector<Triangle> triangles;    // (t) counter-clockwise seen from the front of their sheet
  std::vector<std::uint8_t> flips;    // (t) bit k: corner k's normal and curvature change sign here
  std::vector<int> triangle_objects;  // (t)
  // (t) Triangle across edge k (corner k to k + 1), also across creases and where the sheets of a
  // double cover meet; none at boundaries and seams.
  std::vector<std::array<int, 3>> neighbours;
  std::vector<std::array<EdgeKind, 3>> edge_kinds;  // (t)
  std::vector<int> triangle_planes;  // (t) flat face of the mesh that it belongs to, or none
  std::vector<PlaneFace> planes;
  std::vector<int> triangle_faces;  // (t) face of the input mesh that it is a piece of

  // (n) Ptex face of the base meshes, one mesh after another, and where on it; none for polygons.
  std::vector<int> base_faces;
  std::vector<Vec2> base_uv;
  std::vector<PatchTriangle> patches;          // (t)
  std::vector<std::uint8_t> object_is_smooth;  // (objects) 0: drawn as the polygon mesh it is
  std::vector<PlacedControl> controls;         // (objects)

  std::vector<Edge> feature_edges;      // (e) vertices; a crease edge once for each side
  std::vector<EdgeKind> feature_kinds;  // (e)
  Curvature curvature;                  // for silhouettes and cusps
  // Ascending: vertices that the surface is held to without an edge, as a cone to its tip. It has
  // no tangent plane there; their normals are means.
  std::vector<int> tips;
  double diagonal = 0;                   // how large it is (core/spread.h)
  std::vector<double> object_diagonals;  // (objects) how large each of them is

  int object_of(int triangle) const { return triangle_objects[idx(triangle)]; }
  bool is_smooth_at(int triangle) const { return object_is_smooth[idx(object_of(triangle))] != 0; }
  // Whether the triangle's object is one of a mask of them; an empty mask has none.
  bool is_of(const std::vector<std::uint8_t>& mask, int triangle) const {
    return !mask.empty() && mask[idx(object_of(triangle))] != 0;
  }

  bool is_tip(int vertex) const {
    return !tips.empty() && std::binary_search(tips.begin(), tips.end(), vertex);
  }

  // +1, or -1 where the corner's vertex belongs to the other sheet of a double cover.
  double corner_sign(int triangle, int corner) const {
    return flips[static_cast<std::size_t>(triangle)] >> corner & 1 ? -1.0 : 1.0;
  }
};

// (objects) the box of each object's vertices, empty where it has none.
std::vector<Eigen::AlignedBox3d> object_boxes(const Surface& surface);

// Sets the diagonals of a surface whose positions and triangles are known.
void measure_diagonals(Surface& surface);

// Position and unit normal (of the triangle's own sheet) by linear interpolation.
Vec3 position_at(const Surface& surface, const SurfacePoint& point);
Vec3 normal_at(const Surface& surface, const SurfacePoint& point);

}  // namespace illustrate
