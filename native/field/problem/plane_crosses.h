// Crosses of flat faces: hatches on them are straight, along what most of their rim runs along.
#pragma once

#include "field/problem/frames.h"
#include "surface/surface.h"

namespace illustrate {

struct PlaneCrosses {
  std::vector<int> planes;  // (n) flat face that the vertex is held by, or none
  CrossNumbers z;           // (n) its cross; the given one elsewhere
};

// A flat face takes the direction that its rim asks for; of several beside each other in one plane
// the one whose rim asks over the greatest length decides for all. Where none of their rims asks
// for anything, a face that ends sharply all round takes an axis of its object: of the three that
// the face has whose rim asks over the greatest length the one that lies most in its own plane;
// else the default; one that goes on smoothly is not held, since it is the form round it that
// tells. Vertices inside are held, and those of the rim except where it goes on smoothly in another
// direction, and not in a strip of triangles less than a quarter as large. default_crosses: (n).
// `across_objects`: objects stand in one space.
PlaneCrosses plane_crosses(const Surface& surface, const TangentFrames& frames,
                           const CrossNumbers& default_crosses, bool across_objects);

// Lets go of the faces some of whose vertices are marked in `released` (n).
void release_planes(const std::vector<std::uint8_t>& released, std::vector<int>& planes);

}  // namespace illustrate
