// Where a mesh is much coarser than most of it: a smooth torso beside its fingers.
//
// Levels go by the median edge (levels.h), which says nothing of faces many times as large. Where
// the surface bends over them, a chord would show.
#pragma once

#include "mesh/sanitize.h"

namespace illustrate {

// Of a length beside the median edge. Twice as much is what triangles of one size differ by.
constexpr bool is_coarse(double length, double median) { return length > 3 * median; }

// Of the length of all edges. A few large faces, as a hole is closed with, are not worth four times
// the triangles of all.
constexpr double ignored_coarse_share = 0.02;

// The level on which chords over coarse bends stay within an eighth of `longest`, the longest edge
// wanted, of their arcs; 0 where there are none. A bend is a smooth edge between two faces. It is
// coarse where the faces reach so far from it beside `median`, the median edge. What the surface
// keeps to the mesh as a fold (control/folds.h) asks for one level, on which folds are made; and so
// does, where the mesh is no cage, a bend whose edge is itself that long and longer than `longest`,
// as those along a rounding are: the limit would slide along it, where from the first level on the
// surface keeps to the mesh (control/slides.h). In units of the mesh. At most `highest`.
int level_for_coarse_bends(const SoundMesh& mesh, double median, double longest, int highest);

}  // namespace illustrate
