#include "contour/back_sides.h"

namespace illustrate {

std::vector<std::uint8_t> shows_back(const Surface& surface,
                                     const IntersectionCurves& intersections,
                                     const Camera& camera) {
  std::vector<std::uint8_t> shows(surface.object_is_smooth.size(), 0);
  const std::vector<Eigen::AlignedBox3d> boxes = object_boxes(surface);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const std::size_t object = idx(surface.triangle_objects[t]);
    for (const int n : surface.neighbours[t]) shows[object] |= n == none;
    shows[object] |= surface.flips[t] != 0;
  }
  for (const IntersectionPoint& p : intersections.curves.values) {
    if (p.a.triangle == none || p.b.triangle == none) continue;
    const int object = surface.object_of(p.a.triangle);
    if (object == surface.object_of(p.b.triangle)) shows[idx(object)] = 1;
  }
  // An eye inside the box is on the wrong side of the near plane too.
  for (std::size_t object = 0; object < shows.size(); ++object) {
    for (int corner = 0; corner < 8 && !boxes[object].isEmpty(); ++corner) {
      const auto type = static_cast<Eigen::AlignedBox3d::CornerType>(corner);
      if (!(camera.near_distance(boxes[object].corner(type)) > 0)) shows[object] = 1;
    }
  }
  return shows;
}

}  // namespace illustrate
