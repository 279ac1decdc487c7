#include "field/problem/plane_crosses.h"

#include <algorithm>
#include <array>
#include <limits>

#include "core/tolerances.h"
#include "field/problem/coplanar.h"
#include "surface/planes/plane_rim.h"

namespace illustrate {
namespace {

// Of four times the angle between a rim and the cross, about 5 degrees.
constexpr double least_rim_cosine = 0.94;
constexpr double narrow_strip = 4;  // so many times smaller are its triangles

// What decides between faces: how much rim asks for the direction.
double strength(const PlaneFace& plane) { return plane.agreement * plane.rim_length; }

// Of the faces of each group the strongest that has a direction; none where none has.
template <class Group>
std::vector<int> strongest(const std::vector<PlaneFace>& planes, std::size_t groups,
                           const Group& group_of) {
  std::vector<int> result(groups, none);
  for (int p = 0; p < static_cast<int>(planes.size()); ++p) {
    if (!has_direction(planes[idx(p)])) continue;
    int& best = result[idx(group_of(p))];
    if (best == none || strength(planes[idx(p)]) > strength(planes[idx(best)])) best = p;
  }
  return result;
}

// Of the axes of an object, which its strongest face has, the one that lies most in a plane.
Vec3 own_axis(const PlaneFace& strongest, const Vec3& normal) {
  const std::array<Vec3, 3> axes{strongest.direction, strongest.normal.cross(strongest.direction),
                                 strongest.normal};
  return *std::min_element(axes.begin(), axes.end(), [&](const Vec3& a, const Vec3& b) {
    // Of axes that lie in the plane alike the first: rounding does not choose.
    return std::abs(a.dot(normal)) < std::abs(b.dot(normal)) - tolerance::flat_rad;
  });
}

// (planes) the direction of the cross; zero where the default is to be taken.
std::vector<Vec3> directions_of(const std::vector<PlaneFace>& planes, bool across_objects) {
  const std::vector<int> groups = coplanar_groups(planes, across_objects);
  const auto group_of = [&](int p) { return groups[idx(p)]; };
  const auto object_of = [&](int p) { return planes[idx(p)].object; };
  const std::size_t objects = idx(planes.back().object) + 1;
  const std::vector<int> leaders = strongest(planes, planes.size(), group_of);
  const std::vector<int> of_objects = strongest(planes, objects, object_of);
  std::vector<Vec3> directions;
  for (std::size_t p = 0; p < planes.size(); ++p) {
    const int leader = leaders[idx(groups[p])], own = of_objects[idx(planes[p].object)];
    if (leader != none) {
      directions.push_back(planes[idx(leader)].direction);
    } else if (own != none) {
      directions.push_back(own_axis(planes[idx(own)], planes[p].normal));
    } else {
      directions.emplace_back(Vec3::Zero());
    }
  }
  return directions;
}

// Of the triangles at a vertex: the lowest and the highest face, or none.
struct PlanesAround {
  int least = std::numeric_limits<int>::max(), most = none;
  double largest_inside = 0, largest_beyond = 0;  // triangles by their areas

  void add(int plane, double area) {
    least = std::min(least, plane);
    most = std::max(most, plane);
    double& largest = plane == none ? largest_beyond : largest_inside;
    largest = std::max(largest, area);
  }
  bool is_inside() const { return least == most; }
  bool is_on_smooth_rim() const { return least == none && most != none; }
  // Crosses turn within one row of triangles: where it goes on in a narrow strip, within that.
  bool is_beside_strip() const { return narrow_strip * largest_beyond < largest_inside; }
};

std::vector<PlanesAround> planes_around_vertices(const Surface& surface) {
  std::vector<PlanesAround> around(surface.positions.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto& [a, b, c] = surface.triangles[t];
    const Points& p = surface.positions;
    const double area = (p[idx(b)] - p[idx(a)]).cross(p[idx(c)] - p[idx(a)]).norm();
    for (const int vertex : {a, b, c}) around[idx(vertex)].add(surface.triangle_planes[t], area);
  }
  return around;
}

// (n) the crosses of the edges at which flat faces end.
CrossNumbers rim_crosses(const Surface& surface, const TangentFrames& frames) {
  CrossNumbers sums(frames.size(), 0);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    if (surface.triangle_planes[t] == none) continue;
    for (int k = 0; k < 3; ++k) {
      const int other = surface.neighbours[t][idx(k)];
      if (other != none && surface.triangle_planes[idx(other)] == surface.triangle_planes[t]) {
        continue;
      }
      const Triangle& triangle = surface.triangles[t];
      const int from = triangle[idx(k)], to = triangle[idx(next_corner(k))];
      const Vec3 edge = surface.positions[idx(to)] - surface.positions[idx(from)];
      for (const int end : {from, to}) {
        sums[idx(end)] += fourth_power(direction_in_frame(frames, idx(end), edge, 0));
      }
    }
  }
  return sums;
}

// Whether the rim runs along or across the face's cross at a vertex, if it is on a smooth rim: what
// is beyond is ruled along it, too.
bool agrees(const CrossNumber& rim, const CrossNumber& cross) {
  return product(std::conj(cross), rim).real() >= least_rim_cosine * std::abs(rim);
}

}  // namespace

PlaneCrosses plane_crosses(const Surface& surface, const TangentFrames& frames,
                           const CrossNumbers& default_crosses, bool across_objects) {
  PlaneCrosses result{std::vector<int>(frames.size(), none), default_crosses};
  if (surface.planes.empty()) return result;
  const std::vector<Vec3> directions = directions_of(surface.planes, across_objects);
  const std::vector<PlanesAround> around = planes_around_vertices(surface);
  const CrossNumbers rims = rim_crosses(surface, frames);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (!around[i].is_inside() && !around[i].is_on_smooth_rim()) continue;
    const int plane = around[i].most;
    if (plane == none) continue;
    if (!stands_alone(surface.planes[idx(plane)])) continue;
    const Vec3& direction = directions[idx(plane)];
    const bool is_default = direction.isZero();
    const CrossNumber z =
        is_default ? default_crosses[i] : fourth_power(direction_in_frame(frames, i, direction));
    if (!around[i].is_inside() && !around[i].is_beside_strip() && !agrees(rims[i], z)) continue;
    result.planes[i] = plane;
    result.z[i] = z;
  }
  return result;
}

void release_planes(const std::vector<std::uint8_t>& released, std::vector<int>& planes) {
  int last = none;
  for (const int plane : planes) last = std::max(last, plane);
  std::vector<std::uint8_t> is_free(idx(last + 1), 0);
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (planes[i] != none && released[i]) is_free[idx(planes[i])] = 1;
  }
  for (int& plane : planes) {
    if (plane != none && is_free[idx(plane)]) plane = none;
  }
}

}  // namespace illustrate
