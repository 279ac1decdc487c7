#include "occlusion/visible_image.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/errors.h"
#include "core/parallel.h"
#include "core/prefetch.h"
#include "core/ragged.h"
#include "view/image_map.h"

namespace illustrate {
namespace {

// A vertex on the grid of cells. p and q are depth / w and 1 / w: both are linear across the image.
struct GridVertex {
  double x, y, depth, p, q;
  double near_distance;
};

// Before the near plane.
bool is_before(const GridVertex& vertex) { return vertex.near_distance > 0; }

struct Projector {
  Projector(const Camera& view, double size) : camera(view), map(image_map(view)), cell_px(size) {}

  GridVertex operator()(const Vec3& position) const {
    const Vec3 h = apply(map, position);
    const double depth = camera.depth(position);
    const double scale = 1 / (h[2] * cell_px);
    return {h[0] * scale, h[1] * scale, depth,
            depth / h[2], 1 / h[2],     camera.near_distance(position)};
  }

  const Camera& camera;
  ImageMap map;
  double cell_px;
};

// Twice the signed area of (a, b, point), times `side`. Both triangles at an edge get the same
// number but for its sign, so no cell centre falls between them.
struct EdgeFunction {
  EdgeFunction(const GridVertex& a, const GridVertex& b, double side) {
    const bool swapped = b.x < a.x || (b.x == a.x && b.y < a.y);
    const GridVertex& low = swapped ? b : a;
    const GridVertex& high = swapped ? a : b;
    const double sign = swapped ? -side : side;
    x0 = low.x, y0 = low.y;
    run_x = sign * (high.x - low.x), run_y = sign * (high.y - low.y);
  }

  double operator()(double x, double y) const { return in_row(y)(x); }

  // The same for one row.
  struct Row {
    double operator()(double x) const { return start - run_y * (x - x0); }
    double start, run_y, x0;
  };
  Row in_row(double y) const { return {run_x * (y - y0), run_y, x0}; }

  double x0, y0, run_x, run_y;
};

// The first and one past the last cell whose centre lies in [low, high], within [begin, end).
std::pair<int, int> cells_between(double low, double high, int begin, int end) {
  const double from = std::clamp(low - 0.5, double(begin), double(end));
  const double to = std::clamp(high - 0.5, begin - 1.0, end - 1.0);
  const int first = static_cast<int>(from), last = static_cast<int>(to);
  return {first < from ? first + 1 : first, last > to ? last : last + 1};
}

// Rows [row_begin, row_end) of the image, triangle by triangle; of equal depths the first triangle
// stays.
class RowPainter {
 public:
  RowPainter(VisibleImage& image, int row_begin, int row_end)
      : image_(image), row_begin_(row_begin), row_end_(row_end) {}

  void draw(int triangle, const GridVertex& a, const GridVertex& b, const GridVertex& c) {
    const auto [low_y, high_y] = std::minmax({a.y, b.y, c.y});
    const auto [row, row_end] = cells_between(low_y, high_y, row_begin_, row_end_);
    if (!(row < row_end)) return;
    const auto [low_x, high_x] = std::minmax({a.x, b.x, c.x});
    const auto [column, column_end] = cells_between(low_x, high_x, 0, image_.width);
    if (!(column < column_end)) return;
    const double area = EdgeFunction(a, b, 1)(c.x, c.y);
    if (area == 0 || !std::isfinite(area)) return;
    const double side = area > 0 ? 1 : -1;
    const EdgeFunction bc(b, c, side), ca(c, a, side), ab(a, b, side);
    const auto [nearest, farthest] = std::minmax({a.depth, b.depth, c.depth});
    for (int j = row; j < row_end; ++j) {
      const EdgeFunction::Row row_bc = bc.in_row(j + 0.5), row_ca = ca.in_row(j + 0.5),
                              row_ab = ab.in_row(j + 0.5);
      bool was_inside = false;
      for (int i = column; i < column_end; ++i) {
        const double x = i + 0.5, wa = row_bc(x), wb = row_ca(x), wc = row_ab(x);
        if (!(wa >= 0 && wb >= 0 && wc >= 0)) {
          // A triangle is convex: after the first gap nothing of the row is inside.
          if (was_inside) break;
          continue;
        }
        was_inside = true;
        // Seen along its plane a triangle's depth is rounding; it stays between those of the
        // corners.
        const double depth = (wa * a.p + wb * b.p + wc * c.p) / (wa * a.q + wb * b.q + wc * c.q);
        draw_cell(triangle, std::clamp(depth, nearest, farthest), image_.index(i, j));
      }
    }
  }

 private:
  void draw_cell(int triangle, double depth, int cell) {
    if (!(depth < image_.depth[cell])) return;
    image_.depth[cell] = depth;
    image_.triangle[cell] = triangle;
  }

  VisibleImage& image_;
  int row_begin_, row_end_;
};

// The part of a triangle before the near plane, as a fan. At most four corners.
void draw_clipped(RowPainter& painter, const Projector& project, const Surface& surface,
                  int triangle, const std::array<const GridVertex*, 3>& corners) {
  std::array<GridVertex, 4> kept;
  int count = 0;
  for (int k = 0; k < 3; ++k) {
    const GridVertex& a = *corners[k];
    const GridVertex& b = *corners[next_corner(k)];
    if (is_before(a)) kept[count++] = a;
    if (is_before(a) == is_before(b)) continue;
    const double t = a.near_distance / (a.near_distance - b.near_distance);
    const Vec3& from = surface.positions[surface.triangles[triangle][k]];
    const Vec3& to = surface.positions[surface.triangles[triangle][next_corner(k)]];
    kept[count++] = project(from + t * (to - from));
  }
  for (int k = 2; k < count; ++k) painter.draw(triangle, kept[0], kept[k - 1], kept[k]);
}

void draw_triangle(RowPainter& painter, const Projector& project, const Surface& surface,
                   const std::vector<GridVertex>& vertices, int triangle) {
  const Triangle& corner = surface.triangles[triangle];
  const GridVertex& a = vertices[corner[0]];
  const GridVertex& b = vertices[corner[1]];
  const GridVertex& c = vertices[corner[2]];
  if (is_before(a) && is_before(b) && is_before(c)) {
    painter.draw(triangle, a, b, c);
  } else {
    draw_clipped(painter, project, surface, triangle, {&a, &b, &c});
  }
}

void draw_all(RowPainter& painter, const Projector& project, const Surface& surface,
              const std::vector<GridVertex>& vertices, Span<const int> triangles) {
  constexpr std::size_t ahead = 12;
  const std::size_t count = triangles.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (i + 2 * ahead < count) prefetch(&surface.triangles[idx(triangles[i + 2 * ahead])]);
    if (i + ahead < count) {
      for (const int vertex : surface.triangles[idx(triangles[i + ahead])]) {
        prefetch(&vertices[idx(vertex)]);
      }
    }
    draw_triangle(painter, project, surface, vertices, triangles[i]);
  }
}

// Consecutive rows, so many that their cells stay in the cache of a core.
struct Bands {
  explicit Bands(const VisibleImage& image)
      : height(image.height),
        rows(std::max(1, cells_of_band / std::max(1, image.width))),
        count((height + rows - 1) / rows) {}

  static constexpr int cells_of_band = 1 << 14;
  int height, rows, count;
};

// Of a triangle, [first, end): all those that it may be seen in. None: no area, or behind the eye.
std::pair<int, int> reached(const Bands& bands, const GridVertex& a, const GridVertex& b,
                            const GridVertex& c) {
  const int before = is_before(a) + is_before(b) + is_before(c);
  if (before == 0) return {0, 0};
  if (before < 3) return {0, bands.count};  // it is clipped later
  const auto [low, high] = std::minmax({a.y, b.y, c.y});
  const auto [row, row_end] = cells_between(low, high, 0, bands.height);
  if (!(row < row_end)) return {0, 0};
  return {row / bands.rows, (row_end - 1) / bands.rows + 1};
}

// The triangles of each band, in order.
Ragged<int> triangles_of(const Bands& bands, const Surface& surface,
                         const std::vector<GridVertex>& vertices,
                         const std::vector<std::uint8_t>& hidden, int threads) {
  std::vector<std::pair<int, int>> of_triangle(surface.triangles.size());
  parallel_for(of_triangle.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      if (surface.is_of(hidden, static_cast<int>(t))) continue;
      const Triangle& corner = surface.triangles[t];
      of_triangle[t] =
          reached(bands, vertices[corner[0]], vertices[corner[1]], vertices[corner[2]]);
    }
  });
  return sorted_into<int>(idx(bands.count), [&](const auto& put) {
    for (std::size_t t = 0; t < of_triangle.size(); ++t) {
      const auto [first, end] = of_triangle[t];
      for (int band = first; band < end; ++band) put(band, static_cast<int>(t));
    }
  });
}

}  // namespace

int VisibleImage::cell_of(const Vec2& image) const {
  const double column = image.x() / cell_px, row = image.y() / cell_px;
  if (!(column >= 0 && row >= 0 && column < width && row < height)) return none;
  return index(static_cast<int>(column), static_cast<int>(row));
}

VisibleImage render_visible(const Surface& surface, const Camera& camera, double cell_px,
                            const std::vector<std::uint8_t>& hidden, int threads) {
  if (!(cell_px >= 0.25 && std::isfinite(cell_px))) {
    throw InvalidInput("cell_px must be finite and at least 0.25");
  }
  if (!hidden.empty() && hidden.size() != surface.object_is_smooth.size()) {
    throw InvalidInput("hidden must have one entry per object");
  }
  VisibleImage image;
  image.width = static_cast<int>(std::ceil(camera.width_px() / cell_px));
  image.height = static_cast<int>(std::ceil(camera.height_px() / cell_px));
  image.cell_px = cell_px;
  const std::size_t cells = idx(image.width) * image.height;
  image.triangle.assign(cells, none);
  image.depth.assign(cells, std::numeric_limits<double>::infinity());

  const Projector project(camera, cell_px);
  std::vector<GridVertex> vertices(surface.positions.size());
  parallel_for(vertices.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) vertices[i] = project(surface.positions[i]);
  });
  // Each band takes its triangles in one order, and has cells of its own: the image is the same for
  // any number of threads.
  const Bands bands(image);
  const Ragged<int> triangles = triangles_of(bands, surface, vertices, hidden, threads);
  parallel_each(idx(bands.count), threads, {}, [&](std::size_t band) {
    const int row = static_cast<int>(band) * bands.rows;
    RowPainter painter(image, row, std::min(row + bands.rows, image.height));
    draw_all(painter, project, surface, vertices, triangles[band]);
  });
  return image;
}

SurfacePoint surface_point_under(const Surface& surface, const Camera& camera, int triangle,
                                 const Vec2& image) {
  return surface_point_under(surface, image_map(camera), triangle, image);
}

SurfacePoint surface_point_under(const Surface& surface, const ImageMap& map, int triangle,
                                 const Vec2& image) {
  std::array<Vec3, 3> mapped;
  for (int k = 0; k < 3; ++k) {
    mapped[k] = apply(map, surface.positions[surface.triangles[triangle][k]]);
  }
  return surface_point_under(mapped, triangle, image);
}

SurfacePoint surface_point_under(const std::array<Vec3, 3>& mapped, int triangle,
                                 const Vec2& image) {
  Vec2 edge[3];
  for (int k = 0; k < 3; ++k) edge[k] = mapped[k].head<2>() - mapped[k][2] * image;
  double weight[3];
  for (int k = 0; k < 3; ++k) {
    const Vec2& a = edge[next_corner(k)];
    const Vec2& b = edge[previous_corner(k)];
    weight[k] = a.x() * b.y() - a.y() * b.x();
  }
  const double total = weight[0] + weight[1] + weight[2];
  if (total == 0 || !std::isfinite(1 / total)) return {triangle, 1 / 3.0, 1 / 3.0};
  for (double& w : weight) w = std::max(0.0, w / total);
  const double sum = weight[0] + weight[1] + weight[2];
  return {triangle, weight[1] / sum, weight[2] / sum};
}

}  // namespace illustrate
