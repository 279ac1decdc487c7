// The two things a stage may throw.
#pragma once

#include <stdexcept>

namespace illustrate {

// Arrays of the wrong shape, indices out of range, options or cameras that cannot be used. The
// message names the argument. A mesh that is merely bad is never an error: it is mended and
// counted.
struct InvalidInput : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

// The caller's progress function asked to stop.
struct Cancelled : std::runtime_error {
  Cancelled() : std::runtime_error("cancelled") {}
};

}  // namespace illustrate
