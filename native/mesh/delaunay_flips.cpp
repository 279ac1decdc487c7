#include "mesh/delaunay_flips.h"

#include <algorithm>

namespace illustrate {
namespace {

// What the cotangents of two angles sum up to that are 180 degrees together but for rounding.
constexpr double cotangent_rounding = 1e-6;

// A side of a triangle, by its corner before.
struct Side {
  int triangle, corner;
};

class Flipper {
 public:
  Flipper(const ImagePoints& points, std::vector<Triangle>& triangles)
      : points_(points), triangles_(triangles), across_(triangles.size()) {
    link();
  }

  // Each flip makes the triangulation better, so there is an end; the count is for rounding.
  void run() {
    std::size_t left = 100 * triangles_.size();
    for (int t = 0; t < static_cast<int>(triangles_.size()); ++t)
      for (int k = 0; k < 3; ++k) waiting_.push_back({t, k});
    std::reverse(waiting_.begin(), waiting_.end());
    while (!waiting_.empty() && left > 0) {
      const Side side = waiting_.back();
      waiting_.pop_back();
      if (!is_worse(side)) continue;
      flip(side);
      --left;
    }
  }

 private:
  int vertex(const Side& side, int step) const {
    return triangles_[idx(side.triangle)][idx((side.corner + step) % 3)];
  }
  const Vec2& point(int vertex) const { return points_[idx(vertex)]; }
  Side& across(const Side& side) { return across_[idx(side.triangle)][idx(side.corner)]; }

  void link() {
    struct Directed {
      Edge ends;
      Side side;
    };
    std::vector<Directed> sides;
    for (int t = 0; t < static_cast<int>(triangles_.size()); ++t) {
      across_[idx(t)].fill({none, 0});
      for (int k = 0; k < 3; ++k) {
        const int a = vertex({t, k}, 0), b = vertex({t, k}, 1);
        sides.push_back({{std::min(a, b), std::max(a, b)}, {t, k}});
      }
    }
    std::stable_sort(sides.begin(), sides.end(),
                     [](const Directed& a, const Directed& b) { return a.ends < b.ends; });
    for (std::size_t i = 1; i < sides.size(); ++i) {
      if (sides[i].ends != sides[i - 1].ends) continue;
      across(sides[i].side) = sides[i - 1].side;
      across(sides[i - 1].side) = sides[i].side;
    }
  }

  // Of the corner opposite a side.
  double cotangent(const Side& side) const {
    const Vec2 &c = point(vertex(side, 2)), a = point(vertex(side, 0)) - c,
               b = point(vertex(side, 1)) - c;
    const double area = cross(a, b);
    return area > 0 ? a.dot(b) / area : -HUGE_VAL;
  }

  bool is_worse(const Side& side) {
    const Side other = across(side);
    if (other.triangle == none) return false;
    if (!(cotangent(side) + cotangent(other) < -cotangent_rounding)) return false;
    // The other diagonal lies inside.
    const Vec2 &a = point(vertex(side, 0)), &b = point(vertex(side, 1)),
               &c = point(vertex(side, 2)), &d = point(vertex(other, 2));
    return cross(a - c, d - c) > 0 && cross(d - c, b - c) > 0;
  }

  // Of the quad a d b c the diagonal from a to b becomes that from c to d.
  void flip(const Side& side) {
    const Side other = across(side);
    const int a = vertex(side, 0), b = vertex(side, 1), c = vertex(side, 2), d = vertex(other, 2);
    const Side bc = across({side.triangle, next_corner(side.corner)});
    const Side ca = across({side.triangle, previous_corner(side.corner)});
    const Side ad = across({other.triangle, next_corner(other.corner)});
    const Side db = across({other.triangle, previous_corner(other.corner)});
    const int t = side.triangle, u = other.triangle;
    triangles_[idx(t)] = {c, a, d};
    triangles_[idx(u)] = {d, b, c};
    join({t, 0}, ca);
    join({t, 1}, ad);
    join({t, 2}, {u, 2});
    join({u, 0}, db);
    join({u, 1}, bc);
    for (const Side& s : {Side{t, 0}, Side{t, 1}, Side{u, 0}, Side{u, 1}}) waiting_.push_back(s);
  }

  void join(const Side& side, const Side& other) {
    across(side) = other;
    if (other.triangle != none) across(other) = side;
  }

  const ImagePoints& points_;
  std::vector<Triangle>& triangles_;
  std::vector<std::array<Side, 3>> across_;
  std::vector<Side> waiting_;
};

}  // namespace

void flip_to_delaunay(const ImagePoints& points, std::vector<Triangle>& triangles) {
  Flipper(points, triangles).run();
}

}  // namespace illustrate
