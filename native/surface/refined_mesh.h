// One level of a mesh with what the surface needs of its topology: corners, the corners across
// edges, kinds of edges, and where faces and vertices came from.
//
// A corner is also the half-edge from its vertex to the next corner's.
#pragma once

#include "mesh/sanitize.h"
#include "surface/surface.h"

namespace illustrate {

// Part of a ptex face that a refined face covers: corner k lies at origin + size * (unit corner k).
struct FaceDomain {
  int ptex_face = none;
  Vec2 origin = Vec2::Zero();
  double size = 1;  // negative: turned by 180 degrees (the middle triangle of Loop's four)
};

struct RefinedMesh {
  Points points;                     // (n) control points of this level
  std::vector<int> face_offsets{0};  // (f + 1) first corner of each face
  std::vector<int> corner_vertices;  // (c)
  std::vector<int> corner_edges;     // (c)
  std::vector<int> corner_faces;     // (c)
  std::vector<int> mates;            // (c) corner of the half-edge across, `none` at open edges
  std::vector<EdgeKind> edge_kinds;  // (e)
  std::vector<std::uint8_t> sharp_vertices;  // (n) 1: the surface goes through the point
  std::vector<std::uint8_t> semi_sharp;      // (n) 1: masks of this level do not reach the limit
  std::vector<int> base_faces;               // (f) face of the sound mesh
  std::vector<FaceDomain> domains;           // (f) empty for polygons that are not subdivided
  bool triangles_are_patches = false;        // Loop: a triangle is one ptex face; else it is three
  std::vector<int> places;         // (n) shared by vertices split along seams; empty: none are
  std::vector<int> twin_faces;     // (f) on the other sheet; empty: no double cover
  std::vector<int> twin_vertices;  // (n)

  std::size_t face_count() const { return face_offsets.size() - 1; }
  int face_size(int face) const { return first(face + 1) - first(face); }
  int first(int face) const { return face_offsets[static_cast<std::size_t>(face)]; }
  int vertex(int corner) const { return corner_vertices[static_cast<std::size_t>(corner)]; }
  int face(int corner) const { return corner_faces[static_cast<std::size_t>(corner)]; }
  int mate(int corner) const { return mates[static_cast<std::size_t>(corner)]; }
  EdgeKind kind(int corner) const {
    return edge_kinds[static_cast<std::size_t>(corner_edges[static_cast<std::size_t>(corner)])];
  }
  int next(int corner) const {
    const int f = face(corner);
    return corner + 1 == first(f + 1) ? first(f) : corner + 1;
  }
  int previous(int corner) const {
    const int f = face(corner);
    return corner == first(f) ? first(f + 1) - 1 : corner - 1;
  }
  const Vec3& point(int corner) const { return points[static_cast<std::size_t>(vertex(corner))]; }

  // Normals of its two sides are not the same surface's.
  bool is_sharp(int corner) const {
    return mate(corner) == none || kind(corner) == EdgeKind::crease;
  }
};

// The corner of the twin face at the twin of this corner's vertex.
int twin_corner(const RefinedMesh& mesh, int corner);

// Where a corner lies on the base mesh.
struct BasePlace {
  int ptex_face = none;
  Vec2 uv = Vec2::Zero();
};
BasePlace base_place(const RefinedMesh& mesh, int corner);

// Fills corner_faces and mates from face_offsets and corner_edges.
void connect(RefinedMesh& mesh);

// The polygons of a sound mesh as they are.
RefinedMesh polygonal_mesh(const SoundMesh& mesh);

}  // namespace illustrate
