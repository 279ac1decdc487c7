// Points of a mesh split once, on curves through its vertices.
//
// The idea is PN triangles' (Vlachos et al. 2001): an edge leaves its ends across their normals.
// The point in its middle stands off its chord by a *sag*, here that of a circular arc, so that
// points of circles and spheres are exact. Two sags are known for a smooth edge, one from the
// shading normals, one from the normals of the faces round its ends: the lesser is taken, none
// where they point to different sides. Following the shading alone pillows flat roofs, whose
// shading tilts beside unweighted bevels; following the faces alone rounds what is shaded flat.
// Each is the harmonic mean of those at its ends, so that what is level stays level up to where it
// bends; where an end is on a crease or a border the arithmetic one, since the normals there end
// with the fan and say little about the edges that leave it. A long edge does not take part in a
// turn that the surface makes within a short way behind its end, as fillets do where they meet.
#pragma once

#include "control/fan_normals.h"

namespace illustrate {

// In the order of split_once: the vertices as they are; the middles of edges with their sags, at
// most a fifth of the edge; the middles of faces, off their corners' mean by as much as a sphere
// would be that their edges lie on. A sharp edge is bent between its ends' tangents, which run
// along the chord over the vertex, from one neighbour on the crease to the other; where that would
// turn a piece of a face beside it over, half as far at most, but along seams. An edge more than
// four times as long as the one behind its end takes less and less part in the turn there, and none
// where it is sixteen times as long, so that a long straight one beside a short bevel stays
// straight.
// Where a crease ends or has a corner its edge leaves straight. A smooth edge to a tip is bent by
// its other end alone.
Points bent_points(const SoundMesh& parent, const HalfEdges& edges, const VertexSectors& sectors,
                   Scheme scheme);

}  // namespace illustrate
