// Limit positions, tangents and second derivatives at a vertex from the control points around it
// (paper section 3 and appendix A).
#pragma once

#include "surface/limit/limit_point.h"
#include "surface/subdivision/refined_mesh.h"
#include "surface/subdivision/sectors.h"
#include "surface/subdivision/subdivision.h"

namespace illustrate {

// How the surface is defined at a vertex: by all points around it, by a curve of two sharp or open
// edges, or by itself.
enum class VertexRule : std::uint8_t { smooth, crease, corner };

// The control points of one sector of a vertex, counter-clockwise.
struct Ring {
  Vec3 centre = Vec3::Zero();
  std::vector<Vec3> edges;  // ends of the edges: as many as faces, one more in an open sector
  std::vector<Vec3> faces;  // opposite corners of quads, between edges i and i + 1; else empty
  bool closed = false;
  VertexRule rule = VertexRule::smooth;

  std::size_t face_count() const { return closed ? edges.size() : edges.size() - 1; }
};

// Reuses the memory of `ring`. False where a face around is no triangle (Loop) or no quad
// (Catmull-Clark).
bool read_ring(const RefinedMesh& mesh, const Sectors& sectors, int sector, Ring& ring);

Vec3 limit_position(const Ring& ring);

// Unit, and zero where the surface has no normal: edges no longer than `least` have no direction.
Vec3 limit_normal(const Ring& ring, double least);

// Limit position and first and second derivatives where closed forms exist: in smooth rings, and in
// open ones that are regular, which are completed by reflection. In regular rings these are the
// derivatives of the limit surface, elsewhere those of the least-squares quadric of appendix A with
// a0 at the limit position. False where there is none.
//
// Appendix A is stated for triangles. For quads the points are fitted where Catmull-Clark's
// characteristic map has them, with the weights of the limit position: at valence 4 this gives the
// derivatives of the bicubic spline, and at any valence the tangents of the limit surface.
bool fit_derivatives(const Ring& ring, LimitPoint& point);

// Whether the fit is exact (and appendix A not needed).
bool is_regular(const Ring& ring);

}  // namespace illustrate
