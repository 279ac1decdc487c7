#include "surface/surface_options.h"

#include <cmath>

#include "core/errors.h"

namespace illustrate {

void validate(const SurfaceOptions& options) {
  if (options.level < -1) throw InvalidInput("level must be -1 (automatic) or at least 0");
  if (!(options.edge_length >= 0) || !std::isfinite(options.edge_length)) {
    throw InvalidInput("edge_length must be a finite number, at least 0");
  }
  if (options.triangle_budget < 0) throw InvalidInput("triangle_budget must be at least 0");
  if (options.threads < 0) throw InvalidInput("threads must be at least 0");
}

}  // namespace illustrate
