// Which way along a curve.
#pragma once

#include <cstdint>

namespace illustrate {

enum class Direction : std::uint8_t { backward, forward };

constexpr Direction opposite(Direction direction) {
  return direction == Direction::forward ? Direction::backward : Direction::forward;
}

}  // namespace illustrate
