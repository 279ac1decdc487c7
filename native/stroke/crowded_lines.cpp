#include "stroke/crowded_lines.h"

#include <algorithm>
#include <cmath>

#include "stroke/even_widths.h"

namespace illustrate {
namespace {

// Of the paper that lines may cover: parallel ones do where the gaps between them are one and a
// half of their widths. With half of it lines would thin out that are four widths apart, as in any
// door frame; with double, only where gaps are a quarter of a width, which pens and pixels close.
constexpr double readable_share = 0.4;

// No line is thinner than this share of its width: a hair that can still be printed.
constexpr double least_width = 0.2;

constexpr int cells_in_reach = 2;  // four take a millisecond more and look the same
constexpr double aside_cells = 1;  // from a line to its two sides

// A short piece of a path.
struct Piece {
  Vec2 middle, along;
  double width;
};

// Calls visit(piece) for the pieces of a path (piece_count).
template <class Visit>
void each_piece(const StrokePath& path, double step_px, const Visit& visit) {
  const std::size_t count = path.points.size();
  for (std::size_t i = path.closed ? 0 : 1; i < count; ++i) {
    const StrokePoint &a = path.points[i == 0 ? count - 1 : i - 1], &b = path.points[i];
    const Vec2 whole = b.image - a.image;
    const double pieces = piece_count(whole, step_px);
    for (int k = 0; k < pieces; ++k) {
      const double at = (k + 0.5) / pieces;
      visit(Piece{a.image + at * whole, whole / pieces, a.width + at * (b.width - a.width)});
    }
  }
}

// How much ink there is round each place of an image.
class InkMap {
 public:
  InkMap(const Camera& camera, double reach_px)
      : cell_px_(reach_px / cells_in_reach),
        columns_(cell_count(camera.width_px())),
        rows_(cell_count(camera.height_px())),
        ink_(idx(columns_) * idx(rows_), 0) {}

  double cell_px() const { return cell_px_; }

  void add(const Piece& piece) {
    const double ink = piece.along.norm() * piece.width / (cell_px_ * cell_px_);
    each_cell_round(piece.middle, [&](std::size_t cell, double share) {
      ink_[cell] += static_cast<float>(share * ink);
    });
  }

  // Spreads ink over the reach: evenly in either direction, twice. What runs over an edge of the
  // map is beyond what is seen.
  void spread() {
    for (int time = 0; time < 2; ++time) {
      smooth(1);
      smooth(idx(columns_));
    }
  }

  double share_at(const Vec2& image) const {
    double sum = 0;
    each_cell_round(image, [&](std::size_t cell, double share) {
      sum += share * static_cast<double>(ink_[cell]);
    });
    return sum;
  }

 private:
  // Up to the reach beyond the frame, where lines are not seen but count.
  int cell_count(double size_px) const {
    return static_cast<int>(std::ceil(size_px / cell_px_)) + 2 * cells_in_reach + 1;
  }

  // Calls visit(cell, share) for the four cells whose middles are round a place, in the map.
  template <class Visit>
  void each_cell_round(const Vec2& image, const Visit& visit) const {
    const double x = image.x() / cell_px_ + cells_in_reach - 0.5;
    const double y = image.y() / cell_px_ + cells_in_reach - 0.5;
    if (!(x >= 0 && y >= 0 && x < columns_ - 1 && y < rows_ - 1)) return;
    const auto column = static_cast<std::size_t>(x), row = static_cast<std::size_t>(y);
    const double s = x - std::floor(x), t = y - std::floor(y);
    const std::size_t first = row * idx(columns_) + column;
    visit(first, (1 - s) * (1 - t));
    visit(first + 1, s * (1 - t));
    visit(first + idx(columns_), (1 - s) * t);
    visit(first + idx(columns_) + 1, s * t);
  }

  // Each cell the mean of itself and those `step` before and behind it.
  void smooth(std::size_t step) {
    std::vector<float> before(ink_.begin(), ink_.begin() + static_cast<std::ptrdiff_t>(step));
    for (std::size_t cell = 0, last = ink_.size() - step, k = 0; cell < last; ++cell) {
      const float own = ink_[cell];
      ink_[cell] = (before[k] + own + ink_[cell + step]) / 3;
      before[k] = own;
      if (++k == step) k = 0;
    }
  }

  double cell_px_;
  int columns_, rows_;
  std::vector<float> ink_;  // (rows * columns) share of the cell
};

// On the emptier of both sides of a line.
double crowding(const Vec2& image, const Vec2& along, const InkMap& ink) {
  const Vec2 aside = aside_cells * ink.cell_px() * Vec2(-along.y(), along.x()).stableNormalized();
  return std::min(ink.share_at(image + aside), ink.share_at(image - aside));
}

bool is_crowded(const StrokePath& path, const InkMap& ink) {
  bool any = false;
  each_piece(path, ink.cell_px(), [&](const Piece& piece) {
    any = any || crowding(piece.middle, piece.along, ink) > readable_share;
  });
  return any;
}

double crowding(const StrokePath& path, std::size_t i, const InkMap& ink) {
  const std::size_t count = path.points.size(), last = count - 1;
  const std::size_t before = i > 0 ? i - 1 : path.closed ? last : 0;
  const std::size_t after = i < last ? i + 1 : path.closed ? 0 : last;
  return crowding(path.points[i].image, path.points[after].image - path.points[before].image, ink);
}

StrokePath thinned(const StrokePath& path, const InkMap& ink, double share, const Camera& camera) {
  StrokePath close = with_close_points(path, ink.cell_px(), camera);
  std::vector<double> factors;
  for (std::size_t i = 0; i < close.points.size(); ++i) {
    const double room = readable_share / std::max(crowding(close, i, ink), readable_share);
    factors.push_back(1 - share * (1 - std::max(room, least_width)));
  }
  for (std::size_t i = 0; i < factors.size(); ++i) close.points[i].width *= factors[i];
  return with_even_widths(close, cells_in_reach * ink.cell_px(), camera);
}

}  // namespace

void thin_where_crowded(std::vector<StrokePath>& paths, double reach_px, double share,
                        const Camera& camera) {
  if (!(share > 0) || !(reach_px > 0) || paths.empty()) return;
  InkMap ink(camera, reach_px);
  for (const StrokePath& path : paths) {
    each_piece(path, ink.cell_px(), [&](const Piece& piece) { ink.add(piece); });
  }
  ink.spread();
  for (StrokePath& path : paths) {
    if (is_crowded(path, ink)) path = thinned(path, ink, share, camera);
  }
}

}  // namespace illustrate
