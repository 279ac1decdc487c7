#include "visibility/labels/path_stops.h"

#include <algorithm>

#include "core/segments.h"

namespace illustrate {
namespace {

// Points between two crossings that are taken for one: a pixel of a curve has a few, and what has
// more is no repair, but would be looked at for long.
constexpr int longest_repair = 60;

double distance_to_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
  return (p - a - nearest_share(a, b, p) * (b - a)).norm();
}

double farthest(const std::vector<Vec2>& from, const std::vector<Vec2>& to) {
  double result = 0;
  for (const Vec2& p : from) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < to.size(); ++i) {
      nearest = std::min(nearest, distance_to_segment(p, to[i], to[i + 1]));
    }
    result = std::max(result, nearest);
  }
  return result;
}

// Whether `from` lies behind `to` on the same strand, so that the way between them leads round.
bool is_after(const Stop& from, const Stop& to) {
  return from.step == to.step && from.visit >= to.visit;
}

}  // namespace

double gap_px(const Stretch& one, const Stretch& two) {
  if (!one.found || !two.found) return std::numeric_limits<double>::infinity();
  return std::max(farthest(one.points, two.points), farthest(two.points, one.points));
}

PathStops::PathStops(const Arrangement& arrangement)
    : arrangement_(arrangement), stops_(2 * arrangement.crossings().size(), {none, none, none}) {
  for (std::size_t p = 0; p < arrangement.paths().size(); ++p) {
    const std::vector<int>& strands = arrangement.paths()[p].strands;
    for (std::size_t i = 0; i < strands.size(); ++i) {
      const std::vector<Visit>& visits = arrangement.visits(strands[i]);
      for (std::size_t v = 0; v < visits.size(); ++v) {
        stops_[2 * idx(visits[v].crossing) + (visits[v].front ? 0 : 1)] = {
            static_cast<int>(p), static_cast<int>(i), static_cast<int>(v)};
      }
    }
  }
}

Stop PathStops::next(const Stop& stop) const {
  const Path& path = arrangement_.paths()[idx(stop.path)];
  Stop result = stop;
  ++result.visit;
  // Once round at most: a closed path may have this stop alone.
  for (std::size_t guard = 0; guard <= path.strands.size(); ++guard) {
    if (result.visit < static_cast<int>(arrangement_.visits(strand(result)).size())) return result;
    const bool last = result.step + 1 == static_cast<int>(path.strands.size());
    if (last && !path.cyclic) break;
    result = {stop.path, last ? 0 : result.step + 1, 0};
  }
  return {stop.path, none, none};
}

Stretch PathStops::stretch(const Stop& from, const Stop& to) const {
  const Path& path = arrangement_.paths()[idx(from.path)];
  Stretch result;
  result.points.push_back(image(from));
  int step = from.step, point = visit(from).place.segment + 1;
  bool leads_round = is_after(from, to);
  while (!result.found) {
    const int s = path.strands[idx(step)];
    const bool here = step == to.step && !leads_round;
    const int end = here ? visit(to).place.segment : arrangement_.point_count(s) - 1;
    for (; point <= end; ++point) {
      if (static_cast<int>(result.points.size()) == longest_repair) return result;
      result.points.push_back(arrangement_.image_of(s, point));
    }
    result.found = here;
    const bool last = step + 1 == static_cast<int>(path.strands.size());
    if (here || (last && !path.cyclic)) break;
    step = last ? 0 : step + 1;
    if (path.jumps[idx(step)] != 0) ++result.cusps;
    point = 0;
    leads_round = false;
  }
  result.points.push_back(image(to));
  return result;
}

Stretch PathStops::stretch_to_end(const Stop& stop, Direction direction) const {
  Stretch result;
  const bool forward = direction == Direction::forward;
  const StrandPlace& place = visit(stop).place;
  const int first = forward ? place.segment + 1 : 0;
  const int last = forward ? arrangement_.point_count(strand(stop)) - 1 : place.segment;
  result.found = last - first < longest_repair;
  result.points.push_back(image(stop));
  for (int k = 0; result.found && k <= last - first; ++k) {
    result.points.push_back(arrangement_.image_of(strand(stop), forward ? first + k : last - k));
  }
  return result;
}

int PathStops::end_node(const Stop& stop, Direction direction) const {
  const Strand& s = arrangement_.strand(strand(stop));
  return direction == Direction::forward ? s.end_node : s.start_node;
}

bool PathStops::crosses_before_end(const Stop& stop, Direction direction, int other) const {
  const std::vector<Visit>& visits = arrangement_.visits(strand(stop));
  const bool forward = direction == Direction::forward;
  const auto from = visits.begin() + (forward ? stop.visit + 1 : 0);
  const auto to = forward ? visits.end() : visits.begin() + stop.visit;
  return std::any_of(from, to, [&](const Visit& visit) {
    const Crossing& x = arrangement_.crossing(visit.crossing);
    return (visit.front ? x.back : x.front).strand == other;
  });
}

}  // namespace illustrate
