// Edges that are shaded smooth and cannot be: rims of holes that a Boolean left, of lids, of walls.
//
// Who takes a mesh for samples of a smooth surface expects it to turn a little at every edge. A
// *break* is a line of edges at which the faces turn by nearly a right angle in one step, though
// the mesh has many steps where it bends as far along the line: so fine a mesh would have shown a
// rounding. What shades it smooth is that nobody said otherwise, as with all edges that modifiers
// make: the faces are what a render shows of it, and their shading is a blur. Where the mesh is as
// coarse along the line, as the edges of a smooth-shaded cube and the limbs of a low-poly figure
// are, nothing tells a rounding from a corner, unless flat ends do: those edges stay as they are
// shaded (control/folds.h).
#pragma once

#include "mesh/shading.h"

namespace illustrate {

// A line of edges that are not sharp goes on through a vertex where two of them turn by over 30
// degrees, half as far again as all others there, and nothing is sharp. It is *round* where at most
// of its edges the strip of quads across it turns the same way to both sides, at least half as far,
// as round a tube of four sides or round a cube. It breaks
// - where its faces turn by over 76 degrees on average, as the sides of a square do and of no
//   pentagon, and it has six edges or more and bends by over 60 degrees, but by less than 32 at
//   each vertex, where other edges turn by less than two fifths of it, and is not round a strip
//   of like sides (one at most twice as wide as the other): a pipe's wall is longer than thick;
// - where it is a rim of a flat ring, the end of a pipe or the lid of a nut (mesh/flat_rings.h);
// - where it turns so far and ends at both ends at creases, at other breaks or at corners of
//   blocks, where a third edge turns by over 64 and all others by less than two fifths of that, and
//   is not round;
// - where both of its ends lie at breaks and it turns so far, or by over 50 and is not round;
// - where both of its ends are corners of a polygon beside a circle in a flat ring, or the other
//   ends of the edges that stand upright on those, and it turns by over 50.
// Makes shading.corner_normals as if breaks were marked sharp: at their vertices corners of faces
// that are not flat get the mean of the faces' normals, weighted by angle, from one sharp edge to
// the next. In a cage and in a double cover none are looked for.
// edges: half_edges_by_edge's. is_sharp (edges): 1 where the input says so. Returns the number of
// breaks.
int shade_breaks(const PolygonMesh& mesh, const Faces& faces, const Ragged<int>& edges,
                 const std::vector<std::uint8_t>& is_sharp, const SoundMesh& sound,
                 Shading& shading);

}  // namespace illustrate
