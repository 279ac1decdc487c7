#include "tone/sparse_cells.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/parallel.h"

namespace illustrate {
namespace {

constexpr int largest_square = 4;            // cells along a side
constexpr double round_share = 0.3;          // of the work, of each size of squares
constexpr double most_difference = 1.0 / 8;  // between the corners of a square that is not divided

// A square of cells and, as its far corners, the first cells of the next ones; cut off at the
// image's edges.
struct Square {
  int x0, y0, x1, y1;
};

class SparseCells {
 public:
  SparseCells(const Surface& surface, const VisibleImage& visible, const Camera& camera,
              const std::function<double(std::size_t cell)>& value, int threads)
      : surface_(surface),
        visible_(visible),
        camera_(camera),
        ask_(value),
        threads_(threads),
        values_(visible.triangle.size(), 0),
        is_known_(visible.triangle.size(), 0) {}

  std::vector<float> run(const Progress& progress) {
    std::vector<int> squares = all_squares();
    double done = 0;
    for (size_ = largest_square; size_ > 1; size_ /= 2) {
      squares = divide(std::move(squares), progress.part(done, done + round_share));
      done += round_share;
    }
    ask(std::move(squares), progress.part(done, 1));  // squares of one cell are their corner
    return std::move(values_);
  }

 private:
  // Squares of a size are numbered in rows.
  int columns() const { return (visible_.width + size_ - 1) / size_; }
  int rows() const { return (visible_.height + size_ - 1) / size_; }

  Square square(int number) const {
    const int x = number % columns() * size_, y = number / columns() * size_;
    return {x, y, std::min(x + size_, visible_.width - 1),
            std::min(y + size_, visible_.height - 1)};
  }

  std::array<int, 4> corners(const Square& s) const {
    return {visible_.index(s.x0, s.y0), visible_.index(s.x1, s.y0), visible_.index(s.x0, s.y1),
            visible_.index(s.x1, s.y1)};
  }

  std::vector<int> all_squares() {
    size_ = largest_square;
    std::vector<int> all(idx(columns() * rows()));
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<int>(i);
    return all;
  }

  // Fills those of the squares that are even and their neighbours; returns the parts of the others.
  std::vector<int> divide(std::vector<int> squares, const Progress& progress) {
    std::vector<std::uint8_t> is_met(idx(columns() * rows()), 0);
    std::vector<int> divided;
    for (const int s : squares) is_met[idx(s)] = 1;
    while (!squares.empty()) {
      std::vector<int> asked;
      for (const int s : squares) {
        for (const int corner : corners(square(s))) asked.push_back(corner);
      }
      ask(std::move(asked), divided.empty() ? progress : progress.part(1, 1));
      const std::vector<int> uneven = fill_even(squares);
      divided.insert(divided.end(), uneven.begin(), uneven.end());
      squares = new_neighbours(uneven, is_met);
    }
    return parts(divided);
  }

  // Finds the values of the visible ones of some cells that are not known.
  void ask(std::vector<int> cells, const Progress& progress) {
    std::sort(cells.begin(), cells.end());
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    cells.erase(
        std::remove_if(
            cells.begin(), cells.end(),
            [&](int cell) { return is_known_[idx(cell)] || visible_.triangle[idx(cell)] == none; }),
        cells.end());
    parallel_for(cells.size(), threads_, progress, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        values_[idx(cells[i])] = static_cast<float>(ask_(idx(cells[i])));
        is_known_[idx(cells[i])] = 1;
      }
    });
  }

  // Interpolates within even squares; returns the others.
  std::vector<int> fill_even(const std::vector<int>& squares) {
    std::vector<std::uint8_t> is_filled(squares.size(), 0);
    parallel_for(squares.size(), threads_, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const Square s = square(squares[i]);
        is_filled[i] = is_empty(s) || is_even(s) ? 1 : 0;
      }
    });
    std::vector<int> uneven;
    for (std::size_t i = 0; i < squares.size(); ++i) {
      if (is_filled[i]) {
        interpolate(square(squares[i]));
      } else {
        uneven.push_back(squares[i]);
      }
    }
    return uneven;
  }

  bool is_empty(const Square& s) const {
    for (int y = s.y0; y < std::min(s.y0 + size_, visible_.height); ++y) {
      for (int x = s.x0; x < std::min(s.x0 + size_, visible_.width); ++x) {
        if (visible_.triangle[idx(visible_.index(x, y))] != none) return false;
      }
    }
    return true;
  }

  bool is_even(const Square& s) const {
    const std::array<int, 4> cells = corners(s);
    const int first = visible_.triangle[idx(cells[0])];
    if (first == none) return false;
    const int object = surface_.object_of(first);
    for (int y = s.y0; y <= s.y1; ++y) {
      for (int x = s.x0; x <= s.x1; ++x) {
        const int triangle = visible_.triangle[idx(visible_.index(x, y))];
        if (triangle == none || surface_.object_of(triangle) != object) return false;
      }
    }
    const auto at = [&](int k) { return values_[idx(cells[idx(k)])]; };
    const auto [low, high] = std::minmax({at(0), at(1), at(2), at(3)});
    return high - low <= most_difference && is_one_piece(s);
  }

  // No cell is further before or behind what its corners span than the square is wide.
  bool is_one_piece(const Square& s) const {
    std::array<double, 4> over_w{}, one_over_w{};  // both linear across the image of a plane
    const std::array<int, 4> cells = corners(s);
    for (std::size_t k = 0; k < 4; ++k) {
      const double depth = visible_.depth[idx(cells[k])];
      one_over_w[k] = 1 / w_at(depth);
      over_w[k] = depth * one_over_w[k];
    }
    const double wide = size_ * visible_.cell_px * camera_.pixel_per_w();
    for (int y = s.y0; y <= s.y1; ++y) {
      for (int x = s.x0; x <= s.x1; ++x) {
        const double depth = visible_.depth[idx(visible_.index(x, y))];
        const double spanned = between(s, over_w, x, y) / between(s, one_over_w, x, y);
        if (!(std::abs(depth - spanned) <= wide * w_at(depth))) return false;
      }
    }
    return true;
  }

  // What the image divides by at a depth.
  double w_at(double depth) const {
    return camera_.projection()(3, 3) - camera_.projection()(3, 2) * depth;
  }

  static double between(const Square& s, const std::array<double, 4>& corners, int x, int y) {
    const double u = s.x1 > s.x0 ? double(x - s.x0) / (s.x1 - s.x0) : 0;
    const double v = s.y1 > s.y0 ? double(y - s.y0) / (s.y1 - s.y0) : 0;
    return (1 - v) * ((1 - u) * corners[0] + u * corners[1]) +
           v * ((1 - u) * corners[2] + u * corners[3]);
  }

  void interpolate(const Square& s) {
    std::array<double, 4> at{};
    const std::array<int, 4> cells = corners(s);
    for (std::size_t k = 0; k < 4; ++k) at[k] = values_[idx(cells[k])];
    for (int y = s.y0; y < std::min(s.y0 + size_, visible_.height); ++y) {
      for (int x = s.x0; x < std::min(s.x0 + size_, visible_.width); ++x) {
        const std::size_t cell = idx(visible_.index(x, y));
        const bool is_wanted = visible_.triangle[cell] != none && !is_known_[cell];
        if (is_wanted) values_[cell] = static_cast<float>(between(s, at, x, y));
      }
    }
  }

  // Those round some squares that have not been met.
  std::vector<int> new_neighbours(const std::vector<int>& squares,
                                  std::vector<std::uint8_t>& is_met) const {
    std::vector<int> found;
    for (const int number : squares) {
      const int x = number % columns(), y = number / columns();
      for (int j = std::max(0, y - 1); j <= std::min(y + 1, rows() - 1); ++j) {
        for (int i = std::max(0, x - 1); i <= std::min(x + 1, columns() - 1); ++i) {
          const int neighbour = j * columns() + i;
          if (is_met[idx(neighbour)]) continue;
          is_met[idx(neighbour)] = 1;
          found.push_back(neighbour);
        }
      }
    }
    return found;
  }

  // The quarters of squares, numbered as squares of half the size.
  std::vector<int> parts(const std::vector<int>& squares) {
    std::vector<int> quarters;
    const int from = columns();
    size_ /= 2;
    const int to_columns = columns(), to_rows = rows();
    size_ *= 2;
    for (const int number : squares) {
      const int x = 2 * (number % from), y = 2 * (number / from);
      for (int j = y; j < std::min(y + 2, to_rows); ++j) {
        for (int i = x; i < std::min(x + 2, to_columns); ++i)
          quarters.push_back(j * to_columns + i);
      }
    }
    return quarters;
  }

  const Surface& surface_;
  const VisibleImage& visible_;
  const Camera& camera_;
  const std::function<double(std::size_t cell)>& ask_;
  const int threads_;
  std::vector<float> values_;
  std::vector<std::uint8_t> is_known_;
  int size_ = largest_square;
};

}  // namespace

std::vector<float> ask_sparsely(const Surface& surface, const VisibleImage& visible,
                                const Camera& camera,
                                const std::function<double(std::size_t cell)>& value, int threads,
                                const Progress& progress) {
  return SparseCells(surface, visible, camera, value, threads).run(progress);
}

}  // namespace illustrate
