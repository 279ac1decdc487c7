#include "hatch/small_parts.h"

#include <algorithm>
#include <limits>

namespace illustrate {
namespace {

constexpr double large_part = 16;  // spacings

}  // namespace

SmallParts::SmallParts(const Surface& surface, const SurfaceParts& parts, const Camera& camera)
    : surface_(surface), parts_(parts) {
  constexpr double unknown = std::numeric_limits<double>::infinity();
  for (std::size_t part = 0; part < parts.diagonals.size(); ++part) {
    const double pixel = camera.pixel_size(parts.middles[part]), size = parts.diagonals[part];
    size_px_.push_back(pixel > 0 ? size / pixel : unknown);
    width_px_.push_back(pixel > 0 && size > 0 ? parts.areas[part] / (2 * size * pixel) : unknown);
  }
}

std::vector<float> SmallParts::finer(const std::vector<double>& of_objects,
                                     const HatchOptions& options) const {
  std::vector<float> scales(surface_.triangles.size());
  for (std::size_t t = 0; t < scales.size(); ++t) {
    const double asked = of_objects.empty() ? 1 : of_objects[idx(surface_.triangle_objects[t])];
    const double spacing = asked * options.spacing_px;
    const double least = std::min(1.0, options.least_spacing_px / spacing);
    const double size = size_px_[idx(parts_.of_triangle[t])] / (large_part * spacing);
    scales[t] = static_cast<float>(asked * std::clamp(size, least, 1.0));
  }
  const bool is_any = std::any_of(scales.begin(), scales.end(), [](float s) { return s != 1; });
  return is_any ? scales : std::vector<float>();
}

std::vector<std::uint8_t> SmallParts::too_narrow(const std::vector<float>& scales,
                                                 const HatchOptions& options) const {
  std::vector<std::uint8_t> narrow(surface_.triangles.size());
  for (std::size_t t = 0; t < narrow.size(); ++t) {
    const double scale = scales.empty() ? 1 : double(scales[t]);
    narrow[t] = width_px_[idx(parts_.of_triangle[t])] < scale * options.spacing_px;
  }
  const bool is_any = std::count(narrow.begin(), narrow.end(), 1) > 0;
  return is_any ? narrow : std::vector<std::uint8_t>();
}

}  // namespace illustrate
