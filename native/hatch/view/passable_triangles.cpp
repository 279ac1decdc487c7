#include "hatch/view/passable_triangles.h"

#include <algorithm>
#include <limits>

namespace illustrate {
namespace {

// Triangles of a run: those of one place are near each other in a surface.
constexpr std::size_t run_length = 16;

constexpr int tile_cells = 8;

// A run that may lie in more tiles is not looked at: it costs more than it saves.
constexpr int most_tiles = 1024;

constexpr double infinite = std::numeric_limits<double>::infinity();

// Squares of cells: how deep the farthest cell of each is, less than anything where no cell of it
// is wanted.
class DepthTiles {
 public:
  DepthTiles(const HatchScene& scene, Area area)
      : visible_(scene.visible),
        columns_((visible_.width + tile_cells - 1) / tile_cells),
        rows_((visible_.height + tile_cells - 1) / tile_cells),
        farthest_(idx(columns_) * idx(rows_), -infinite) {
    const HatchArea asked(scene);
    std::vector<std::uint8_t> is_wanted(farthest_.size(), 0);
    for (int row = 0; row < visible_.height; ++row) {
      for (int column = 0; column < visible_.width; ++column) {
        const std::size_t tile = this->tile(column, row);
        const int cell = visible_.index(column, row);
        farthest_[tile] = std::max(farthest_[tile], visible_.depth[idx(cell)]);
        if (!is_wanted[tile]) is_wanted[tile] = asked.wanted(cell, area);
      }
    }
    for (std::size_t tile = 0; tile < farthest_.size(); ++tile) {
      if (!is_wanted[tile]) farthest_[tile] = -infinite;
    }
  }

  // Whether something at this depth may pass in a box of the image, or in the cells around it.
  bool may_pass(const Vec2& low, const Vec2& high, double depth) const {
    if (low.x() > visible_.width * visible_.cell_px ||
        low.y() > visible_.height * visible_.cell_px || high.x() < 0 || high.y() < 0) {
      return false;
    }
    const int left = clamped(low.x() - visible_.cell_px, visible_.width);
    const int right = clamped(high.x() + visible_.cell_px, visible_.width);
    const int top = clamped(low.y() - visible_.cell_px, visible_.height);
    const int bottom = clamped(high.y() + visible_.cell_px, visible_.height);
    const int across = right / tile_cells - left / tile_cells + 1;
    const int down = bottom / tile_cells - top / tile_cells + 1;
    if (std::int64_t{across} * down > most_tiles) return true;
    for (int row = top / tile_cells; row <= bottom / tile_cells; ++row) {
      for (int column = left / tile_cells; column <= right / tile_cells; ++column) {
        if (depth <= farthest_[idx(row) * idx(columns_) + idx(column)]) return true;
      }
    }
    return false;
  }

 private:
  std::size_t tile(int column, int row) const {
    return idx(row / tile_cells) * idx(columns_) + idx(column / tile_cells);
  }
  // The cell of a coordinate, the nearest where it is out of the frame.
  int clamped(double px, int cells) const {
    return static_cast<int>(std::clamp(px / visible_.cell_px, 0.0, cells - 1.0));
  }

  const VisibleImage& visible_;
  int columns_, rows_;
  std::vector<double> farthest_;
};

// A vertex in the image. Its depth is the least at which something there is still seen beside what
// lies before it (HatchArea::is_seen_at): what lies between vertices is not less deep.
struct SeenVertex {
  Vec2 image;
  double depth;  // -infinity: behind the near plane, with an image that says nothing
};

std::vector<SeenVertex> seen_vertices(const HatchScene& scene) {
  const HatchArea area(scene);
  const ImageMap map = image_map(scene.camera);
  std::vector<SeenVertex> vertices;
  vertices.reserve(scene.surface.positions.size());
  for (const Vec3& p : scene.surface.positions) {
    const Vec3 mapped = apply(map, p);
    const bool is_before = scene.camera.near_distance(p) > 0 && mapped[2] > 0;
    const double margin = scene.visible.cell_px * area.pixel_size(mapped);
    vertices.push_back(
        {mapped.head<2>() / mapped[2], is_before ? scene.camera.depth(p) - margin : -infinite});
  }
  return vertices;
}

}  // namespace

std::vector<std::uint8_t> passable_triangles(const HatchScene& scene, Area area) {
  const std::vector<Triangle>& triangles = scene.surface.triangles;
  const DepthTiles tiles(scene, area);
  const std::vector<SeenVertex> vertices = seen_vertices(scene);
  std::vector<std::uint8_t> passable(triangles.size(), 1);
  for (std::size_t first = 0; first < triangles.size(); first += run_length) {
    const std::size_t end = std::min(first + run_length, triangles.size());
    Vec2 low = Vec2::Constant(infinite), high = -low;
    double depth = infinite;
    for (std::size_t t = first; t < end; ++t) {
      for (const int corner : triangles[t]) {
        const SeenVertex& vertex = vertices[idx(corner)];
        low = low.cwiseMin(vertex.image);
        high = high.cwiseMax(vertex.image);
        depth = std::min(depth, vertex.depth);
      }
    }
    const bool may_pass = depth == -infinite || tiles.may_pass(low, high, depth);
    std::fill(passable.begin() + std::ptrdiff_t(first), passable.begin() + std::ptrdiff_t(end),
              may_pass);
  }
  return passable;
}

}  // namespace illustrate
