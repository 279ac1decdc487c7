#include "visibility/labels/repairs.h"

#include <algorithm>
#include <cstdlib>
#include <limits>

#include "core/segments.h"
#include "visibility/arrangement/joint_touches.h"
#include "visibility/labels/path_arcs.h"

namespace illustrate {
namespace {

constexpr double twist_px = 1.0;
constexpr double wide_twist_px = 2.0;  // without cusps, where it is all that unbalances its path
constexpr double lens_px = 0.3;
constexpr double joint_lens_px = 1.0;  // from a joint to a crossing of two strands that meet there
constexpr int longest_repair = 60;     // points between two crossings that are taken for one

// Where a crossing is met along a path: which strand of it, and which visit of that strand.
struct Stop {
  int path;
  int step;   // index into Path::strands
  int visit;  // index into Arrangement::visits
};

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

// The image points of a path from one stop to a later one.
struct Stretch {
  std::vector<Vec2> points;
  int cusps = 0;
  bool found = false;
};

class Repairer {
 public:
  Repairer(Arrangement& arrangement, double& moved_px)
      : arrangement_(arrangement),
        moved_px_(moved_px),
        path_of_(paths_of_strands(arrangement)),
        step_of_(arrangement.visits.size()) {
    for (const Path& path : arrangement.paths) {
      for (std::size_t i = 0; i < path.strands.size(); ++i) {
        step_of_[idx(path.strands[i])] = static_cast<int>(i);
      }
    }
  }

  int twists() {
    start();
    int dropped = 0;
    for (int c = 0; c < static_cast<int>(arrangement_.crossings.size()); ++c) {
      if (arrangement_.is_live(c) && balances(c) && is_twist(c)) dropped += drop(c);
    }
    arrangement_.forget_visits();
    return dropped;
  }

  // Between a contour and another curve that runs through it, next to their joint;
  // is_odd as in joint_touches.h.
  int touches(std::vector<std::uint8_t>& is_odd) {
    start();
    if (links_.empty()) links_ = short_links(arrangement_);
    int dropped = 0;
    for (std::size_t c = 0; c < arrangement_.crossings.size(); ++c) {
      const int crossing = static_cast<int>(c);
      if (!arrangement_.is_live(crossing) || !is_of_contour(crossing)) continue;
      const int node = joint_behind(crossing);
      if (node == none && !is_beside_end(crossing)) continue;
      dropped += drop(crossing);
      if (node == none) continue;
      const Crossing& x = arrangement_.crossings[c];
      const int curve = is_contour(x.front.strand) ? x.back.strand : x.front.strand;
      const bool is_behind = arrangement_.network->strands[idx(curve)].start_node == node;
      is_odd[2 * idx(node) + (is_behind ? 1 : 0)] ^= 1;
    }
    arrangement_.forget_visits();
    return dropped;
  }

  // Those whose crossings contradict each other.
  int lenses() {
    start();
    int dropped = 0;
    for (int c = 0; c < static_cast<int>(arrangement_.crossings.size()); ++c) {
      if (!arrangement_.is_live(c)) continue;
      const int partner = lens_partner(c);
      if (partner != none && !unbalances(c, partner)) dropped += drop(c) + drop(partner);
    }
    arrangement_.forget_visits();
    return dropped;
  }

 private:
  // stops_[2 c] where crossing c is front, stops_[2 c + 1] where it is back.
  void start() {
    sums_.clear();
    for (const Path& path : arrangement_.paths) sums_.push_back(imbalance(arrangement_, path));
    stops_.assign(2 * arrangement_.crossings.size(), {none, none, none});
    for (std::size_t s = 0; s < arrangement_.visits.size(); ++s) {
      const std::vector<Visit>& visits = arrangement_.visits[s];
      for (std::size_t v = 0; v < visits.size(); ++v) {
        stops_[2 * idx(visits[v].crossing) + (visits[v].front ? 0 : 1)] = {path_of_[s], step_of_[s],
                                                                           static_cast<int>(v)};
      }
    }
  }

  int strand(const Stop& stop) const {
    return arrangement_.paths[idx(stop.path)].strands[idx(stop.step)];
  }
  const Visit& visit(const Stop& stop) const {
    return arrangement_.visits[idx(strand(stop))][idx(stop.visit)];
  }

  int change_at(int c) const { return back_change(arrangement_, arrangement_.crossings[idx(c)]); }

  // How much nearer to balance a path is without a change.
  int gain(int path, int change) const {
    if (!arrangement_.paths[idx(path)].cyclic) return 0;
    const int sum = sums_[idx(path)];
    return std::abs(sum) - std::abs(sum - change);
  }

  // Whether its back path, where closed, comes nearer to balance without a crossing.
  bool balances(int c) const {
    const int path = stops_[2 * idx(c) + 1].path;
    return !arrangement_.paths[idx(path)].cyclic || gain(path, change_at(c)) > 0;
  }

  // Whether closed paths are farther from balance without two crossings.
  bool unbalances(int c, int partner) const {
    const int path = stops_[2 * idx(c) + 1].path, other = stops_[2 * idx(partner) + 1].path;
    const int one = change_at(c), two = change_at(partner);
    if (path == other) return gain(path, one + two) < 0;
    return gain(path, one) + gain(other, two) < 0;
  }

  int drop(int c) {
    sums_[idx(stops_[2 * idx(c) + 1].path)] -= change_at(c);
    arrangement_.states[idx(c)] = CrossingState::dropped;
    return 1;
  }

  // The next stop along the path; visit none where an open path ends.
  Stop next(const Stop& stop) const {
    const Path& path = arrangement_.paths[idx(stop.path)];
    Stop result = stop;
    ++result.visit;
    for (std::size_t guard = 0; guard <= path.strands.size(); ++guard) {
      if (result.visit < static_cast<int>(arrangement_.visits[idx(strand(result))].size()))
        return result;
      const bool last = result.step + 1 == static_cast<int>(path.strands.size());
      if (last && !path.cyclic) break;
      result = {stop.path, last ? 0 : result.step + 1, 0};
    }
    return {stop.path, none, none};
  }

  // Forward from `from` to `to`, which lie on one path; not found when it is longer than a repair
  // may be.
  Stretch stretch(const Stop& from, const Stop& to) const {
    const Path& path = arrangement_.paths[idx(from.path)];
    Stretch result;
    result.points.push_back(arrangement_.crossings[idx(visit(from).crossing)].image);
    int step = from.step, point = visit(from).place.segment + 1;
    bool leads_round = is_after(from, to);
    while (!result.found) {
      const int s = path.strands[idx(step)];
      const bool here = step == to.step && !leads_round;
      const int end = here ? visit(to).place.segment : arrangement_.point_count(s) - 1;
      for (; point <= end; ++point) {
        if (static_cast<int>(result.points.size()) == longest_repair) return result;
        result.points.push_back(arrangement_.image.image[arrangement_.point(s, point)]);
      }
      result.found = here;
      const bool last = step + 1 == static_cast<int>(path.strands.size());
      if (here || (last && !path.cyclic)) break;
      step = last ? 0 : step + 1;
      if (path.jumps[idx(step)] != 0) ++result.cusps;
      point = 0;
      leads_round = false;
    }
    result.points.push_back(arrangement_.crossings[idx(visit(to).crossing)].image);
    return result;
  }

  // Whether `from` lies behind `to` on the same strand, so that the way between them leads round.
  bool is_after(const Stop& from, const Stop& to) const {
    return from.step == to.step && from.visit >= to.visit;
  }

  bool is_contour(int strand) const {
    return arrangement_.network->strands[idx(strand)].kind == Kind::silhouette;
  }

  // Whether one of its two strands is a contour, the other one not.
  bool is_of_contour(int c) const {
    const Crossing& x = arrangement_.crossings[idx(c)];
    return is_contour(x.front.strand) != is_contour(x.back.strand);
  }

  bool is_twist(int c) {
    const Stop a = stops_[2 * idx(c)], b = stops_[2 * idx(c) + 1];
    return a.path == b.path && (is_small_loop(c, a, b) || is_small_loop(c, b, a));
  }

  bool is_small_loop(int c, const Stop& from, const Stop& to) {
    const Stretch way = stretch(from, to);
    if (!way.found || way.cusps > 1) return false;
    const Vec2& centre = arrangement_.crossings[idx(c)].image;
    double reach = 0;
    for (const Vec2& p : way.points) reach = std::max(reach, (p - centre).norm());
    const int sum = way.cusps == 0 ? sums_[idx(from.path)] : 0;
    if (reach > (sum != 0 && sum == change_at(c) ? wide_twist_px : twist_px)) return false;
    moved_px_ = std::max(moved_px_, reach);
    return true;
  }

  // The crossing that forms a thin lens with c, front and back exchanged; none if there is none.
  int lens_partner(int c) {
    for (const std::size_t role : {0U, 1U}) {
      const Stop here = stops_[2 * idx(c) + role];
      const Stop there = next(here);
      if (there.visit == none) continue;
      const int partner = visit(there).crossing;
      if (partner == c || !arrangement_.is_live(partner)) continue;
      const bool same_role = visit(there).front == (role == 0);
      if (same_role) continue;
      const Stop other_here = stops_[2 * idx(c) + 1 - role];
      const Stop other_there = stops_[2 * idx(partner) + (visit(there).front ? 1 : 0)];
      if (is_thin(here, there, other_here, other_there)) return partner;
    }
    return none;
  }

  bool is_thin(const Stop& a, const Stop& b, const Stop& c, const Stop& d) {
    if (c.path != d.path) return false;
    const bool forward = same(next(c), d), backward = same(next(d), c);
    if (!forward && !backward) return false;
    const Stretch one = stretch(a, b);  // two crossings of closed curves are both
    return (forward && is_thin(one, stretch(c, d), lens_px)) ||
           (backward && is_thin(one, stretch(d, c), lens_px));
  }

  // The joint that both strands run into from the crossing, close together and without crossing
  // each other again; none where they do not.
  int joint_behind(int c) {
    const Stop a = stops_[2 * idx(c)], b = stops_[2 * idx(c) + 1];
    for (const bool a_forward : {true, false}) {
      for (const bool b_forward : {true, false}) {
        const int node = end_node(a, a_forward);
        if (node == none || node != end_node(b, b_forward)) continue;
        const Stretch one = way_to_end(a, a_forward), two = way_to_end(b, b_forward);
        if (!one.found || !two.found || meets_behind(a, a_forward, strand(b))) continue;
        if (is_thin(one, two, joint_lens_px)) return node;
      }
    }
    return none;
  }

  // Whether both strands run, close together, into the two ends of a third one that is no longer
  // than a touch: a contour ends on a feature curve just beside a node of that, or beside a cusp.
  bool is_beside_end(int c) {
    const Stop a = stops_[2 * idx(c)], b = stops_[2 * idx(c) + 1];
    for (const bool a_forward : {true, false}) {
      for (const bool b_forward : {true, false}) {
        const int from = end_node(a, a_forward), to = end_node(b, b_forward);
        if (from == none || to == none || !is_linked(from, to)) continue;
        Stretch one = way_to_end(a, a_forward), two = way_to_end(b, b_forward);
        if (!one.found || !two.found) continue;
        one.points.push_back(two.points.back());
        if (is_thin(one, two, joint_lens_px)) return true;
      }
    }
    return false;
  }

  bool is_linked(int from, int to) const {
    const std::pair<int, int> link = std::minmax(from, to);
    return std::binary_search(links_.begin(), links_.end(), link);
  }

  int end_node(const Stop& stop, bool forward) const {
    const Strand& s = arrangement_.network->strands[idx(strand(stop))];
    return forward ? s.end_node : s.start_node;
  }

  // Whether a strand crosses another one between a stop and the strand's end (start).
  bool meets_behind(const Stop& stop, bool forward, int other) const {
    const std::vector<Visit>& visits = arrangement_.visits[idx(strand(stop))];
    const int last = static_cast<int>(visits.size()) - 1;
    for (int v = forward ? stop.visit + 1 : 0; v <= (forward ? last : stop.visit - 1); ++v) {
      const Crossing& x = arrangement_.crossings[idx(visits[idx(v)].crossing)];
      if ((visits[idx(v)].front ? x.back : x.front).strand == other) return true;
    }
    return false;
  }

  Stretch way_to_end(const Stop& stop, bool forward) const {
    Stretch result;
    const StrandPlace& place = visit(stop).place;
    const int first = forward ? place.segment + 1 : 0;
    const int last = forward ? arrangement_.point_count(strand(stop)) - 1 : place.segment;
    result.found = last - first < longest_repair;
    result.points.push_back(arrangement_.crossings[idx(visit(stop).crossing)].image);
    for (int k = 0; result.found && k <= last - first; ++k) {
      const int i = forward ? first + k : last - k;
      result.points.push_back(arrangement_.image.image[arrangement_.point(strand(stop), i)]);
    }
    return result;
  }

  bool is_thin(const Stretch& one, const Stretch& two, double limit_px) {
    if (!one.found || !two.found) return false;
    const double gap = std::max(farthest(one.points, two.points), farthest(two.points, one.points));
    if (gap > limit_px) return false;
    moved_px_ = std::max(moved_px_, gap);
    return true;
  }

  static bool same(const Stop& a, const Stop& b) {
    return a.path == b.path && a.step == b.step && a.visit == b.visit;
  }

  Arrangement& arrangement_;
  double& moved_px_;
  std::vector<int> path_of_;
  std::vector<int> step_of_;
  std::vector<Stop> stops_;
  std::vector<std::pair<int, int>> links_;
  std::vector<int> sums_;  // (paths) of their changes; closed ones should have 0
};

}  // namespace

int drop_twists_and_lenses(Arrangement& arrangement, double& moved_px) {
  Repairer repairer(arrangement, moved_px);
  int total = 0;
  for (int round = 0; round < 4; ++round) {
    const int dropped = repairer.twists() + repairer.lenses();
    total += dropped;
    if (dropped == 0) break;
  }
  return total;
}

int drop_touches(Arrangement& arrangement, double& moved_px) {
  Repairer repairer(arrangement, moved_px);
  std::vector<std::uint8_t> is_odd(2 * arrangement.network->nodes.size(), 0);
  int total = 0;
  for (int dropped = repairer.touches(is_odd); dropped > 0; dropped = repairer.touches(is_odd)) {
    total += dropped;
  }
  return total + drop_touches_past_nodes(arrangement, is_odd, moved_px);
}

}  // namespace illustrate
