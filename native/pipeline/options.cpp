#include "pipeline/options.h"

#include <cmath>

#include "core/errors.h"

namespace illustrate {
namespace {

void require(bool holds, const std::string& message) {
  if (!holds) throw InvalidInput(message);
}

// What styles of objects and of materials have in common.
template <class Style>
void validate_scales(const Style& style, const std::string& name) {
  require(style.spacing_scale > 0 && std::isfinite(style.spacing_scale),
          name + "spacing_scale must be above 0 and finite");
  require(style.width_scale >= 0 && std::isfinite(style.width_scale),
          name + "width_scale must be at least 0 and finite");
  require(style.pen >= 0, name + "pen must be at least 0");
}

void validate(const ObjectStyle& style, std::size_t index) {
  const std::string name = "styles[" + std::to_string(index) + "].";
  validate_scales(style, name);
  for (std::size_t i = 0; i < style.materials.size(); ++i) {
    validate_scales(style.materials[i], name + "materials[" + std::to_string(i) + "].");
  }
}

}  // namespace

void validate(const PrepareOptions& options) {
  validate(options.surface);
  validate(options.cross_field);
  require(options.jet.rings >= 1 && options.jet.rings <= 10, "rings must be in [1, 10]");
  require(options.most_intersections >= 0, "most_intersections must be at least 0");
  require(options.threads >= 0, "threads must be at least 0");
}

void validate(const DrawOptions& options, std::size_t object_count) {
  validate(options.tone);
  validate(options.hatch);
  validate(options.stroke);
  validate(options.curvature_curves);
  require(options.smallest_tone >= 0 && options.smallest_tone <= 20,
          "smallest_tone must be in [0, 20]");
  require(options.cell_px >= 0.25 && options.cell_px <= 64, "cell_px must be in [0.25, 64]");
  require(options.threads >= 0, "threads must be at least 0");
  require(options.styles.empty() || options.styles.size() == object_count,
          "styles has " + std::to_string(options.styles.size()) + " entries but there are " +
              std::to_string(object_count) + " meshes");
  for (std::size_t i = 0; i < options.styles.size(); ++i) validate(options.styles[i], i);
}

}  // namespace illustrate
