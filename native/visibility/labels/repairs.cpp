#include "visibility/labels/repairs.h"

#include <algorithm>
#include <cstdlib>

#include "visibility/arrangement/joint_touches.h"
#include "visibility/labels/path_arcs.h"
#include "visibility/labels/path_stops.h"
#include "visibility/reaches.h"

namespace illustrate {
namespace {

constexpr std::array<Direction, 2> directions{Direction::forward, Direction::backward};

using NodePairs = std::vector<std::pair<int, int>>;

// One look at all crossings, in their order. What goes is taken from the arrangement after it: what
// lies between two crossings is then the same for all of them, only how far paths are from balance
// follows at once.
class Round {
 public:
  Round(const Arrangement& arrangement, double& moved_px)
      : arrangement_(arrangement),
        stops_(arrangement),
        moved_px_(moved_px),
        is_gone_(arrangement.crossings().size(), 0) {
    for (const Path& path : arrangement.paths()) sums_.push_back(imbalance(arrangement, path));
  }

  std::vector<int> twists() {
    for (int c = 0; c < count(); ++c) {
      if (is_left(c) && balances(c) && is_twist(c)) drop(c);
    }
    return std::move(dropped_);
  }

  // Those whose crossings contradict each other.
  std::vector<int> lenses() {
    for (int c = 0; c < count(); ++c) {
      if (!is_left(c)) continue;
      const int partner = lens_partner(c);
      if (partner == none || unbalances(c, partner)) continue;
      drop(c);
      drop(partner);
    }
    return std::move(dropped_);
  }

  // Between a contour and another curve that runs through it, next to their joint;
  // is_odd as in joint_touches.h.
  std::vector<int> touches(const NodePairs& links, std::vector<std::uint8_t>& is_odd) {
    for (int c = 0; c < count(); ++c) {
      if (!is_left(c) || !is_of_contour(c)) continue;
      const int node = joint_behind(c);
      if (node == none && !is_beside_end(c, links)) continue;
      drop(c);
      if (node != none) is_odd[2 * idx(node) + (starts_behind(c, node) ? 1 : 0)] ^= 1;
    }
    return std::move(dropped_);
  }

 private:
  int count() const { return static_cast<int>(is_gone_.size()); }
  bool is_left(int c) const { return arrangement_.is_live(c) && !is_gone_[idx(c)]; }

  void drop(int c) {
    sums_[idx(stops_.back(c).path)] -= change_at(c);
    is_gone_[idx(c)] = 1;
    dropped_.push_back(c);
  }

  // --- Balance ---

  int change_at(int c) const { return back_change(arrangement_, arrangement_.crossing(c)); }

  // How much nearer to balance a path is without a change.
  int gain(int path, int change) const {
    if (!arrangement_.paths()[idx(path)].cyclic) return 0;
    const int sum = sums_[idx(path)];
    return std::abs(sum) - std::abs(sum - change);
  }

  // Whether its back path, where closed, comes nearer to balance without a crossing.
  bool balances(int c) const {
    const int path = stops_.back(c).path;
    return !arrangement_.paths()[idx(path)].cyclic || gain(path, change_at(c)) > 0;
  }

  // Whether closed paths are farther from balance without two crossings.
  bool unbalances(int c, int partner) const {
    const int path = stops_.back(c).path, other = stops_.back(partner).path;
    const int one = change_at(c), two = change_at(partner);
    if (path == other) return gain(path, one + two) < 0;
    return gain(path, one) + gain(other, two) < 0;
  }

  // --- Twists and lenses ---

  bool is_twist(int c) {
    const Stop &a = stops_.front(c), &b = stops_.back(c);
    return a.path == b.path && (is_small_loop(c, a, b) || is_small_loop(c, b, a));
  }

  bool is_small_loop(int c, const Stop& from, const Stop& to) {
    const Stretch way = stops_.stretch(from, to);
    if (!way.found || way.cusps > 1) return false;
    const Vec2& centre = arrangement_.crossing(c).image;
    double reach = 0;
    for (const Vec2& p : way.points) reach = std::max(reach, (p - centre).norm());
    const int sum = way.cusps == 0 ? sums_[idx(from.path)] : 0;
    if (reach > (sum != 0 && sum == change_at(c) ? reaches.wide_twist : reaches.twist))
      return false;
    moved_px_ = std::max(moved_px_, reach);
    return true;
  }

  // The crossing that forms a thin lens with c, front and back exchanged; none if there is none.
  // It is looked for along the front strand first.
  int lens_partner(int c) {
    for (const bool in_front : {true, false}) {
      const Stop& here = in_front ? stops_.front(c) : stops_.back(c);
      const Stop there = stops_.next(here);
      if (there.visit == none) continue;
      const int partner = stops_.visit(there).crossing;
      if (partner == c || !is_left(partner) || stops_.visit(there).front == in_front) continue;
      const Stop& other_here = in_front ? stops_.back(c) : stops_.front(c);
      const Stop& other_there = in_front ? stops_.front(partner) : stops_.back(partner);
      if (is_thin_lens(here, there, other_here, other_there)) return partner;
    }
    return none;
  }

  bool is_thin_lens(const Stop& a, const Stop& b, const Stop& c, const Stop& d) {
    if (c.path != d.path) return false;
    const bool forward = stops_.next(c) == d, backward = stops_.next(d) == c;
    if (!forward && !backward) return false;
    const Stretch one = stops_.stretch(a, b);  // two crossings of closed curves are both
    return (forward && are_close(one, stops_.stretch(c, d), reaches.lens)) ||
           (backward && are_close(one, stops_.stretch(d, c), reaches.lens));
  }

  bool are_close(const Stretch& one, const Stretch& two, double limit_px) {
    const double gap = gap_px(one, two);
    if (gap > limit_px) return false;
    moved_px_ = std::max(moved_px_, gap);
    return true;
  }

  // --- Touches ---

  bool is_contour(int strand) const { return arrangement_.strand(strand).kind == Kind::silhouette; }

  // Whether one of its two strands is a contour, the other one not.
  bool is_of_contour(int c) const {
    const Crossing& x = arrangement_.crossing(c);
    return is_contour(x.front.strand) != is_contour(x.back.strand);
  }

  // Whether the strand that is no contour starts at a node.
  bool starts_behind(int c, int node) const {
    const Crossing& x = arrangement_.crossing(c);
    const int curve = is_contour(x.front.strand) ? x.back.strand : x.front.strand;
    return arrangement_.strand(curve).start_node == node;
  }

  // The joint that both strands run into from the crossing, close together and without crossing
  // each other again; none where they do not.
  int joint_behind(int c) {
    const Stop &a = stops_.front(c), &b = stops_.back(c);
    for (const Direction of_a : directions) {
      for (const Direction of_b : directions) {
        const int node = stops_.end_node(a, of_a);
        if (node == none || node != stops_.end_node(b, of_b)) continue;
        const Stretch one = stops_.stretch_to_end(a, of_a), two = stops_.stretch_to_end(b, of_b);
        if (!one.found || !two.found || stops_.crosses_before_end(a, of_a, stops_.strand(b)))
          continue;
        if (are_close(one, two, reaches.joint_lens)) return node;
      }
    }
    return none;
  }

  // Whether both strands run, close together, into the two ends of a third one that is no longer
  // than a touch: a contour ends on a feature curve just beside a node of that, or beside a cusp.
  bool is_beside_end(int c, const NodePairs& links) {
    const Stop &a = stops_.front(c), &b = stops_.back(c);
    for (const Direction of_a : directions) {
      for (const Direction of_b : directions) {
        const int from = stops_.end_node(a, of_a), to = stops_.end_node(b, of_b);
        const bool are_linked = from != none && to != none &&
                                std::binary_search(links.begin(), links.end(),
                                                   std::pair<int, int>(std::minmax(from, to)));
        if (!are_linked) continue;
        Stretch one = stops_.stretch_to_end(a, of_a);
        const Stretch two = stops_.stretch_to_end(b, of_b);
        if (!one.found || !two.found) continue;
        one.points.push_back(two.points.back());
        if (are_close(one, two, reaches.joint_lens)) return true;
      }
    }
    return false;
  }

  const Arrangement& arrangement_;
  const PathStops stops_;
  double& moved_px_;
  std::vector<std::uint8_t> is_gone_;  // (crossings)
  std::vector<int> dropped_;
  std::vector<int> sums_;  // (paths) of their changes; closed ones should have 0
};

// Takes crossings away; their number.
int without(Arrangement& arrangement, const std::vector<int>& crossings) {
  arrangement.drop(crossings);
  return static_cast<int>(crossings.size());
}

}  // namespace

int drop_twists_and_lenses(Arrangement& arrangement, double& moved_px) {
  int total = 0;
  // What is dropped may leave a new lens or loop behind; a knot that takes more rounds is not made
  // by chance.
  for (int round = 0; round < 4; ++round) {
    int dropped = without(arrangement, Round(arrangement, moved_px).twists());
    dropped += without(arrangement, Round(arrangement, moved_px).lenses());
    total += dropped;
    if (dropped == 0) break;
  }
  return total;
}

int drop_touches(Arrangement& arrangement, double& moved_px) {
  std::vector<std::uint8_t> is_odd(2 * arrangement.network().nodes.size(), 0);
  const NodePairs links = short_links(arrangement);
  int total = 0;
  for (int dropped = 1; dropped > 0; total += dropped) {
    dropped = without(arrangement, Round(arrangement, moved_px).touches(links, is_odd));
  }
  return total + drop_touches_past_nodes(arrangement, is_odd, moved_px);
}

}  // namespace illustrate
