#include "mesh/split_polygon.h"

#include <algorithm>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

namespace illustrate {
namespace {

// Twice the signed area of the triangle a, b, c.
double turn(const Vec2& a, const Vec2& b, const Vec2& c) { return cross(b - a, c - a); }

// Twice the area vector, by Newell.
Vec3 area_of(Span<const Vec3> polygon) {
  Vec3 area = Vec3::Zero();
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
    area += (polygon[k] - polygon[0]).cross(polygon[k + 1] - polygon[0]);
  return area;
}

// The largest coordinate plane of a polygon, turned so that its normal looks at the viewer.
ImagePoints in_plane(Span<const Vec3> polygon, const Vec3& normal) {
  int axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  int x = (axis + 1) % 3, y = (axis + 2) % 3;
  if (normal[axis] < 0) std::swap(x, y);
  ImagePoints flat;
  for (const Vec3& p : polygon) flat.emplace_back(p[x], p[y]);
  return flat;
}

// Even-odd: what is run along twice does not count.
bool is_inside(const Vec2& p, Span<const Vec2> polygon) {
  bool inside = false;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec2 &a = polygon[k], &b = polygon[k + 1 == polygon.size() ? 0 : k + 1];
    if ((a.y() > p.y()) == (b.y() > p.y())) continue;
    inside ^= (turn(a, b, p) > 0) == (b.y() > a.y());
  }
  return inside;
}

// A polygon in its plane, counter-clockwise, whose corners 0 and `middle` are the same vertex.
class Ring {
 public:
  // points: as they are, and in the plane.
  Ring(const std::vector<int>& corners, std::size_t middle, Points points, ImagePoints flat)
      : corners_(corners),
        middle_(middle),
        in_space_(std::move(points)),
        points_(std::move(flat)) {}

  // One of the two loops lies inside the other.
  bool has_hole() const {
    const Span<const Vec2> first{points_.data(), middle_};
    const Span<const Vec2> second{points_.data() + middle_, points_.size() - middle_};
    return lies_inside(0, middle_, second) || lies_inside(middle_, points_.size(), first);
  }

  // The shortest diagonal from the first loop to the second that stays inside.
  std::optional<std::pair<std::size_t, std::size_t>> find_diagonal(std::size_t& looks) const {
    for (const Diagonal& d : candidates(looks)) {
      if (looks < points_.size()) return {};
      looks -= points_.size();
      if (enters(d.from, d.to) && enters(d.to, d.from) && !is_blocked(d.from, d.to))
        return std::pair(d.from, d.to);
    }
    return {};
  }

 private:
  struct Diagonal {
    float length;  // coarse, so that rounding does not choose between equals
    std::size_t from, to;
    bool operator<(const Diagonal& d) const {
      return std::tie(length, from, to) < std::tie(d.length, d.from, d.to);
    }
  };

  std::size_t after(std::size_t k) const { return k + 1 == points_.size() ? 0 : k + 1; }
  std::size_t before(std::size_t k) const { return (k == 0 ? points_.size() : k) - 1; }

  // Told by a corner that the loops do not share.
  bool lies_inside(std::size_t begin, std::size_t end, Span<const Vec2> other) const {
    for (std::size_t k = begin; k < end; ++k)
      if (std::find(other.begin(), other.end(), points_[k]) == other.end())
        return is_inside(points_[k], other);
    return false;
  }

  std::vector<Diagonal> candidates(std::size_t& looks) const {
    std::vector<Diagonal> found;
    const std::size_t pairs = (middle_ - 1) * (points_.size() - middle_ - 1);
    if (pairs > looks) return found;
    looks -= pairs;
    for (std::size_t i = 1; i < middle_; ++i)
      for (std::size_t j = middle_ + 1; j < points_.size(); ++j)
        if (corners_[i] != corners_[j])
          found.push_back({static_cast<float>((in_space_[i] - in_space_[j]).squaredNorm()), i, j});
    std::sort(found.begin(), found.end());
    return found;
  }

  // The diagonal leaves corner k into the polygon.
  bool enters(std::size_t k, std::size_t to) const {
    const Vec2 &p = points_[k], &previous = points_[before(k)], &next = points_[after(k)];
    const double of_next = turn(p, next, points_[to]), of_previous = turn(p, points_[to], previous);
    const bool is_convex = turn(previous, p, next) > 0;
    return is_convex ? of_next > 0 && of_previous > 0 : of_next > 0 || of_previous > 0;
  }

  // A side away from both ends touches the diagonal.
  bool is_blocked(std::size_t i, std::size_t j) const {
    const Vec2 &a = points_[i], &b = points_[j];
    const auto is_end = [&](const Vec2& p) { return p == a || p == b; };
    const auto between = [&](const Vec2& p) {
      return turn(a, b, p) == 0 && !is_end(p) && (p - a).dot(p - b) < 0;
    };
    for (std::size_t k = 0; k < points_.size(); ++k) {
      const Vec2 &c = points_[k], &d = points_[after(k)];
      if (between(c)) return true;
      if (is_end(c) || is_end(d)) continue;
      if (turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0) return true;
    }
    return false;
  }

  const std::vector<int>& corners_;
  std::size_t middle_;
  Points in_space_;
  ImagePoints points_;
};

class PolygonSplitter {
 public:
  PolygonSplitter(Span<const int> corners, const Points& positions, std::size_t& looks)
      : positions_(positions), looks_(looks), work_{{corners.begin(), corners.end()}} {}

  Ragged<int> run() {
    while (!work_.empty()) {
      std::vector<int> polygon = std::move(work_.back());
      work_.pop_back();
      if (polygon.size() < 3) continue;
      const std::size_t loop = looks_ < polygon.size() ? 0 : bring_shortest_loop_first(polygon);
      if (loop > 0)
        split(polygon, loop);
      else
        add_loops(polygon);
    }
    return std::move(parts_);
  }

 private:
  // Turns the corners until the shortest way from a vertex back to it comes first; returns its
  // length, 0 where there is none.
  std::size_t bring_shortest_loop_first(std::vector<int>& polygon) {
    looks_ -= polygon.size();
    std::vector<std::pair<int, std::size_t>> visits;
    for (std::size_t k = 0; k < polygon.size(); ++k) visits.push_back({polygon[k], k});
    std::sort(visits.begin(), visits.end());
    // Within the shortest way no vertex comes twice, or that way would be shorter: it is a sound
    // loop.
    std::size_t shortest = 0, start = 0;
    for (std::size_t i = 1; i < visits.size(); ++i) {
      const std::size_t length = visits[i].second - visits[i - 1].second;
      if (visits[i].first != visits[i - 1].first || (shortest > 0 && length >= shortest)) continue;
      shortest = length;
      start = visits[i - 1].second;
    }
    std::rotate(polygon.begin(), polygon.begin() + static_cast<std::ptrdiff_t>(start),
                polygon.end());
    return shortest;
  }

  // At corners 0 and `loop`, or where that would close a hole, by a diagonal.
  void split(const std::vector<int>& polygon, std::size_t loop) {
    if (loop > 2) {
      const std::optional<Ring> ring = as_ring(polygon, loop);
      if (ring && ring->has_hole()) {
        const auto diagonal = ring->find_diagonal(looks_);
        if (diagonal) return cut(polygon, *diagonal);
      }
    }
    const auto middle = polygon.begin() + static_cast<std::ptrdiff_t>(loop);
    work_.emplace_back(middle, polygon.end());
    work_.emplace_back(polygon.begin(), middle);
  }

  // None where the loops run the same way round.
  std::optional<Ring> as_ring(const std::vector<int>& polygon, std::size_t loop) const {
    Points points;
    double extent = 0;
    for (const int vertex : polygon) {
      points.push_back(positions_[idx(vertex)] - positions_[idx(polygon[0])]);
      extent = std::max(extent, points.back().cwiseAbs().maxCoeff());
    }
    if (extent == 0) return {};
    for (Vec3& point : points) point /= extent;
    const Vec3 first = area_of({points.data(), loop});
    const Vec3 second = area_of({points.data() + loop, points.size() - loop});
    if (first.dot(second) >= 0) return {};
    const Vec3& normal = first.squaredNorm() > second.squaredNorm() ? first : second;
    ImagePoints flat = in_plane({points.data(), points.size()}, normal);
    return Ring(polygon, loop, std::move(points), std::move(flat));
  }

  void cut(const std::vector<int>& polygon, std::pair<std::size_t, std::size_t> diagonal) {
    const auto at = [&](std::size_t k) { return polygon.begin() + static_cast<std::ptrdiff_t>(k); };
    const auto [from, to] = diagonal;
    std::vector<int> outer(at(to), polygon.end());
    outer.insert(outer.end(), polygon.begin(), at(from + 1));
    work_.push_back(std::move(outer));
    work_.emplace_back(at(from), at(to + 1));
  }

  // Loops without a look at where they lie: holes are closed.
  void add_loops(const std::vector<int>& polygon) {
    std::vector<int> path;
    std::map<int, std::size_t> places;  // on the path
    for (const int vertex : polygon) {
      const auto [visit, is_new] = places.insert({vertex, path.size()});
      if (!is_new) {
        const std::size_t start = visit->second;
        add_part({path.begin() + static_cast<std::ptrdiff_t>(start), path.end()});
        for (std::size_t k = start + 1; k < path.size(); ++k) places.erase(path[k]);
        path.resize(start);
      }
      path.push_back(vertex);
    }
    add_part(path);
  }

  void add_part(const std::vector<int>& part) {
    if (part.size() >= 3) parts_.add(part);
  }

  const Points& positions_;
  std::size_t& looks_;                  // left
  std::vector<std::vector<int>> work_;  // polygons to be looked at, the next last
  Ragged<int> parts_;
};

}  // namespace

Ragged<int> split_polygon(Span<const int> corners, const Points& positions, std::size_t& looks) {
  return PolygonSplitter(corners, positions, looks).run();
}

}  // namespace illustrate
