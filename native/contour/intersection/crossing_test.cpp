#include "contour/intersection/crossing_test.h"

#include <algorithm>
#include <cmath>

#include "core/disjoint_sets.h"
#include "core/mixed_bits.h"
#include "core/predicates.h"
#include "core/spread.h"
#include "mesh/polygons.h"

namespace illustrate {
namespace {

// Triangles farther apart than this share of their size are told apart in plain arithmetic.
constexpr double separation = 1e-10;

// Each point is moved farther than others of its part by up to this share of how much farther the
// next part is moved, chosen by its number. Points of one plane that are moved along one normal
// would stay in one plane, and where another one of that part is moved another way rounding would
// say what crosses, and where. As far above rounding as leaves parts apart.
constexpr double unevenness = 1.0 / 32;

// Triangles are in one plane within this many times that, or, where that is nothing, within this
// share of how far points are from their middle: far above what a rotation or a shift by a few
// sizes leaves of a plane.
constexpr double coplanar = 4, coplanar_rounding = 0x1p-38;

// Coordinates relative to the largest one below which exact products could underflow.
constexpr double smallest_coordinate = 0x1p-200;

// How far points are moved, relative to their farthest distance from their middle, or what counts
// as it far from the origin: a few times the rounding to single precision, in which modelling
// programs store them.
constexpr double rounding_inset = 0x1p-22;

// And never more than this share of the median edge: one far vertex, or a vast ground, makes the
// rounding larger than the detail, and every box would be near every other.
constexpr double largest_inset_of_edge = 1.0 / 400;

// The farthest that an inset of 1 moves two points towards each other.
constexpr double in_plane = 20;

// How far borders draw back, in insets: more than any sheet is moved.
constexpr double border_retreat = 3;

// Bounds the inset where the sides of a place face nearly opposite ways.
constexpr double least_mean_normal = 0.05;

bool are_equal(const std::array<int, 3>& sides) {
  return sides[0] != 0 && sides[0] == sides[1] && sides[1] == sides[2];
}

// 1 or -1 by the parity of the permutation that sorts four different numbers.
int parity(const std::array<int, 4>& numbers) {
  int sign = 1;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j)
      if (numbers[i] > numbers[j]) sign = -sign;
  return sign;
}

// A number from 0 to 1 that has nothing to do with those of other places.
double share_of(std::size_t place) {
  return std::ldexp(static_cast<double>(mixed_bits(place + mixing_step)), -64);
}

Vec3 winding_normal(const Points& points, const Triangle& t) {
  return (points[idx(t[1])] - points[idx(t[0])]).cross(points[idx(t[2])] - points[idx(t[0])]);
}

// Unit, in the plane of the three, from the edge between two towards the third.
Vec3 away_from_edge(const Vec3& a, const Vec3& b, const Vec3& third) {
  const Vec3 along = unit_or_zero(b - a), offset = third - a;
  return unit_or_zero(offset - offset.dot(along) * along);
}

// Which way a sliver faces means nothing.
bool is_thin(const Points& points, const Triangle& t, double distance) {
  double longest = 0;
  for (int k = 0; k < 3; ++k) {
    const Vec3& corner = points[idx(t[idx(k)])];
    longest = std::max(longest, (points[idx(t[idx(next_corner(k))])] - corner).norm());
  }
  return winding_normal(points, t).norm() <= distance * longest;
}

// The same one wherever and however turned the surface is.
Vec3 middle_of_corners(const Surface& surface) {
  const double count = 3 * static_cast<double>(surface.triangles.size());
  Vec3 middle = Vec3::Zero();
  for (const Triangle& t : surface.triangles)
    for (const int v : t)
      if (surface.positions[idx(v)].allFinite()) middle += surface.positions[idx(v)] / count;
  return middle;
}

std::array<Vec3, 3> corners(const Points& points, const Triangle& t) {
  return {points[idx(t[0])], points[idx(t[1])], points[idx(t[2])]};
}

}  // namespace

bool lie_in_one_plane(const std::array<Vec3, 3>& a, const std::array<Vec3, 3>& b, double distance) {
  const Vec3 of_a = (a[1] - a[0]).cross(a[2] - a[0]), of_b = (b[1] - b[0]).cross(b[2] - b[0]);
  const bool is_a = of_a.squaredNorm() >= of_b.squaredNorm();
  const Vec3& up = is_a ? of_a : of_b;
  const Vec3& origin = (is_a ? a : b)[0];
  const auto is_near = [&](const Vec3& corner) {
    return std::abs(up.dot(corner - origin)) <= distance * up.norm();
  };
  const std::array<Vec3, 3>& smaller = is_a ? b : a;
  return std::all_of(smaller.begin(), smaller.end(), is_near);
}

struct CrossingTest::Ends {
  std::array<Piercing, 6> piercings;
  std::size_t count = 0;
};

CrossingTest::CrossingTest(const Surface& surface) {
  place_vertices(surface);
  scale_points(surface);
  measure_size();
  number_parts();
  choose_inset();
  move_points_inward(surface);
}

void CrossingTest::place_vertices(const Surface& surface) {
  const int last = surface.places.empty()
                       ? none
                       : *std::max_element(surface.places.begin(), surface.places.end());
  vertices_.assign(idx(last) + 1, none);
  for (std::size_t v = 0; v < surface.places.size(); ++v)
    if (vertices_[idx(surface.places[v])] == none)
      vertices_[idx(surface.places[v])] = static_cast<int>(v);
  triangles_.reserve(surface.triangles.size());
  for (const Triangle& t : surface.triangles)
    triangles_.push_back(
        {surface.places[idx(t[0])], surface.places[idx(t[1])], surface.places[idx(t[2])]});
}

// Scaling by a power of two changes no sign.
void CrossingTest::scale_points(const Surface& surface) {
  points_.assign(vertices_.size(), Vec3::Zero());
  middle_ = middle_of_corners(surface);
  double largest = 0;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (vertices_[i] == none || !surface.positions[idx(vertices_[i])].allFinite()) continue;
    points_[i] = surface.positions[idx(vertices_[i])] - middle_;
    largest = std::max(largest, points_[i].cwiseAbs().maxCoeff());
  }
  const int exponent = -std::ilogb(largest > 0 ? largest : 1.0);
  for (Vec3& point : points_)
    for (double& x : point) x = std::ldexp(x, exponent);
  scale_ = std::ldexp(1.0, -exponent);
}

void CrossingTest::measure_size() {
  for (const Triangle& t : triangles_)
    for (const int place : t) size_ = std::max(size_, points_[idx(place)].norm());
}

void CrossingTest::choose_inset() {
  std::vector<double> edges;
  for (const Triangle& t : triangles_)
    for (int k = 0; k < 3; ++k) {
      const double length = (points_[idx(t[idx(next_corner(k))])] - points_[idx(t[idx(k)])]).norm();
      if (length > 0) edges.push_back(length);
    }
  inset_ = rounding_inset * rounding_size(size_, middle_.stableNorm() / scale_);
  if (edges.empty()) return;
  const auto median = edges.begin() + static_cast<std::ptrdiff_t>(edges.size() / 2);
  std::nth_element(edges.begin(), median, edges.end());
  inset_ = std::min(inset_, *median * largest_inset_of_edge);
}

double CrossingTest::reach() const { return in_plane * inset_ * scale_; }

double CrossingTest::one_plane() const { return one_plane_ * scale_; }

void CrossingTest::number_parts() {
  DisjointSets joined(vertices_.size());
  for (const Triangle& t : triangles_)
    for (const int place : t) joined.join(t[0], place);
  parts_.assign(vertices_.size(), none);
  for (int i = 0; i < static_cast<int>(parts_.size()); ++i) {
    if (vertices_[idx(i)] == none) continue;
    int& part = parts_[idx(joined.root(i))];
    if (part == none) part = part_count_++;
    parts_[idx(i)] = part;
  }
}

// By n / |n|^2, n the mean normal of the smooth sides: where they meet at right angles, each plane
// moves by the same distance.
void CrossingTest::move_points_inward(const Surface& surface) {
  moved_ = points_;
  Points normals(vertices_.size(), Vec3::Zero());
  std::vector<int> copies(vertices_.size(), 0);
  for (std::size_t v = 0; v < surface.places.size(); ++v) {
    if (!surface.normals[v].allFinite()) continue;
    normals[idx(surface.places[v])] += surface.normals[v];
    ++copies[idx(surface.places[v])];
  }
  const double farther = inset_ / std::max(1, part_count_);  // the next part
  one_plane_ = std::max(coplanar * unevenness * farther, coplanar_rounding * size_);
  for (std::size_t i = 0; i < moved_.size(); ++i) {
    const Vec3 mean = normals[i] / std::max(1, copies[i]);
    const double depth = inset_ + (parts_[i] + unevenness * share_of(i)) * farther;
    moved_[i] -= mean * (depth / std::max(mean.squaredNorm(), least_mean_normal));
  }
  retract_borders(surface);
  for (Vec3& point : moved_)
    for (double& x : point)
      if (std::abs(x) < smallest_coordinate) x = 0;
}

// Sheets that only adjoin, as faces of a solid that are objects of their own, would cross along
// their border once both are moved inward: each border draws back by more than the other sheet is
// moved. At a corner both edges do, as above.
void CrossingTest::retract_borders(const Surface& surface) {
  Points within(vertices_.size(), Vec3::Zero());
  std::vector<int> edges(vertices_.size(), 0);
  for (int t = 0; t < static_cast<int>(triangles_.size()); ++t) {
    for (int k = 0; k < 3; ++k) {
      if (surface.edge_kinds[idx(t)][idx(k)] != EdgeKind::boundary) continue;
      const int next = next_corner(k), third = next_corner(next);
      const Vec3 away = away_from_edge(at(t, k), at(t, next), at(t, third));
      for (const int end : {k, next}) {
        const std::size_t place = idx(triangles_[idx(t)][idx(end)]);
        within[place] += away;
        ++edges[place];
      }
    }
  }
  for (std::size_t i = 0; i < moved_.size(); ++i) {
    const Vec3 mean = within[i] / std::max(1, edges[i]);
    if (!mean.allFinite()) continue;
    moved_[i] += mean * (border_retreat * inset_ / std::max(mean.squaredNorm(), least_mean_normal));
  }
}

Insets CrossingTest::insets(const Surface& surface) const {
  Insets insets;
  insets.moves.reserve(surface.places.size());
  insets.parts.reserve(surface.places.size());
  for (const int place : surface.places) {
    insets.moves.push_back(scale_ * (moved_[idx(place)] - points_[idx(place)]));
    insets.parts.push_back(parts_[idx(place)]);
  }
  return insets;
}

// What is coplanar even so counts as positive in ascending order of places.
int CrossingTest::side(int a, int b, int c, int d) const {
  const int sign = orient3d(moved_[idx(a)], moved_[idx(b)], moved_[idx(c)], moved_[idx(d)]);
  return sign != 0 ? sign : parity({a, b, c, d});
}

CrossingTest::Sides CrossingTest::filtered_sides(int triangle, int other) const {
  const Vec3 &a = moved(triangle, 0), &b = moved(triangle, 1), &c = moved(triangle, 2);
  return {filtered_orient3d(a, b, c, moved(other, 0)), filtered_orient3d(a, b, c, moved(other, 1)),
          filtered_orient3d(a, b, c, moved(other, 2))};
}

bool CrossingTest::share_vertex_or_are_flat(int s, int t) const {
  const Triangle &a = triangles_[idx(s)], &b = triangles_[idx(t)];
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if (a[i] == b[0] || a[i] == b[1] || a[i] == b[2] || a[i] == a[j] || b[i] == b[j]) return true;
  }
  return false;
}

// Whether t lies beyond one edge of s, seen along s's normal.
bool CrossingTest::has_separating_edge(int s, int t) const {
  const Vec3 normal = (moved(s, 1) - moved(s, 0)).cross(moved(s, 2) - moved(s, 0));
  for (int k = 0; k < 3; ++k) {
    const Vec3 outward = (moved(s, next_corner(k)) - moved(s, k)).cross(normal);
    const auto beyond = [&](int j) {
      const Vec3 offset = moved(t, j) - moved(s, k);
      return offset.dot(outward) > separation * offset.norm() * outward.norm();
    };
    if (beyond(0) && beyond(1) && beyond(2)) return true;
  }
  return false;
}

// Whether nothing but rounding says on which side of each other they are, although both were moved:
// a limit that folds over itself within its plane.
bool CrossingTest::are_coplanar(int s, int t) const {
  const Triangle &a = triangles_[idx(s)], &b = triangles_[idx(t)];
  return lie_in_one_plane(corners(moved_, a), corners(moved_, b), one_plane_);
}

bool CrossingTest::are_flush(int s, int t) const {
  if (part(s) == part(t)) return false;
  const Triangle &a = triangles_[idx(s)], &b = triangles_[idx(t)];
  const double distance = in_plane * inset_;
  const bool face_one_way = winding_normal(points_, a).dot(winding_normal(points_, b)) > 0 ||
                            is_thin(points_, a, distance) || is_thin(points_, b, distance);
  return face_one_way && lie_in_one_plane(corners(points_, a), corners(points_, b), distance);
}

bool CrossingTest::pierces(int a, int b, int triangle) const {
  const Triangle& t = triangles_[idx(triangle)];
  const int first = side(a, b, t[0], t[1]);
  return first == side(a, b, t[1], t[2]) && first == side(a, b, t[2], t[0]);
}

void CrossingTest::add_piercings(int triangle, int other, Ends& ends) const {
  const Triangle &t = triangles_[idx(triangle)], &o = triangles_[idx(other)];
  Sides sides;
  for (std::size_t k = 0; k < 3; ++k) sides[k] = side(o[0], o[1], o[2], t[k]);
  for (int k = 0; k < 3; ++k) {
    const int a = t[idx(k)], b = t[idx(next_corner(k))];
    if (sides[idx(k)] != sides[idx(next_corner(k))] && pierces(a, b, other))
      ends.piercings[ends.count++] = {std::min(a, b), std::max(a, b), other};
  }
}

TriangleIntersection CrossingTest::cross(int s, int t, std::array<Piercing, 2>& found) const {
  if (share_vertex_or_are_flat(s, t) || are_equal(filtered_sides(s, t)) ||
      are_equal(filtered_sides(t, s)) || has_separating_edge(s, t) || has_separating_edge(t, s) ||
      are_coplanar(s, t))
    return TriangleIntersection::apart;
  Ends ends;
  add_piercings(s, t, ends);
  add_piercings(t, s, ends);
  if (ends.count == 0) return TriangleIntersection::apart;
  if (ends.count != 2) return TriangleIntersection::undecided;
  found = {ends.piercings[0], ends.piercings[1]};
  return TriangleIntersection::segment;
}

double CrossingTest::share_to_plane(const Points& points, const Piercing& piercing,
                                    double& farther) const {
  const Triangle& t = triangles_[idx(piercing.triangle)];
  const Vec3 normal = winding_normal(points, t);
  const Vec3& origin = points[idx(t[0])];
  const double low = normal.dot(points[idx(piercing.low)] - origin);
  const double high = normal.dot(points[idx(piercing.high)] - origin);
  farther = std::max(std::abs(low), std::abs(high)) / normal.norm();
  return low == high ? 0.5 : std::clamp(low / (low - high), 0.0, 1.0);
}

// Where an edge lies in the triangle's plane only the inset says where it pierces it; on both sides
// of it, along the curve, that is what they were decided by.
double CrossingTest::parameter(const Piercing& piercing) const {
  double farther = 0;
  const double share = share_to_plane(points_, piercing, farther);
  return farther <= in_plane * inset_ ? share_to_plane(moved_, piercing, farther) : share;
}

Vec3 CrossingTest::decided(const Piercing& piercing) const {
  double farther = 0;
  const double s = share_to_plane(moved_, piercing, farther);
  const Vec3 &from = moved_[idx(piercing.low)], &to = moved_[idx(piercing.high)];
  return middle_ + scale_ * (from + s * (to - from));
}

SurfacePoint CrossingTest::surface_point(const Piercing& piercing, int triangle) const {
  const double s = parameter(piercing);
  const Triangle& t = triangles_[idx(triangle)];
  const auto low = std::find(t.begin(), t.end(), piercing.low);
  const auto high = std::find(t.begin(), t.end(), piercing.high);
  if (low != t.end() && high != t.end()) {
    Vec3 weights = Vec3::Zero();
    weights[low - t.begin()] = 1 - s;
    weights[high - t.begin()] = s;
    return {triangle, weights[1], weights[2]};
  }
  return projected(points_[idx(piercing.low)] * (1 - s) + points_[idx(piercing.high)] * s,
                   triangle);
}

// The barycentrics of a point's projection along the normal.
SurfacePoint CrossingTest::projected(const Vec3& point, int triangle) const {
  const Vec3 u = at(triangle, 1) - at(triangle, 0), v = at(triangle, 2) - at(triangle, 0);
  const Vec3 normal = u.cross(v), offset = point - at(triangle, 0);
  const double area = normal.squaredNorm();
  if (!(area > 0)) return {triangle, 0, 0};
  const double b1 = std::clamp(offset.cross(v).dot(normal) / area, 0.0, 1.0);
  const double b2 = std::clamp(u.cross(offset).dot(normal) / area, 0.0, 1.0);
  const double sum = std::max(1.0, b1 + b2);
  return {triangle, b1 / sum, b2 / sum};
}

}  // namespace illustrate
