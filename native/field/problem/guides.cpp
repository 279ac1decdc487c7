#include "field/problem/guides.h"

#include <algorithm>
#include <queue>

#include "core/ragged.h"

namespace illustrate {
namespace {

// From a guide to the surface, and along a guide that is farther away; of the scene's diagonal.
constexpr double guide_reach = 0.05;
constexpr double step_beyond_reach = 0.01;

// Samples of a guide: two for the shortest side of the triangle they fall on, but no more than this
// for a guide.
constexpr double samples_per_side = 2;
constexpr double most_samples = 20000;

// A projection shorter than this (of unit length before) has no direction to speak of.
constexpr double least_guide_projection = 0.2;

double length_of(const Points& points) {
  double length = 0;
  for (std::size_t k = 1; k < points.size(); ++k) length += (points[k] - points[k - 1]).norm();
  return length;
}

double shortest_side(const Surface& surface, int triangle) {
  const Triangle& t = surface.triangles[idx(triangle)];
  double shortest = std::numeric_limits<double>::max();
  for (int k = 0; k < 3; ++k) {
    const Vec3& a = surface.positions[idx(t[idx(k)])];
    shortest = std::min(shortest, (surface.positions[idx(t[idx(next_corner(k))])] - a).norm());
  }
  return shortest;
}

// Adds up the directions of one guide at the vertices that it passes.
class Tracer {
 public:
  Tracer(const Surface& surface, const TangentFrames& frames, const Bvh& bvh)
      : surface_(surface),
        frames_(frames),
        bvh_(bvh),
        sums_(frames.size(), 0),
        weights_(frames.size(), 0) {}

  void trace(const Guide& guide, const Progress& progress) {
    const double length = length_of(guide.points);
    if (!std::isfinite(length)) return;
    const double least_step = length / most_samples;
    for (std::size_t k = 1; k < guide.points.size(); ++k) {
      progress.report(static_cast<double>(k) / static_cast<double>(guide.points.size()));
      trace_segment(guide.points[k - 1], guide.points[k], least_step);
    }
  }

  // Moves what was added up since the last time to `pulls`: `weight` at each vertex, less where the
  // guide's own directions contradict each other.
  void flush(double weight, CrossNumbers& pulls) {
    for (const std::size_t i : touched_) {
      if (weights_[i] > 0) pulls[i] += weight / weights_[i] * sums_[i];
      sums_[i] = weights_[i] = 0;
    }
    touched_.clear();
  }

 private:
  void trace_segment(const Vec3& from, const Vec3& to, double least_step) {
    const double length = (to - from).norm();
    if (!(length > 0)) return;
    const Vec3 along = (to - from) / length;
    for (double at = 0; at <= length;) {
      const SurfacePoint foot = bvh_.nearest(from + at * along, guide_reach * surface_.diagonal);
      const double wanted = foot.triangle == none
                                ? step_beyond_reach * surface_.diagonal
                                : shortest_side(surface_, foot.triangle) / samples_per_side;
      const double step =
          std::min(std::max(least_step, wanted), at < length ? length - at : length);
      if (foot.triangle != none) add(foot, along, step);
      at += step;
    }
  }

  void add(const SurfacePoint& at, const Vec3& along, double length) {
    for (const int vertex : surface_.triangles[idx(at.triangle)]) {
      const std::size_t i = idx(vertex);
      const CrossNumber direction =
          direction_in_frame(frames_, i, along, 0, least_guide_projection);
      if (direction == CrossNumber(0)) continue;
      sums_[i] += length * fourth_power(direction);
      weights_[i] += length;
      touched_.push_back(i);
    }
  }

  const Surface& surface_;
  const TangentFrames& frames_;
  const Bvh& bvh_;
  CrossNumbers sums_;
  std::vector<double> weights_;
  std::vector<std::size_t> touched_;
};

Ragged<int> neighbours_of_vertices(const Surface& surface) {
  return sorted_into<int>(surface.positions.size(), [&](const auto& put) {
    for (const Triangle& t : surface.triangles) {
      for (int k = 0; k < 3; ++k) {
        put(t[idx(k)], t[idx(next_corner(k))]);
        put(t[idx(k)], t[idx(previous_corner(k))]);
      }
    }
  });
}

}  // namespace

CrossNumbers guide_pulls(const Surface& surface, const TangentFrames& frames, const Bvh& bvh,
                         const std::vector<Guide>& guides, const Progress& progress) {
  CrossNumbers pulls(frames.size(), 0);
  Tracer tracer(surface, frames, bvh);
  for (std::size_t g = 0; g < guides.size(); ++g) {
    const double count = static_cast<double>(guides.size());
    tracer.trace(guides[g],
                 progress.part(static_cast<double>(g) / count, static_cast<double>(g + 1) / count));
    tracer.flush(guides[g].weight, pulls);
  }
  return pulls;
}

std::vector<std::uint8_t> near_pulls(const Surface& surface, const CrossNumbers& pulls,
                                     const std::vector<double>& diagonals, double radius) {
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  std::vector<double> distances(pulls.size(), std::numeric_limits<double>::max());
  for (std::size_t i = 0; i < pulls.size(); ++i) {
    if (pulls[i] == CrossNumber(0)) continue;
    distances[i] = 0;
    queue.push({0, static_cast<int>(i)});
  }
  const Ragged<int> neighbours = neighbours_of_vertices(surface);
  std::vector<std::uint8_t> is_near(pulls.size(), 0);
  while (!queue.empty()) {
    const auto [distance, vertex] = queue.top();
    queue.pop();
    if (is_near[idx(vertex)]) continue;
    is_near[idx(vertex)] = 1;
    for (const int other : neighbours[idx(vertex)]) {
      const Vec3 edge = surface.positions[idx(other)] - surface.positions[idx(vertex)];
      const double there = distance + edge.norm();
      if (!(there < distances[idx(other)]) || there > radius * diagonals[idx(other)]) continue;
      distances[idx(other)] = there;
      queue.push({there, other});
    }
  }
  return is_near;
}

}  // namespace illustrate
