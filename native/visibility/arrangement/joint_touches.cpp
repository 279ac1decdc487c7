#include "visibility/arrangement/joint_touches.h"

#include <algorithm>

#include "visibility/labels/repairs.h"

namespace illustrate {
namespace {

constexpr double reach_px = 1.0;
constexpr int most_strands = 8;  // that a way from a joint runs over

// Whether u lies between a and b, counter-clockwise.
bool is_between(const Vec2& a, const Vec2& u, const Vec2& b) {
  const bool left_of_a = cross(a, u) > 0, right_of_b = cross(u, b) > 0;
  return cross(a, b) > 0 ? left_of_a && right_of_b : left_of_a || right_of_b;
}

class JointTouches {
 public:
  explicit JointTouches(const Arrangement& arrangement)
      : arrangement_(arrangement),
        network_(*arrangement.network),
        ties_(network_.nodes.size()),
        next_(network_.strands.size(), none),
        previous_(network_.strands.size(), none) {
    for (const Tie& tie : network_.ties) {
      ties_[idx(tie.node)].push_back(tie);
      next_[idx(tie.a)] = tie.b;
      previous_[idx(tie.b)] = tie.a;
    }
  }

  // Whether a contour and another kind of curve run through a node.
  bool is_of_contour(std::size_t node) const {
    const std::vector<Tie>& ties = ties_[node];
    return ties.size() == 2 && is_contour(ties[0]) != is_contour(ties[1]);
  }

  // Whether the curve through the contour is, before (half 0) or behind (half 1) the node, on the
  // side of the contour where its surface is not.
  bool leaves_surface(std::size_t node, std::size_t half) const {
    const Tie &s = contour(node), &t = other(node);
    const Vec2 in = direction(s.a, false), out = direction(s.b, true);
    const Vec2 along = half == 0 ? direction(t.a, false) : direction(t.b, true);
    if (along.isZero(0)) return false;
    const Strand& strand = network_.strands[idx(s.b)];
    return is_between(in, along, out) == (strand.left_layers > strand.right_layers);
  }

  // The nearest crossing of that half with the contour, none if there is none.
  int nearest_crossing(std::size_t node, std::size_t half, double& distance_px) const {
    std::vector<int> on_contour, on_half;
    for (const bool forward : {false, true}) collect(contour(node), forward, on_contour);
    collect(other(node), half == 1, on_half);
    int nearest = none;
    for (const int c : on_half) {
      if (std::find(on_contour.begin(), on_contour.end(), c) == on_contour.end()) continue;
      const double distance =
          (arrangement_.crossings[idx(c)].image - image_of(contour(node))).norm();
      if (nearest != none && distance >= distance_px) continue;
      nearest = c;
      distance_px = distance;
    }
    return nearest;
  }

  // Whether that half runs off over the tip of a cusp beside the node, which is on the cusp's far
  // strand.
  bool runs_over_cusp(std::size_t node, std::size_t half) const {
    const Tie &s = contour(node), &t = other(node);
    const Vec2 along = half == 0 ? direction(t.a, false) : direction(t.b, true);
    for (const bool forward : {false, true}) {
      const int strand = forward ? s.b : s.a;
      const Strand& way = network_.strands[idx(strand)];
      const int cusp = forward ? way.end_node : way.start_node;
      if (network_.nodes[idx(cusp)].kind != NodeKind::cusp || ties_[idx(cusp)].size() != 1)
        continue;
      const Vec2& tip = arrangement_.image.image[point(strand, 0, !forward)];
      const Vec2 to_tip = tip - image_of(s);
      // Along the far strand to the cusp the way comes nearer to the viewer, away from it recedes.
      const bool is_far = ties_[idx(cusp)][0].jump == (forward ? -1 : 1);
      if (is_far && is_near(tip, image_of(s)) &&
          to_tip.x() * along.x() - to_tip.y() * along.y() > 0)
        return true;
    }
    return false;
  }

  const Tie& other(std::size_t node) const {
    return ties_[node][is_contour(ties_[node][0]) ? 1 : 0];
  }

 private:
  bool is_contour(const Tie& tie) const {
    return network_.strands[idx(tie.a)].kind == Kind::silhouette;
  }

  const Tie& contour(std::size_t node) const {
    return ties_[node][is_contour(ties_[node][0]) ? 0 : 1];
  }

  const Vec2& image_of(const Tie& tie) const {
    return arrangement_.image.image[arrangement_.point(tie.b, 0)];
  }

  // Point i of a strand from its start or from its end.
  std::size_t point(int strand, int i, bool forward) const {
    return arrangement_.point(strand, forward ? i : arrangement_.point_count(strand) - 1 - i);
  }

  // From a strand's end to the first point elsewhere on the grid.
  Vec2 direction(int strand, bool forward) const {
    const std::vector<GridPoint>& grid = arrangement_.image.grid;
    const GridPoint& from = grid[point(strand, 0, forward)];
    for (int i = 1; i < arrangement_.point_count(strand); ++i) {
      const GridPoint& to = grid[point(strand, i, forward)];
      if (to.x == from.x && to.y == from.y) continue;
      return Vec2(static_cast<double>(to.x - from.x), static_cast<double>(to.y - from.y));
    }
    return Vec2::Zero();
  }

  void collect(const Tie& tie, bool forward, std::vector<int>& found) const {
    int strand = forward ? tie.b : tie.a;
    for (int k = 0; k < most_strands && strand != none; ++k) {
      if (!collect(strand, forward, image_of(tie), found)) break;
      strand = forward ? next_[idx(strand)] : previous_[idx(strand)];
    }
  }

  // Live crossings on the way along a strand while it stays near; whether it does to its end.
  bool collect(int strand, bool forward, const Vec2& centre, std::vector<int>& found) const {
    const std::vector<Visit>& visits = arrangement_.visits[idx(strand)];
    const int segments = arrangement_.point_count(strand) - 1;
    for (int i = 0; i < segments; ++i) {
      const int segment = forward ? i : segments - 1 - i;
      for (const Visit& visit : visits) {
        const bool is_here = visit.place.segment == segment && arrangement_.is_live(visit.crossing);
        if (is_here && is_near(arrangement_.crossings[idx(visit.crossing)].image, centre))
          found.push_back(visit.crossing);
      }
      if (!is_near(arrangement_.image.image[point(strand, i + 1, forward)], centre)) return false;
    }
    return true;
  }

  static bool is_near(const Vec2& p, const Vec2& centre) { return (p - centre).norm() <= reach_px; }

  const Arrangement& arrangement_;
  const CurveNetwork& network_;
  std::vector<std::vector<Tie>> ties_;  // (nodes)
  std::vector<int> next_;               // (strands)
  std::vector<int> previous_;           // (strands)
};

// Turns round what changes where a strand starts.
void turn_jump(Arrangement& arrangement, int strand) {
  for (Path& path : arrangement.paths) {
    const auto found = std::find(path.strands.begin(), path.strands.end(), strand);
    if (found == path.strands.end()) continue;
    int& jump = path.jumps[static_cast<std::size_t>(found - path.strands.begin())];
    jump = -jump;
  }
}

// A cusp's strand that is not told from where its contour ends.
bool is_end_of_no_length(const Arrangement& arrangement, const Path& path, int strand) {
  return !path.cyclic && path.strands.size() > 1 &&
         (strand == path.strands.front() || strand == path.strands.back()) &&
         arrangement.reach_px(strand) <= end_px;
}

bool is_link(const Arrangement& arrangement, const Path& path, int index) {
  const Strand& strand = arrangement.network->strands[idx(index)];
  if (strand.start_node == strand.end_node) return false;  // closed, too
  if (strand.kind == Kind::intersection) return false;
  if (strand.kind == Kind::silhouette) return is_end_of_no_length(arrangement, path, index);
  return arrangement.reach_px(index) <= reach_px;
}

}  // namespace

std::vector<std::pair<int, int>> short_links(const Arrangement& arrangement) {
  std::vector<std::pair<int, int>> links;
  for (const Path& path : arrangement.paths) {
    for (const int s : path.strands) {
      if (!is_link(arrangement, path, s)) continue;
      const Strand& strand = arrangement.network->strands[idx(s)];
      links.emplace_back(std::minmax(strand.start_node, strand.end_node));
    }
  }
  std::sort(links.begin(), links.end());
  return links;
}

int drop_touches_past_nodes(Arrangement& arrangement, const std::vector<std::uint8_t>& is_odd,
                            double& moved_px) {
  const JointTouches joints(arrangement);
  int dropped = 0;
  for (std::size_t i = 0; i < is_odd.size(); ++i) {
    const std::size_t node = i / 2, half = i % 2;
    if (!joints.is_of_contour(node) || joints.leaves_surface(node, half) == (is_odd[i] != 0))
      continue;
    double distance_px = 0;
    const int crossing = is_odd[i] ? none : joints.nearest_crossing(node, half, distance_px);
    if (crossing == none) {
      if (joints.runs_over_cusp(node, half)) turn_jump(arrangement, joints.other(node).b);
      continue;
    }
    arrangement.states[idx(crossing)] = CrossingState::dropped;
    moved_px = std::max(moved_px, distance_px);
    ++dropped;
  }
  arrangement.forget_visits();
  return dropped;
}

}  // namespace illustrate
