// Stage `mesh`: any polygon mesh in, a sound one out (not in the paper, which
// assumes sound input).
//
// After it every edge has one or two faces, every vertex one fan, faces on both sides of an edge
// run along it in opposite directions, positions are finite, no face repeats a vertex. Nothing is
// thrown for a bad mesh; each repair is counted.
//
// Order: vertices that are not finite are dropped with their faces; repeated corners go, faces that
// come to a vertex twice are taken apart, faces with fewer than three corners go; duplicate faces
// go (the first stays, whatever the winding); positions on open edges that are the same to within
// rounding are welded, and where the mesh is no cage the two sides of gaps (mesh/gaps.h) and the
// ends of edges without length; edges with more than two faces and vertices with more than one fan
// are split (the new open edges are `seams`: never drawn, smooth across); winding is made
// consistent by flood fill; closed parts of negative volume are turned outward; parts that cannot
// be oriented become their orientation double cover. Faces and vertices of large meshes whose
// neighbours are scattered in memory get another order (mesh/memory_order.h).
#pragma once

#include "core/progress.h"
#include "core/similarity.h"
#include "mesh/polygon_mesh.h"

namespace illustrate {

// A manifold, consistently oriented polygon mesh.
struct SoundMesh {
  Points positions;             // (n)
  std::vector<int> face_sizes;  // (f) all >= 3
  std::vector<int> corner_vertices;
  std::vector<int> source_faces;       // (f) face of the input; its parts share it
  std::vector<int> source_vertices;    // (n) vertex of the input, else a number of its own or none;
                                       // copies of a split vertex share it
  std::vector<Edge> edge_vertices;     // (e) sharp edges, the crease angle's included
  std::vector<double> edge_sharpness;  // (e) > 0
  std::vector<double> vertex_sharpness;  // (n)
  std::vector<Edge> marked_edges;        // (m)
  std::vector<Edge> seams;  // (s) open edges made by splitting, as their face runs along them
  Points corner_normals;    // (c) unit, on the side of their face; empty: not asked for (creases.h)
  std::vector<int> face_materials;  // (f)
  std::vector<int>
      face_planes;  // (f) flat face (surface/planes/plane_faces.h); empty: not looked for
  std::vector<std::uint8_t> holes;  // (f) 1: shapes the limit, is not there
  // Orientation double cover: the same face (vertex) on the other sheet; `none` where the part is
  // orientable.
  std::vector<int> twin_faces;     // (f)
  std::vector<int> twin_vertices;  // (n)
  std::vector<std::uint8_t> kept;  // (f) 1: drawn; of a face and its twin exactly one is kept
  bool cage = true;                // the control mesh of a surface; else the surface keeps to it
  BoundaryRule boundary = BoundaryRule::corners;
  std::optional<Scheme> scheme;
  std::optional<int> level;
  std::optional<double> edge_length;
  std::vector<Similarity> placements;  // of the objects that share it; empty: one, as it is
  std::string name;
};

// Counts of every repair are added to `report` under plain names, all present, most of them 0.
// Every face of the input is kept or dropped for one reason:
//   input_faces = kept_faces + nan_faces (at a vertex that is not finite) + degenerate_faces (no
//   three different corners) + huge_faces (more than 65535 corners) + duplicate_faces.
// Mended: nan_vertices, repeated_corners, split_faces (kept in parts), welded_vertices,
//   closed_gaps (pairs of edges), junctions (vertices that an open edge was divided at),
//   isolated_vertices, split_edges, split_vertices (copies made), flipped_faces (against the
//   majority of their part), turned_parts, covered_parts, ignored_creases (sharpness that is not a
//   number or of no edge), ignored_marks (of no edge), empty_meshes (without a face left).
// Found, not mended: parts, polygons (faces of more than four corners), open_edges (boundaries,
//   not seams). Made sharp: angle_creases and normal_creases (edges; of these breaks:
//   mesh/breaks.h), lone_bends and fine_bends (edges: mesh/lone_bends.h, mesh/fine_bends.h), tips
//   and corners (vertices) (mesh/creases.h).
// Throws InvalidInput as `validate` does, and Cancelled through `progress`.
SoundMesh sanitize(const PolygonMesh& mesh, Counts& report, const Progress& progress = {});

}  // namespace illustrate
