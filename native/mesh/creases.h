// What is sharp of a mesh that is shown as it is shaded: creases, tips and corners.
//
// An artist sees a mesh by its shading, so what is shaded sharp is sharp: an edge is a crease where
// the corner normals of its two faces differ by more than crease_normals_deg at either end,
// whatever made them differ. Where the faces' windings disagreed in the input, normals are compared
// up to their side. Two exceptions:
// - Faces that are flat in fact were meant flat or never told otherwise (every STL, any import
//   without normals): between two of them an edge is sharp where it turns more than
//   crease_angle_deg. Of a mesh that is no cage lone bends are sharp too (mesh/lone_bends.h),
//   unless crease_angle_deg is over 30: who raises it wants fewer edges. So are tails of creases
//   (mesh/crease_tails.h), and fine bends, however they are shaded, where the mesh says how long
//   its edges may be (mesh/fine_bends.h).
// - A vertex where at least three edges differ, 60 % of those it has, that agree at their other
//   ends is a *tip* (of a cone): it is sharp, and they are smooth.
// A vertex without sharp edges whose faces all stand more than 60 degrees off their mean (of flat
// faces: more than crease_angle_deg, where that is less) is a tip too; at a smooth cube's corner
// they stand 55 degrees off.
//
// A mesh that is no cage has *corners* besides, by the angle between the two sharp or open edges at
// a vertex: a boundary that turns more than 50 degrees, a crease that turns more than 80 (a crease
// has faces on both sides that say more about it). A vertex amid a straight border is none, and a
// plane has four, however it is cut. Copies of a vertex where parts touch only there are corners,
// so that they stay together. Of flat faces so are those where an edge of more than two turns, and
// where a crease ends: made round, the faces beside it would swing round to meet in one.
#pragma once

#include "core/report.h"
#include "mesh/shading.h"

namespace illustrate {

// Whether unit normals turn by more than an angle, or by just that angle up to the rounding of
// their vertices: flat sides of a twelve-sided prism turn by 30 degrees, and all of them shall be
// told the same. Not for 180 degrees, nor for normals that agree.
bool turns_more(const Vec3& a, const Vec3& b, double angle_deg);

struct Creases {
  std::vector<std::uint8_t> sharp_edges;     // (edges) 1: infinitely sharp
  std::vector<std::uint8_t> sharp_vertices;  // (n) 1: infinitely sharp
};

// `edges`: half_edges_by_edge's. `is_sharp` (edges): 1 where the input says so. `is_cut`: Joints'.
// Counts "normal_creases", "angle_creases", "lone_bends", "crease_tails", "fine_bends", "tips",
// "corners".
Creases find_creases(const PolygonMesh& mesh, const Faces& faces, const Ragged<int>& edges,
                     const std::vector<std::uint8_t>& is_cut, std::vector<std::uint8_t> is_sharp,
                     const Shading& shading, const SoundMesh& sound, Counts& report);

}  // namespace illustrate
