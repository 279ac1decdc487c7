#include "surface/planes/untangle.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>

#include "core/ragged.h"
#include "core/tolerances.h"

namespace illustrate {
namespace {

constexpr int sweeps_per_ring = 8;  // until vertices one edge farther away take part
constexpr int vain_sweeps = 24;     // after which nothing is to be hoped for
constexpr int sweeps_to_even_out = 16;
// Every triple of them is tried: 560 of 16.
constexpr std::size_t most_round = 16;  // triangles of a vertex that is moved

// Of a triangle at a vertex: twice its area, and how that grows as the vertex moves.
struct Area {
  double size;
  Vec2 growth;
  double moved(const Vec2& by) const { return size + growth.dot(by); }
};

double least(const std::vector<Area>& areas, const Vec2& by) {
  double result = std::numeric_limits<double>::infinity();
  for (const Area& a : areas) result = std::min(result, a.moved(by));
  return result;
}

// Where three areas are equal to each other; not finite where they grow along one line.
Vec2 equal_areas(const Area& a, const Area& b, const Area& c) {
  const Vec2 ab = a.growth - b.growth, ac = a.growth - c.growth;
  const double determinant = cross(ab, ac), to_b = b.size - a.size, to_c = c.size - a.size;
  const bool is_parallel = std::abs(determinant) <= tolerance::straight_rad * ab.norm() * ac.norm();
  const Vec2 by(to_b * ac.y() - to_c * ab.y(), to_c * ab.x() - to_b * ac.x());
  return by / (is_parallel ? 0 : determinant);
}

double largest(const std::vector<Area>& areas) {
  double result = 0;
  for (const Area& a : areas) result = std::max(result, std::abs(a.size));
  return result;
}

// The move that makes the smallest area largest: at the best of all corners of the programme. Of
// corners that are equally good, but for rounding, the nearest: rounding must not choose.
Vec2 best_move(const std::vector<Area>& areas) {
  Vec2 best = Vec2::Zero();
  double most = least(areas, best);
  const double rounding = tolerance::same_length * largest(areas);
  for (std::size_t i = 0; i < areas.size(); ++i) {
    for (std::size_t j = i + 1; j < areas.size(); ++j) {
      for (std::size_t k = j + 1; k < areas.size(); ++k) {
        const Vec2 by = equal_areas(areas[i], areas[j], areas[k]);
        if (!by.allFinite()) continue;
        const double size = least(areas, by);
        const bool is_nearer = by.squaredNorm() < (1 - tolerance::same_length) * best.squaredNorm();
        const bool is_better = size > most + rounding || (size > most - rounding && is_nearer);
        if (is_better) std::tie(most, best) = std::pair(size, by);
      }
    }
  }
  return best;
}

// Below, a triangle has no side that could be the wrong one.
double rounding_area(const std::vector<Vec2>& points, const Triangle& t) {
  double longest = 0;
  for (int k = 0; k < 3; ++k) {
    const Vec2 side = points[idx(t[idx(next_corner(k))])] - points[idx(t[idx(k)])];
    longest = std::max(longest, side.squaredNorm());
  }
  return tolerance::degenerate_area * longest;
}

bool is_clockwise(const std::vector<Vec2>& points, const Triangle& t) {
  const Vec2& at = points[idx(t[0])];
  const double area = cross(points[idx(t[1])] - at, points[idx(t[2])] - at) / 2;
  return area < 0 && area < -rounding_area(points, t);
}

class Untangler {
 public:
  Untangler(const std::vector<Triangle>& triangles, const std::vector<std::uint8_t>& fixed,
            std::vector<Vec2>& points)
      : triangles_(triangles), fixed_(fixed), points_(points) {
    std::vector<int> corners(3 * triangles.size());
    std::iota(corners.begin(), corners.end(), 0);
    const auto vertex = [&](int c) { return triangles[idx(c / 3)][idx(c % 3)]; };
    std::stable_sort(corners.begin(), corners.end(),
                     [&](int a, int b) { return vertex(a) < vertex(b); });
    std::size_t next = 0;
    for (int v = 0; v < static_cast<int>(points.size()); ++v) {
      while (next < corners.size() && vertex(corners[next]) == v) corners_.push(corners[next++]);
      corners_.close_list();
    }
  }

  std::size_t run() {
    std::vector<int> folded = find_folded(), touched;
    std::vector<Vec2> best = points_;
    std::size_t fewest = folded.size();
    for (int sweep = 0, last = 0; fewest > 0 && sweep - last < vain_sweeps; ++sweep) {
      const std::vector<int> near = vertices_near(folded, (sweep - last) / sweeps_per_ring);
      for (const int v : near) move(v);
      touched.insert(touched.end(), near.begin(), near.end());
      folded = find_folded();
      if (folded.size() >= fewest) continue;
      fewest = folded.size();
      best = points_;
      last = sweep;
    }
    points_ = std::move(best);
    if (fewest == 0) even_out(touched);
    return fewest;
  }

 private:
  // What is no longer folded may still be as thin as rounding.
  void even_out(std::vector<int>& vertices) {
    sort_once(vertices);
    for (int sweep = 0; sweep < sweeps_to_even_out; ++sweep) {
      for (const int v : vertices) move(v);
    }
  }

  Area area(int corner) const {
    const Triangle& t = triangles_[idx(corner / 3)];
    const int k = corner % 3;
    const Vec2& at = points_[idx(t[idx(k)])];
    const Vec2& next = points_[idx(t[idx(next_corner(k))])];
    const Vec2& previous = points_[idx(t[idx(previous_corner(k))])];
    const Vec2 side = next - previous;
    return {cross(next - at, previous - at), Vec2(side.y(), -side.x())};
  }

  std::vector<int> find_folded() const {
    std::vector<int> result;
    for (int t = 0; t < static_cast<int>(triangles_.size()); ++t) {
      if (is_clockwise(points_, triangles_[idx(t)])) result.push_back(t);
    }
    return result;
  }

  // Ascending; those of the triangles and, as often as `rings`, of the triangles round them.
  std::vector<int> vertices_near(const std::vector<int>& triangles, int rings) const {
    std::vector<int> vertices;
    for (const int t : triangles) add_corners(t, vertices);
    sort_once(vertices);
    for (int ring = 0; ring < rings; ++ring) {
      const std::vector<int> inner = vertices;
      for (const int v : inner) {
        for (const int c : corners_[idx(v)]) add_corners(c / 3, vertices);
      }
      sort_once(vertices);
    }
    return vertices;
  }

  void add_corners(int triangle, std::vector<int>& vertices) const {
    const Triangle& t = triangles_[idx(triangle)];
    vertices.insert(vertices.end(), t.begin(), t.end());
  }

  static void sort_once(std::vector<int>& values) {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
  }

  void move(int vertex) {
    const Span<int> corners = corners_[idx(vertex)];
    if (fixed_[idx(vertex)] || corners.size() > most_round) return;
    areas_.clear();
    for (const int c : corners) areas_.push_back(area(c));
    points_[idx(vertex)] += best_move(areas_);
  }

  const std::vector<Triangle>& triangles_;
  const std::vector<std::uint8_t>& fixed_;
  std::vector<Vec2>& points_;
  Ragged<int> corners_;      // 3 * triangle + corner at each point
  std::vector<Area> areas_;  // round the vertex that is moved
};

}  // namespace

std::size_t untangle(const std::vector<Triangle>& triangles, const std::vector<std::uint8_t>& fixed,
                     std::vector<Vec2>& points) {
  return Untangler(triangles, fixed, points).run();
}

std::size_t count_clockwise(const std::vector<Triangle>& triangles,
                            const std::vector<Vec2>& points) {
  return static_cast<std::size_t>(
      std::count_if(triangles.begin(), triangles.end(),
                    [&](const Triangle& t) { return is_clockwise(points, t); }));
}

}  // namespace illustrate
