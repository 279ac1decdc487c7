#include "hatch/view/resting.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/mixed_bits.h"
#include "core/parallel.h"
#include "hatch/greedy/place_hatches.h"

namespace illustrate {
namespace {

constexpr double tile_spacings = 2;
constexpr double least_tile_px = 8;

// Directions are told apart in such steps: a field that was carried along is the same but for
// rounding.
constexpr double direction_steps = 1 << 30;

// Mixes values into one number.
class Mixed {
 public:
  explicit Mixed(std::uint64_t start = 0) : number_(start) {}

  Mixed& add(std::uint64_t value) {
    number_ = mixed_bits((number_ ^ value) + mixing_step);
    return *this;
  }
  Mixed& add(double value) {
    std::uint64_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    return add(bits);
  }
  template <class Derived>
  Mixed& add(const Eigen::MatrixBase<Derived>& values) {
    for (Eigen::Index i = 0; i < values.size(); ++i) add(double(values(i)));
    return *this;
  }
  std::uint64_t number() const { return number_; }

 private:
  std::uint64_t number_;
};

// What is the same for all of a view.
std::uint64_t view_number(const HatchScene& scene, const HatchOptions& options) {
  const Camera& camera = scene.camera;
  Mixed mixed;
  mixed.add(camera.projection()).add(camera.view());
  for (const double value : {double(camera.width_px()), double(camera.height_px()),
                             scene.visible.cell_px, double(options.seeding), options.spacing_px,
                             options.undercut_spacing_px, options.test_factor, options.step_px,
                             options.max_turn_deg, options.max_length_px, options.min_length_px}) {
    mixed.add(value);
  }
  return mixed.number();
}

std::uint64_t vertex_number(const HatchScene& scene, std::size_t v) {
  Mixed mixed;
  mixed.add(scene.surface.positions[v]).add(scene.surface.normals[v]);
  mixed.add((direction_steps * scene.field.directions[v]).array().round().matrix());
  if (!scene.families.empty()) mixed.add(double(scene.families[v]));
  return mixed.number();
}

// Of the vertices of triangles that are seen; those of others are 0. A triangle is met in some rows
// of cells, and a vertex in some triangles: what it takes to tell one is mixed once.
std::vector<std::uint64_t> vertex_numbers(const HatchScene& scene, int threads) {
  std::vector<std::uint8_t> is_seen(scene.surface.positions.size(), 0);
  int last = none;
  for (const int triangle : scene.visible.triangle) {
    if (triangle == none || triangle == last) continue;
    for (const int v : scene.surface.triangles[idx(triangle)]) is_seen[idx(v)] = 1;
    last = triangle;
  }
  std::vector<std::uint64_t> numbers(is_seen.size(), 0);
  parallel_for(numbers.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      if (is_seen[v]) numbers[v] = vertex_number(scene, v);
    }
  });
  return numbers;
}

class TileMarker {
 public:
  TileMarker(const HatchScene& scene, const HatchOptions& options, int threads, ImageTiles& tiles)
      : scene_(scene), tiles_(tiles), vertices_(vertex_numbers(scene, threads)) {
    const double wanted = std::max(least_tile_px, tile_spacings * options.spacing_px);
    cells_ = std::max(1, static_cast<int>(std::ceil(wanted / scene.visible.cell_px)));
    tiles.tile_px = cells_ * scene.visible.cell_px;
    tiles.columns = (scene.visible.width + cells_ - 1) / cells_;
    tiles.rows = (scene.visible.height + cells_ - 1) / cells_;
    tiles.contents.assign(idx(tiles.columns) * idx(tiles.rows), view_number(scene, options));
  }

  // Numbers of cells and curves are added up: their order in a tile does not count.
  void add_cells(int threads) {
    parallel_for(idx(tiles_.rows), threads, [&](std::size_t begin, std::size_t end) {
      const int last = std::min(static_cast<int>(end) * cells_, scene_.visible.height);
      for (int row = static_cast<int>(begin) * cells_; row < last; ++row) add_row(row);
    });
  }

  void add_curves() {
    const LabelledGraph& graph = scene_.graph;
    for (int arc = 0; arc < static_cast<int>(graph.arcs.size()); ++arc) {
      if (layers_over(graph.arcs[idx(arc)]) != 0 || !is_critical(graph.arcs[idx(arc)].kind)) {
        continue;
      }
      const Span<const Vec2> line = graph.image[idx(arc)];
      const bool is_closed = graph.arcs[idx(arc)].start_node == none;
      for (std::size_t i = 0; i + (is_closed ? 0 : 1) < line.size(); ++i) {
        add_segment(line[i], line[(i + 1) % line.size()], graph.arcs[idx(arc)].kind);
      }
    }
  }

 private:
  std::uint64_t triangle_number(int triangle) const {
    Mixed mixed;
    const int object = scene_.surface.object_of(triangle);
    mixed.add(std::uint64_t{scene_.is_hatched(object)}).add(scene_.scale_on(triangle));
    for (const int v : scene_.surface.triangles[idx(triangle)]) mixed.add(vertices_[idx(v)]);
    return mixed.number();
  }

  void add_row(int row) {
    std::uint64_t* const contents = tiles_.contents.data() + (row / cells_) * tiles_.columns;
    int triangle = none;
    std::uint64_t number = 0;
    for (int column = 0; column < scene_.visible.width; ++column) {
      const auto cell = idx(scene_.visible.index(column, row));
      const int seen = scene_.visible.triangle[cell];
      if (seen == none) continue;
      if (seen != triangle) number = triangle_number(triangle = seen);
      const auto tone =
          std::uint64_t(scene_.tone.level[cell]) << 8 | std::uint64_t(scene_.tone.band[cell]);
      contents[column / cells_] += Mixed(number).add(std::uint64_t{cell} << 16 | tone).number();
    }
  }

  // To all tiles that it may pass: those of points a tile apart, and of its ends.
  void add_segment(const Vec2& a, const Vec2& b, Kind kind) {
    const std::uint64_t number = Mixed(std::uint64_t(kind)).add(a).add(b).number();
    const double parts = std::ceil((b - a).cwiseAbs().maxCoeff() / tiles_.tile_px);
    const auto most = static_cast<int>(std::min(parts, double(tiles_.columns + tiles_.rows)));
    int last = none;
    for (int k = 0; k <= most; ++k) {
      const int tile = tile_of(a + k / std::max(1.0, double(most)) * (b - a));
      if (tile != none && tile != last) tiles_.contents[idx(tile)] += number;
      last = tile;
    }
  }

  int tile_of(const Vec2& image) const {
    const Vec2 at = image / tiles_.tile_px;
    const bool is_inside = at.minCoeff() >= 0 && at.x() < tiles_.columns && at.y() < tiles_.rows;
    return is_inside ? static_cast<int>(at.y()) * tiles_.columns + static_cast<int>(at.x()) : none;
  }

  const HatchScene& scene_;
  ImageTiles& tiles_;
  const std::vector<std::uint64_t> vertices_;  // their numbers
  int cells_;                                  // along a tile
};

}  // namespace

ImageTiles image_tiles(const HatchScene& scene, const HatchOptions& options, int threads) {
  ImageTiles tiles;
  TileMarker marker(scene, options, threads, tiles);
  marker.add_cells(threads);
  marker.add_curves();
  return tiles;
}

RestingPlaces::RestingPlaces(const ImageTiles& last, const ImageTiles& now)
    : tile_px_(now.tile_px), columns_(now.columns), rows_(now.rows) {
  if (last.tile_px != now.tile_px || last.columns != now.columns || last.rows != now.rows) return;
  rests_.assign(now.contents.size(), 1);
  for (int tile = 0; tile < static_cast<int>(rests_.size()); ++tile) {
    if (last.contents[idx(tile)] == now.contents[idx(tile)]) continue;
    const int row = tile / columns_, column = tile % columns_;
    for (int r = std::max(row - 1, 0); r <= std::min(row + 1, rows_ - 1); ++r) {
      for (int c = std::max(column - 1, 0); c <= std::min(column + 1, columns_ - 1); ++c) {
        rests_[idx(r * columns_ + c)] = 0;
      }
    }
  }
}

bool RestingPlaces::rests(const Vec2& image) const {
  if (rests_.empty() || !(image.minCoeff() >= 0)) return false;
  const Vec2 at = image / tile_px_;
  if (!(at.x() < columns_ && at.y() < rows_)) return false;
  return rests_[idx(static_cast<int>(at.y()) * columns_ + static_cast<int>(at.x()))] != 0;
}

}  // namespace illustrate
