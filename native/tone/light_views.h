// The views that a light has of a scene, as cameras: what it sees is lit.
#pragma once

#include <vector>

#include "tone/light.h"

namespace illustrate {

// One view for a light that is far away, six at right angles for one among the things; none for
// headlights, which see what the viewer sees, and for ambient light. Images are square, 1024 px
// wide; what lies beyond one is in the next. `seen`: the box of all that may be lit; `camera`: the
// viewer's, for side lights.
std::vector<Camera> light_views(const Light& light, const Camera& camera,
                                const Eigen::AlignedBox3d& seen);

// Whether a light shines into the direction of a point at all: spots and areas have a front.
bool shines_at(const Light& light, const Vec3& p);

}  // namespace illustrate
