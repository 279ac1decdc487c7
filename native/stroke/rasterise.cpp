#include "stroke/rasterise.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"

namespace illustrate {
namespace {

constexpr std::size_t rows_in_band = 64;

// Half the diagonal of a pixel: how far from its centre it may be covered.
constexpr double half_diagonal = 0.70710678118654757;
constexpr double least_shadow = 1e-6;  // of a side of a pixel seen along it

// The share of a pixel on one side of a line whose unit normal has these components, with the
// centre `distance` behind it: a pixel's shadow on the normal is the sum of two boxes.
double share_behind(double distance, double across, double along) {
  const double wide = std::max(across, along), narrow = std::min(across, along);
  if (narrow < least_shadow) return std::clamp(distance / wide + 0.5, 0.0, 1.0);
  const auto square = [](double x) { return x > 0 ? x * x : 0; };
  const double outer = (wide + narrow) / 2, inner = (wide - narrow) / 2;
  const double sum = square(distance + outer) - square(distance + inner) -
                     square(distance - inner) + square(distance - outer);
  return sum / (2 * wide * narrow);
}

// The share of a pixel, whose centre lies `off` away from the middle of a strip, that it covers.
// direction: of the strip, of any length, for where the centre lies on its middle.
double cover(const Vec2& off, const Vec2& direction, double width) {
  const double distance = off.norm(), half = width / 2;
  if (!(distance < half + half_diagonal)) return 0;
  const Vec2 normal = distance > least_shadow ? Vec2(off / distance)
                      : direction.isZero()    ? Vec2(1, 0)
                                           : Vec2(Vec2(-direction.y(), direction.x()).normalized());
  const double x = std::abs(normal.x()), y = std::abs(normal.y());
  return share_behind(half - distance, x, y) - share_behind(-half - distance, x, y);
}

using Wide = std::array<double, 4>;  // red, green, blue times alpha, and alpha

// Some rows of the picture, painted stroke by stroke.
class PaperRows {
 public:
  PaperRows(int width, int first_row, int last_row, const Colour& paper)
      : width_(width), first_(first_row), last_(last_row) {
    const std::size_t count = idx(width) * idx(last_row - first_row);
    const double alpha = paper[3] / 255.0;
    pixels_.assign(count, {paper[0] * alpha, paper[1] * alpha, paper[2] * alpha, alpha});
    cover_.assign(count, 0);
  }

  void paint(const RoundStrokes& strokes, std::size_t stroke) {
    const int begin = strokes.offsets[stroke], end = strokes.offsets[stroke + 1];
    for (int i = begin; i + 1 < end; ++i) add_piece(strokes, i, i + 1);
    if (end - begin == 1) add_piece(strokes, begin, begin);
    if (strokes.closed[stroke] && end - begin > 2) add_piece(strokes, end - 1, begin);
    mix(strokes.colours[stroke]);
  }

  void write(std::vector<Colour>& picture) const {
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
      const Wide& from = pixels_[i];
      Colour& to = picture[idx(first_) * idx(width_) + i];
      for (std::size_t k = 0; k < 3; ++k) {
        to[k] = static_cast<std::uint8_t>(std::lround(from[3] > 0 ? from[k] / from[3] : 0));
      }
      to[3] = static_cast<std::uint8_t>(std::lround(255 * from[3]));
    }
  }

 private:
  void add_piece(const RoundStrokes& strokes, int i, int j) {
    const Vec2 &a = strokes.image[idx(i)], &b = strokes.image[idx(j)];
    const double from = strokes.widths[idx(i)], to = strokes.widths[idx(j)];
    const double reach = std::max(from, to) / 2 + half_diagonal;
    if (!a.allFinite() || !b.allFinite() || !(reach > half_diagonal) || !std::isfinite(reach))
      return;
    const Vec2 low = a.cwiseMin(b).array() - reach, high = a.cwiseMax(b).array() + reach;
    const auto clamped = [](double value, int least, int most) {
      return static_cast<int>(std::clamp(std::floor(value), double(least), double(most)));
    };
    const int top = clamped(low.y(), first_, last_), bottom = clamped(high.y() + 1, first_, last_);
    const int left = clamped(low.x(), 0, width_), right = clamped(high.x() + 1, 0, width_);
    const Vec2 along = b - a;
    const double square = along.squaredNorm();
    for (int y = top; y < bottom; ++y) {
      for (int x = left; x < right; ++x) {
        const Vec2 off = Vec2(x + 0.5, y + 0.5) - a;
        const double t = square > 0 ? std::clamp(off.dot(along) / square, 0.0, 1.0) : 0;
        add_cover(x, y, cover(off - t * along, along, from + t * (to - from)));
      }
    }
  }

  void add_cover(int x, int y, double share) {
    if (share <= 0) return;
    const std::size_t pixel = idx(y - first_) * idx(width_) + idx(x);
    if (cover_[pixel] == 0) touched_.push_back(pixel);
    cover_[pixel] = std::max(cover_[pixel], static_cast<float>(share));
  }

  void mix(const Colour& ink) {
    for (const std::size_t pixel : touched_) {
      const double alpha = cover_[pixel] * (ink[3] / 255.0);
      Wide& under = pixels_[pixel];
      for (std::size_t k = 0; k < 3; ++k) under[k] += alpha * (ink[k] - under[k]);
      under[3] += alpha * (1 - under[3]);
      cover_[pixel] = 0;
    }
    touched_.clear();
  }

  int width_, first_, last_;
  std::vector<Wide> pixels_;
  std::vector<float> cover_;  // of the stroke that is painted
  std::vector<std::size_t> touched_;
};

// Rows that a stroke may reach: lowest and highest + 1, for the bands.
std::array<double, 2> rows_of(const RoundStrokes& strokes, std::size_t stroke) {
  std::array<double, 2> rows{1, 0};
  bool is_first = true;
  for (int i = strokes.offsets[stroke]; i < strokes.offsets[stroke + 1]; ++i) {
    const double y = strokes.image[idx(i)].y(), reach = strokes.widths[idx(i)] / 2 + 1;
    if (!std::isfinite(y) || !std::isfinite(reach)) continue;
    rows[0] = is_first ? y - reach : std::min(rows[0], y - reach);
    rows[1] = is_first ? y + reach : std::max(rows[1], y + reach);
    is_first = false;
  }
  return rows;
}

}  // namespace

std::vector<Colour> rasterise(const RoundStrokes& strokes, int width, int height,
                              const Colour& paper, int threads, const Progress& progress) {
  std::vector<Colour> picture(idx(width) * idx(height));
  std::vector<std::array<double, 2>> rows;
  for (std::size_t s = 0; s < strokes.closed.size(); ++s) rows.push_back(rows_of(strokes, s));
  const std::size_t bands = (idx(height) + rows_in_band - 1) / rows_in_band;
  parallel_each(bands, threads, progress, [&](std::size_t i) {
    const int first = static_cast<int>(i * rows_in_band);
    const int last = std::min(height, first + static_cast<int>(rows_in_band));
    PaperRows band(width, first, last, paper);
    for (std::size_t s = 0; s < rows.size(); ++s) {
      if (rows[s][0] < last && rows[s][1] > first) band.paint(strokes, s);
    }
    band.write(picture);
  });
  return picture;
}

}  // namespace illustrate
