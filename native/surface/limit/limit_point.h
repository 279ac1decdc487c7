// The limit surface and its derivatives in the coordinates of a ptex face.
#pragma once

#include "core/types.h"

namespace illustrate {

struct LimitPoint {
  Vec3 position, du, dv, duu, duv, dvv;
};

}  // namespace illustrate
