// What is seen at each cell of a grid over the image: the nearest triangle, and where on it.
#pragma once

#include "surface/surface.h"
#include "view/camera.h"
#include "view/image_map.h"

namespace illustrate {

// Sampled at the cells' centres. cell (column, row) covers [column, column + 1) x [row, row + 1)
// times cell_px.
struct VisibleImage {
  int width = 0;
  int height = 0;
  double cell_px = 1;
  std::vector<int> triangle;  // (height * width), none where nothing is seen
  std::vector<double> depth;  // infinity where nothing is seen

  int index(int column, int row) const { return row * width + column; }
  // The cell of an image point, none outside the frame.
  int cell_of(const Vec2& image) const;
};

// Triangles that cross the near plane are clipped at it. `hidden`: objects that are left out
// (empty: none).
VisibleImage render_visible(const Surface& surface, const Camera& camera, double cell_px,
                            const std::vector<std::uint8_t>& hidden, int threads);

// The point of `triangle` under an image point (clamped to the triangle).
SurfacePoint surface_point_under(const Surface& surface, const Camera& camera, int triangle,
                                 const Vec2& image);
SurfacePoint surface_point_under(const Surface& surface, const ImageMap& map, int triangle,
                                 const Vec2& image);
// The same, given where the map takes the triangle's corners.
SurfacePoint surface_point_under(const std::array<Vec3, 3>& mapped, int triangle,
                                 const Vec2& image);

}  // namespace illustrate
