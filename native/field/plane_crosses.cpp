#include "field/plane_crosses.h"

#include <algorithm>
#include <limits>

#include "field/coplanar.h"

namespace illustrate {
namespace {

// Share of the rim that has to run along or across a direction. A circle of chords has .1, a regular
// pentagon .2; where a face goes on smoothly its rim has to be clearer than what is beyond.
constexpr double clear_sharp = 0.19, clear_smooth = 0.5;

// Of four times the angle between a rim and the cross, about 5 degrees.
constexpr double least_rim_cosine = 0.94;

bool is_clear(const PlaneFace& plane) {
  return plane.agreement >= (plane.ends_sharply ? clear_sharp : clear_smooth);
}

// (planes) the clear one of each one's group of which most rim asks for its direction; none where
// none is clear.
std::vector<int> leaders(const std::vector<PlaneFace>& planes, bool across_objects) {
  const std::vector<int> groups = coplanar_groups(planes, across_objects);
  const auto strength = [&](int p) {
    return planes[idx(p)].agreement * planes[idx(p)].rim_length;
  };
  std::vector<int> of_group(planes.size(), none);
  for (int p = 0; p < static_cast<int>(planes.size()); ++p) {
    int& leader = of_group[idx(groups[idx(p)])];
    if (!is_clear(planes[idx(p)])) continue;
    if (leader == none || strength(p) > strength(leader)) leader = p;
  }
  std::vector<int> result;
  for (const int group : groups) result.push_back(of_group[idx(group)]);
  return result;
}

// Of the triangles at a vertex: the lowest and the highest face, or none.
struct PlanesAround {
  int least = std::numeric_limits<int>::max(), most = none;

  void add(int plane) {
    least = std::min(least, plane);
    most = std::max(most, plane);
  }
  bool is_inside() const { return least == most; }
  bool is_on_smooth_rim() const { return least == none && most != none; }
};

std::vector<PlanesAround> planes_around_vertices(const Surface& surface) {
  std::vector<PlanesAround> around(surface.positions.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    for (const int vertex : surface.triangles[t]) {
      around[idx(vertex)].add(surface.triangle_planes[t]);
    }
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
  const std::vector<int> leader_of = leaders(surface.planes, across_objects);
  const std::vector<PlanesAround> around = planes_around_vertices(surface);
  const CrossNumbers rims = rim_crosses(surface, frames);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (!around[i].is_inside() && !around[i].is_on_smooth_rim()) continue;
    const int plane = around[i].most;
    if (plane == none) continue;
    const PlaneFace& face = surface.planes[idx(plane)];
    if (!face.ends_sharply && !is_clear(face)) continue;
    const int leader = leader_of[idx(plane)];
    CrossNumber z = default_crosses[i];
    if (leader != none) {
      z = fourth_power(direction_in_frame(frames, i, surface.planes[idx(leader)].direction));
    }
    if (!around[i].is_inside() && !agrees(rims[i], z)) continue;
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
