// A sun for tests.
#pragma once

#include "tone/light.h"

namespace illustrate {

inline Light sun(const Vec3& towards) {
  Light light;
  light.kind = LightKind::sun;
  light.vector = towards;
  return light;
}

}  // namespace illustrate
