#include "visibility/arrangement/joint_touches.h"

#include <algorithm>

#include "visibility/reaches.h"

namespace illustrate {
namespace {

// That a way from a joint runs over: within `reaches.touch` there are no more but in knots of
// nodes, where nothing can be told.
constexpr int most_strands = 8;

constexpr std::array<Direction, 2> directions{Direction::backward, Direction::forward};

// Whether u lies between a and b, counter-clockwise.
bool is_between(const Vec2& a, const Vec2& u, const Vec2& b) {
  const bool left_of_a = cross(a, u) > 0, right_of_b = cross(u, b) > 0;
  return cross(a, b) > 0 ? left_of_a && right_of_b : left_of_a || right_of_b;
}

class JointTouches {
 public:
  explicit JointTouches(const Arrangement& arrangement)
      : arrangement_(arrangement),
        network_(arrangement.network()),
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

  // Whether the curve through the contour is, before the node (backward) or behind it, on the side
  // of the contour where its surface is not.
  bool leaves_surface(std::size_t node, Direction half) const {
    const Tie& s = contour(node);
    const Vec2 in = leaving(s, Direction::backward), out = leaving(s, Direction::forward);
    const Vec2 along = leaving(other(node), half);
    if (along.isZero(0)) return false;
    const Strand& strand = network_.strands[idx(s.b)];
    return is_between(in, along, out) == (strand.left_layers > strand.right_layers);
  }

  // The nearest crossing of that half with the contour, none if there is none.
  int nearest_crossing(std::size_t node, Direction half, double& distance_px) const {
    std::vector<int> on_contour, on_half;
    for (const Direction d : directions) collect(contour(node), d, on_contour);
    collect(other(node), half, on_half);
    int nearest = none;
    for (const int c : on_half) {
      if (std::find(on_contour.begin(), on_contour.end(), c) == on_contour.end()) continue;
      const double distance = (arrangement_.crossing(c).image - image_of(contour(node))).norm();
      if (nearest != none && distance >= distance_px) continue;
      nearest = c;
      distance_px = distance;
    }
    return nearest;
  }

  // Whether that half runs off over the tip of a cusp beside the node, which is on the cusp's far
  // strand.
  bool runs_over_cusp(std::size_t node, Direction half) const {
    const Tie& s = contour(node);
    const Vec2 along = leaving(other(node), half);
    for (const Direction d : directions) {
      const int strand = strand_of(s, d), cusp = far_node(strand, d);
      if (network_.nodes[idx(cusp)].kind != NodeKind::cusp || ties_[idx(cusp)].size() != 1)
        continue;
      const Vec2& tip = arrangement_.image_of(strand, index(strand, 0, opposite(d)));
      const Vec2 to_tip = tip - image_of(s);
      // Along the far strand to the cusp the way comes nearer to the viewer, away from it recedes.
      const bool is_far = ties_[idx(cusp)][0].jump == (d == Direction::forward ? -1 : 1);
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

  const Vec2& image_of(const Tie& tie) const { return arrangement_.image_of(tie.b, 0); }

  // The strand that leads away from a tie, and the node where it ends.
  static int strand_of(const Tie& tie, Direction d) {
    return d == Direction::forward ? tie.b : tie.a;
  }
  int far_node(int strand, Direction d) const {
    const Strand& s = network_.strands[idx(strand)];
    return d == Direction::forward ? s.end_node : s.start_node;
  }

  // Point i of a strand from its start, or from its end.
  int index(int strand, int i, Direction d) const {
    return d == Direction::forward ? i : arrangement_.point_count(strand) - 1 - i;
  }

  // From a tie along its strand to the first point elsewhere on the grid.
  Vec2 leaving(const Tie& tie, Direction d) const {
    const int strand = strand_of(tie, d);
    const auto grid_point = [&](int i) -> const GridPoint& {
      return arrangement_.image().grid[arrangement_.point(strand, index(strand, i, d))];
    };
    const GridPoint& from = grid_point(0);
    for (int i = 1; i < arrangement_.point_count(strand); ++i) {
      const GridPoint& to = grid_point(i);
      if (to.x == from.x && to.y == from.y) continue;
      return Vec2(static_cast<double>(to.x - from.x), static_cast<double>(to.y - from.y));
    }
    return Vec2::Zero();
  }

  void collect(const Tie& tie, Direction d, std::vector<int>& found) const {
    int strand = strand_of(tie, d);
    for (int k = 0; k < most_strands && strand != none; ++k) {
      if (!collect(strand, d, image_of(tie), found)) break;
      strand = (d == Direction::forward ? next_ : previous_)[idx(strand)];
    }
  }

  // Live crossings on the way along a strand while it stays near; whether it does to its end.
  bool collect(int strand, Direction d, const Vec2& centre, std::vector<int>& found) const {
    const int segments = arrangement_.point_count(strand) - 1;
    for (int i = 0; i < segments; ++i) {
      const int segment = d == Direction::forward ? i : segments - 1 - i;
      for (const Visit& visit : arrangement_.visits(strand)) {
        const bool is_here = visit.place.segment == segment && arrangement_.is_live(visit.crossing);
        if (is_here && is_near(arrangement_.crossing(visit.crossing).image, centre))
          found.push_back(visit.crossing);
      }
      if (!is_near(arrangement_.image_of(strand, index(strand, i + 1, d)), centre)) return false;
    }
    return true;
  }

  static bool is_near(const Vec2& p, const Vec2& centre) {
    return (p - centre).norm() <= reaches.touch;
  }

  const Arrangement& arrangement_;
  const CurveNetwork& network_;
  std::vector<std::vector<Tie>> ties_;  // (nodes)
  std::vector<int> next_;               // (strands)
  std::vector<int> previous_;           // (strands)
};

// Turns round what changes where a strand starts.
void turn_jump(Arrangement& arrangement, int strand) {
  for (std::size_t p = 0; p < arrangement.paths().size(); ++p) {
    const std::vector<int>& strands = arrangement.paths()[p].strands;
    const auto found = std::find(strands.begin(), strands.end(), strand);
    if (found == strands.end()) continue;
    arrangement.turn_jump(static_cast<int>(p), static_cast<int>(found - strands.begin()));
  }
}

// A cusp's strand that is not told from where its contour ends.
bool is_end_of_no_length(const Arrangement& arrangement, const Path& path, int strand) {
  return !path.cyclic && path.strands.size() > 1 &&
         (strand == path.strands.front() || strand == path.strands.back()) &&
         arrangement.reach_px(strand) <= reaches.end;
}

bool is_link(const Arrangement& arrangement, const Path& path, int index) {
  const Strand& strand = arrangement.strand(index);
  if (strand.start_node == strand.end_node) return false;  // closed, too
  if (strand.kind == Kind::intersection) return false;
  if (strand.kind == Kind::silhouette) return is_end_of_no_length(arrangement, path, index);
  return arrangement.reach_px(index) <= reaches.touch;
}

}  // namespace

std::vector<std::pair<int, int>> short_links(const Arrangement& arrangement) {
  std::vector<std::pair<int, int>> links;
  for (const Path& path : arrangement.paths()) {
    for (const int s : path.strands) {
      if (!is_link(arrangement, path, s)) continue;
      const Strand& strand = arrangement.strand(s);
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
    const std::size_t node = i / 2;
    const Direction half = directions[i % 2];
    if (!joints.is_of_contour(node) || joints.leaves_surface(node, half) == (is_odd[i] != 0))
      continue;
    double distance_px = 0;
    const int crossing = is_odd[i] ? none : joints.nearest_crossing(node, half, distance_px);
    if (crossing == none) {
      if (joints.runs_over_cusp(node, half)) turn_jump(arrangement, joints.other(node).b);
      continue;
    }
    arrangement.drop({crossing});
    moved_px = std::max(moved_px, distance_px);
    ++dropped;
  }
  return dropped;
}

}  // namespace illustrate
