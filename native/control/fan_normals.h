// The normals that the curves of a mesh are bent by.
#pragma once

#include "control/half_edges.h"

namespace illustrate {

struct FanNormals {
  // (c) unit or zero, the same at all corners of a sector.
  // Of the faces round the vertex, weighted by area times angle, below a quarter of the largest
  // weight by its square; where flat faces (face_planes) are among them, of those alone.
  Points geometric;
  // The mean of the shading normals, or the geometric one where they disagree: the fans that flat
  // faces below the crease angle leave.
  Points shading;
};

FanNormals fan_normals(const SoundMesh& mesh, const HalfEdges& edges, const VertexSectors& sectors);

}  // namespace illustrate
