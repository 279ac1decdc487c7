#include "hatch/small_objects.h"

#include <algorithm>
#include <limits>

namespace illustrate {
namespace {

constexpr double large_object = 16;  // spacings

}  // namespace

SmallObjects::SmallObjects(const Surface& surface, const Camera& camera) {
  const std::vector<Eigen::AlignedBox3d> boxes = object_boxes(surface);
  for (std::size_t object = 0; object < boxes.size(); ++object) {
    const double pixel = boxes[object].isEmpty() ? 0 : camera.pixel_size(boxes[object].center());
    size_px_.push_back(pixel > 0 ? surface.object_diagonals[object] / pixel
                                 : std::numeric_limits<double>::infinity());
  }
}

std::vector<double> SmallObjects::finer(std::vector<double> scales,
                                        const HatchOptions& options) const {
  scales.resize(size_px_.size(), 1);
  for (std::size_t object = 0; object < scales.size(); ++object) {
    const double spacing = scales[object] * options.spacing_px;
    const double least = std::min(1.0, options.least_spacing_px / spacing);
    scales[object] *= std::clamp(size_px_[object] / (large_object * spacing), least, 1.0);
  }
  return scales;
}

}  // namespace illustrate
