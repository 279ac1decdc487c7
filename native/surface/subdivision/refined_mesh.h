// One level of a mesh with what the surface needs of its topology: corners, the corners across
// edges, kinds of edges, and where faces and vertices came from.
//
// A corner is also the half-edge from its vertex to the next corner's.
#pragma once

#include "mesh/sanitize.h"
#include "surface/surface.h"

namespace illustrate {

// Part of a ptex face that a refined face covers, in steps of 2^-15: corner k lies at
// origin + size * (unit corner k).
struct FaceDomain {
  static constexpr int steps = PatchTriangle::steps;
  int ptex_face = none;
  std::array<std::uint16_t, 2> origin{};
  int size = steps;  // negative: turned by 180 degrees (the middle triangle of Loop's four)
};

struct RefinedMesh {
  Points points;                     // (n) control points of this level
  std::vector<int> corner_vertices;  // (c)
  int corners_per_face = 0;  // 3 or 4 where all faces have as many; 0: mixed, and only then:
  std::vector<int> face_offsets{0};    // (f + 1) first corner of each face
  std::vector<int> corner_faces;       // (c)
  std::vector<int> mates;              // (c) corner of the half-edge across, `none` at open edges
  std::vector<EdgeKind> corner_kinds;  // (c) of the half-edge
  std::vector<std::uint8_t> sharp_vertices;  // (n) 1: the surface goes through the point
  // (n) 1: masks of this level do not reach the limit; empty: they do at all vertices.
  std::vector<std::uint8_t> semi_sharp;
  std::vector<int> base_faces;         // (f) face of the sound mesh
  std::vector<FaceDomain> domains;     // (f) empty for polygons that are not subdivided
  bool triangles_are_patches = false;  // Loop: a triangle is one ptex face; else it is three
  std::vector<int> places;             // (n) shared by vertices split along seams; empty: none are
  std::vector<int> twin_faces;         // (f) on the other sheet; empty: no double cover
  std::vector<int> twin_vertices;      // (n)

  std::size_t corner_count() const { return corner_vertices.size(); }
  std::size_t face_count() const {
    return corners_per_face ? corner_count() / idx(corners_per_face) : face_offsets.size() - 1;
  }
  int first(int face) const {
    return corners_per_face ? corners_per_face * face : face_offsets[idx(face)];
  }
  int face_size(int face) const {
    return corners_per_face ? corners_per_face : first(face + 1) - first(face);
  }
  int face(int corner) const {
    if (corners_per_face == 4) return corner / 4;
    return corners_per_face == 3 ? corner / 3 : corner_faces[idx(corner)];
  }
  int vertex(int corner) const { return corner_vertices[idx(corner)]; }
  int mate(int corner) const { return mates[idx(corner)]; }
  EdgeKind kind(int corner) const { return corner_kinds[idx(corner)]; }
  int next(int corner) const {
    const int f = face(corner);
    return corner + 1 == first(f + 1) ? first(f) : corner + 1;
  }
  int previous(int corner) const {
    const int f = face(corner);
    return corner == first(f) ? first(f + 1) - 1 : corner - 1;
  }
  const Vec3& point(int corner) const { return points[idx(vertex(corner))]; }

  // Normals of its two sides are not the same surface's.
  bool is_sharp(int corner) const {
    return mate(corner) == none || kind(corner) == EdgeKind::crease;
  }

  // Along the face's normal, of length twice its area.
  Vec3 twice_area(int face) const;
  double longest_edge(int face) const;
};

// The corner of the twin face at the twin of this corner's vertex.
int twin_corner(const RefinedMesh& mesh, int corner);

// Where corner k of a face of `size` corners lies on the face's domain, in its steps.
std::array<std::uint16_t, 2> place_on_domain(const FaceDomain& domain, int size, int k);

// Where a corner lies on the base mesh.
struct BasePlace {
  int ptex_face = none;
  Vec2 uv = Vec2::Zero();
};
BasePlace base_place(const RefinedMesh& mesh, int corner);

// The polygons of a sound mesh as they are. threads: 0 = all cores.
RefinedMesh polygonal_mesh(const SoundMesh& mesh, int threads);

}  // namespace illustrate
