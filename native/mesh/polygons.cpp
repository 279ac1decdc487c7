#include "mesh/polygons.h"

#include <algorithm>
#include <cmath>

#include "core/tolerances.h"
#include "mesh/delaunay_flips.h"

namespace illustrate {
namespace {

// Twice the area of a triangle; zero where it is straight but for rounding.
double clear_area(const Vec2& a, const Vec2& b, const Vec2& c) {
  const Vec2 ab = b - a, ac = c - a;
  const double area = cross(ab, ac);
  const double least = tolerance::straight_rad * std::sqrt(ab.squaredNorm() * ac.squaredNorm());
  return std::abs(area) > least ? area : 0;
}

std::vector<Triangle> fan(int size) {
  std::vector<Triangle> triangles;
  for (int i = 1; i + 1 < size; ++i) triangles.push_back({0, i, i + 1});
  return triangles;
}

// Whether a quad's diagonal from its first corner is the shorter one, or as long as the other.
bool is_first_diagonal_shorter(Span<const Vec3> p) {
  // A tie within rounding goes to the first: a square is split alike wherever it stands.
  return (p[2] - p[0]).squaredNorm() <= (1 + tolerance::same_length) * (p[3] - p[1]).squaredNorm();
}

std::vector<Triangle> split_quad(Span<const Vec3> p) {
  const Vec3 normal = newell_normal(p);
  const auto faces_front = [&](std::size_t a, std::size_t b, std::size_t c) {
    const Vec3 ab = p[b] - p[a], ac = p[c] - p[a];
    const double least = tolerance::straight_rad * normal.norm() * ab.norm() * ac.norm();
    return normal.dot(ab.cross(ac)) > least;
  };
  // Of a dented quad one diagonal lies outside: then lengths do not matter.
  const bool first_inside = faces_front(0, 1, 2) && faces_front(0, 2, 3);
  const bool second_inside = faces_front(1, 2, 3) && faces_front(1, 3, 0);
  const bool first = first_inside == second_inside ? is_first_diagonal_shorter(p) : first_inside;
  if (first) return {{0, 1, 2}, {0, 2, 3}};
  return {{1, 2, 3}, {1, 3, 0}};
}

ImagePoints in_newell_plane(Span<const Vec3> polygon, const Vec3& normal) {
  const Vec3 x = any_tangent(normal);
  const Vec3 y = normal.cross(x);
  ImagePoints flat;
  for (const Vec3& p : polygon) {
    flat.emplace_back((p - polygon[0]).dot(x), (p - polygon[0]).dot(y));
  }
  return flat;
}

// Clips ears from a polygon in the plane, going round it, so that neighbouring ears do not share a
// corner.
class EarClipper {
 public:
  explicit EarClipper(ImagePoints points)
      : points_(std::move(points)), next_(points_.size()), previous_(points_.size()) {
    const int size = static_cast<int>(points_.size());
    for (int i = 0; i < size; ++i) {
      next(i) = (i + 1) % size;
      previous(i) = (i + size - 1) % size;
    }
    for (int i = 0; i < size; ++i) {
      if (turn(i) <= 0) reflex_.push_back(i);
    }
  }

  // False where the polygon is so large and so dented that the search would take too long.
  bool affordable() const { return points_.size() * reflex_.size() < 20'000'000; }

  std::vector<Triangle> triangles() {
    std::vector<Triangle> result;
    int corner = 0;
    for (std::size_t left = points_.size(); left > 3; --left) {
      corner = find_ear(corner, left);
      result.push_back({previous(corner), corner, next(corner)});
      clip(corner);
      corner = next(next(corner));
    }
    result.push_back({previous(corner), corner, next(corner)});
    return result;
  }

 private:
  int& next(int i) { return next_[idx(i)]; }
  int& previous(int i) { return previous_[idx(i)]; }
  const Vec2& point(int i) const { return points_[idx(i)]; }
  double turn(int i) { return clear_area(point(previous(i)), point(i), point(next(i))); }

  // A polygon that crosses itself may have no ear: then the most convex corner goes.
  int find_ear(int start, std::size_t left) {
    int best = start;
    double best_turn = -HUGE_VAL;
    for (int i = start; left > 0; i = next(i), --left) {
      if (is_ear(i)) return i;
      if (turn(i) > best_turn) {
        best = i;
        best_turn = turn(i);
      }
    }
    return best;
  }

  bool is_ear(int i) {
    if (turn(i) <= 0) return false;
    const Vec2 &a = point(previous(i)), &b = point(i), &c = point(next(i));
    return std::none_of(reflex_.begin(), reflex_.end(), [&](int r) {
      const Vec2& p = point(r);
      // Where a bridge leads to a hole two corners are at one place: that touches the ear, no more.
      if (r == i || r == previous(i) || r == next(i) || p == a || p == b || p == c) return false;
      return clear_area(a, b, p) >= 0 && clear_area(b, c, p) >= 0 && clear_area(c, a, p) >= 0;
    });
  }

  void clip(int i) {
    next(previous(i)) = next(i);
    previous(next(i)) = previous(i);
    // Only the neighbours turn otherwise now, and an ear less never makes a corner reflex.
    const std::array<int, 3> settled{i, previous(i), next(i)};
    reflex_.erase(std::remove_if(reflex_.begin(), reflex_.end(),
                                 [&](int r) {
                                   const bool near = std::count(settled.begin(), settled.end(), r);
                                   return near && (r == i || turn(r) > 0);
                                 }),
                  reflex_.end());
  }

  ImagePoints points_;
  std::vector<int> next_, previous_, reflex_;
};

}  // namespace

Vec3 unit_or_zero(const Vec3& v) {
  const double largest = v.cwiseAbs().maxCoeff();
  if (!(largest > 0) || !std::isfinite(largest)) return Vec3::Zero();
  return (v / largest).normalized();
}

Vec3 unit_of_sum(const Vec3& sum) {
  constexpr double rounding = 1e-10;
  return sum.norm() > rounding ? sum.normalized() : Vec3::Zero();
}

Vec3 any_tangent(const Vec3& v) {
  int smallest = 0;
  // The axis that v is farthest from: the product is never small.
  v.cwiseAbs().minCoeff(&smallest);
  return v.cross(Vec3::Unit(smallest)).normalized();
}

Vec3 tangent_towards(const Vec3& wanted, const Vec3& v) {
  const Vec3 rough = unit_or_zero(wanted - wanted.dot(v) * v);
  // Once more: where little was left, it is rounding along v as well.
  const Vec3 tangent = unit_or_zero(rough - rough.dot(v) * v);
  return tangent.isZero() || std::abs(tangent.dot(v)) > 1e-9 ? any_tangent(v) : tangent;
}

Vec3 newell_normal(Span<const Vec3> polygon) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    sum += (polygon[i] - polygon[0]).cross(polygon[i + 1] - polygon[0]);
  }
  return sum;
}

std::vector<Triangle> triangulate(Span<const Vec3> polygon) {
  if (polygon.size() == 3) return {{0, 1, 2}};
  if (polygon.size() == 4) return split_quad(polygon);
  const Vec3 normal = unit_or_zero(newell_normal(polygon));
  if (normal.isZero()) return fan(static_cast<int>(polygon.size()));
  const ImagePoints flat = in_newell_plane(polygon, normal);
  EarClipper clipper(flat);
  // A fan of a dented polygon overlaps itself, but has the same outline.
  if (!clipper.affordable()) return fan(static_cast<int>(polygon.size()));
  std::vector<Triangle> triangles = clipper.triangles();
  flip_to_delaunay(flat, triangles);
  return triangles;
}

}  // namespace illustrate
