#include "visibility/arrangement/crossings.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/segment_pairs.h"
#include "visibility/reaches.h"

namespace illustrate {
namespace {

__extension__ using Wide = __int128;

Wide turn(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
  return Wide(b.x - a.x) * (c.y - a.y) - Wide(b.y - a.y) * (c.x - a.x);
}

int sign(std::int64_t x) { return (x > 0) - (x < 0); }

// The sign of a vanishing determinant of i < j < k when every point is moved by its own
// infinitesimal.
int perturbed(const GridPoint& i, const GridPoint& j, const GridPoint& k) {
  if (k.x != j.x) return sign(k.x - j.x);
  if (j.y != k.y) return sign(j.y - k.y);
  if (i.x != k.x) return sign(i.x - k.x);
  return 1;
}

SegmentBox box_of(const GridPoint& a, const GridPoint& b) {
  return {{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
}

std::vector<StrandSegment> crossing_segments(const CurveNetwork& network) {
  std::vector<StrandSegment> segments = all_segments(network);
  const auto is_left_out = [&](const StrandSegment& s) {
    return !takes_part_in_crossings(network.strands[idx(s.strand)].sight);
  };
  segments.erase(std::remove_if(segments.begin(), segments.end(), is_left_out), segments.end());
  return segments;
}

class CrossingFinder {
 public:
  CrossingFinder(const CurveNetwork& network, const ImageStrands& strands)
      : network_(network), strands_(strands), segments_(crossing_segments(network)) {}

  std::optional<std::vector<Crossing>> run(std::size_t most) {
    std::vector<SegmentBox> boxes;
    boxes.reserve(segments_.size());
    for (const StrandSegment& s : segments_) {
      boxes.push_back(box_of(strands_.grid[idx(s.a)], strands_.grid[idx(s.b)]));
    }
    std::vector<std::pair<int, int>> pairs;
    overlapping_boxes(boxes, [&](int i, int j) {
      if (pairs.size() <= most && cross(segments_[idx(i)], segments_[idx(j)])) {
        pairs.emplace_back(i, j);
      }
    });
    if (pairs.size() > most) return {};
    std::sort(pairs.begin(), pairs.end());
    std::vector<Crossing> result;
    for (const auto& [i, j] : pairs) {
      if (are_one_line(segments_[idx(i)], segments_[idx(j)])) continue;
      const Crossing x = crossing(segments_[idx(i)], segments_[idx(j)]);
      if (!is_free_line(network_.strands[idx(x.front.strand)].kind)) result.push_back(x);
    }
    return result;
  }

 private:
  const GridPoint& grid(int point) const { return strands_.grid[idx(point)]; }

  using Grid = std::vector<GridPoint>;

  bool is_covered(const StrandSegment& s) const {
    return network_.strands[idx(s.strand)].sight == Sight::covered;
  }

  // Where two covered curves cross nothing is asked of either.
  bool cross(const StrandSegment& s, const StrandSegment& t) const {
    return !(is_covered(s) && is_covered(t)) && cross(strands_.grid, s, t);
  }
  static bool cross(const Grid& grid, const StrandSegment& s, const StrandSegment& t) {
    const GridPoint &a = grid[idx(s.a)], &b = grid[idx(s.b)];
    const GridPoint &c = grid[idx(t.a)], &d = grid[idx(t.b)];
    if (a.id == b.id || c.id == d.id) return false;
    if (a.id == c.id || a.id == d.id || b.id == c.id || b.id == d.id) return false;
    return orientation(a, b, c) != orientation(a, b, d) &&
           orientation(c, d, a) != orientation(c, d, b);
  }

  // Shares of s and t at which they cross.
  std::array<double, 2> decided_fractions(const StrandSegment& s, const StrandSegment& t) const {
    return {fraction(strands_.grid, s, t), fraction(strands_.grid, t, s)};
  }

  // And at which that is drawn: where they are, if they cross there too and near where that was
  // decided, so that it depends on nothing else.
  std::array<double, 2> fractions(const StrandSegment& s, const StrandSegment& t,
                                  const std::array<double, 2>& decided) const {
    const Grid& places = strands_.places;
    const double gap = std::abs(depth(s, decided[0]) - depth(t, decided[1]));
    if (gap <= strands_.touching || !cross(places, s, t)) return decided;
    const std::array<double, 2> own{fraction(places, s, t), fraction(places, t, s)};
    const auto is_near = [&](const StrandSegment& segment, std::size_t k) {
      const double length =
          (strands_.image[idx(segment.b)] - strands_.image[idx(segment.a)]).norm();
      return std::abs(own[k] - decided[k]) * length < reaches.crossing_move;
    };
    return is_near(s, 0) && is_near(t, 1) ? own : decided;
  }

  double fraction(const Grid& g, const StrandSegment& s, const StrandSegment& t) const {
    const auto from = static_cast<long double>(turn(g[idx(t.a)], g[idx(t.b)], g[idx(s.a)]));
    const auto to = static_cast<long double>(turn(g[idx(t.a)], g[idx(t.b)], g[idx(s.b)]));
    if (from == to) return middle_of_overlap(s, t);
    return std::clamp(static_cast<double>(from / (from - to)), 0.0, 1.0);
  }

  // Of segments on one line, where only the perturbation says that they cross: the same point from
  // both.
  double middle_of_overlap(const StrandSegment& s, const StrandSegment& t) const {
    const Vec2 a = flat(s.a), along = flat(s.b) - a;
    const double square = along.squaredNorm();
    if (square == 0) return 0.5;
    const double c = (flat(t.a) - a).dot(along) / square, d = (flat(t.b) - a).dot(along) / square;
    return (std::clamp(c, 0.0, 1.0) + std::clamp(d, 0.0, 1.0)) / 2;
  }

  Vec2 flat(int point) const {
    return {static_cast<double>(grid(point).x), static_cast<double>(grid(point).y)};
  }

  double depth(const StrandSegment& s, double image_fraction) const {
    const double a = strands_.decided_depth[idx(s.a)], b = strands_.decided_depth[idx(s.b)];
    return a + world_fraction(image_fraction, a, b, strands_.perspective) * (b - a);
  }

  // Of curves at one place, as a border that lies in another sheet and the intersection along it,
  // the first is in front all along.
  Crossing crossing(const StrandSegment& s, const StrandSegment& t) const {
    const std::array<double, 2> decided = decided_fractions(s, t);
    const auto [fs, ft] = fractions(s, t, decided);
    const StrandPlace ps{s.strand, s.segment, fs}, pt{t.strand, t.segment, ft};
    const double of_s = depth(s, decided[0]), of_t = depth(t, decided[1]);
    const bool s_in_front = of_s <= of_t + strands_.same_depth;
    const StrandSegment& front = s_in_front ? s : t;
    const StrandSegment& back = s_in_front ? t : s;
    const bool from_right = orientation(grid(front.a), grid(front.b), grid(back.a)) < 0;
    const Vec2 &a = strands_.image[idx(s.a)], &b = strands_.image[idx(s.b)];
    const std::array<double, 2> in_order{decided[s_in_front ? 0 : 1], decided[s_in_front ? 1 : 0]};
    return {s_in_front ? ps : pt,
            s_in_front ? pt : ps,
            in_order,
            a + fs * (b - a),
            from_right,
            std::abs(of_s - of_t) <= strands_.touching && ends_at(s, fs) && ends_at(t, ft)};
  }

  // Whether the strand ends at a place of its segment.
  bool ends_at(const StrandSegment& s, double image_fraction) const {
    const Strand& strand = network_.strands[idx(s.strand)];
    if (strand.closed()) return false;
    const auto at = [&](int point) -> const Vec3& {
      return network_.points.values[idx(point)].position;
    };
    const double a = strands_.depth[idx(s.a)], b = strands_.depth[idx(s.b)];
    const double share = world_fraction(image_fraction, a, b, strands_.perspective);
    const Vec3 place = at(s.a) + share * (at(s.b) - at(s.a));
    const auto is_here = [&](int node) {
      return (network_.nodes[idx(node)].position - place).norm() <= strands_.touching;
    };
    return is_here(strand.start_node) || is_here(strand.end_node);
  }

  // An edge within a face of another part and the intersection that runs along it.
  bool are_one_line(const StrandSegment& s, const StrandSegment& t) const {
    const Strand &a = network_.strands[idx(s.strand)], &b = network_.strands[idx(t.strand)];
    const auto is_along_edge = [](const Strand& x) {
      return x.is_flush && x.kind == Kind::intersection;
    };
    if (!is_along_edge(a) && !is_along_edge(b)) return false;
    const auto [of_s, of_t] = decided_fractions(s, t);
    return std::abs(depth(s, of_s) - depth(t, of_t)) <= strands_.touching;
  }

  const CurveNetwork& network_;
  const ImageStrands& strands_;
  std::vector<StrandSegment> segments_;
};

}  // namespace

int orientation(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
  std::array<const GridPoint*, 3> p{&a, &b, &c};
  int parity = 1;
  const auto order = [&](std::size_t i, std::size_t j) {
    if (p[i]->id > p[j]->id) {
      std::swap(p[i], p[j]);
      parity = -parity;
    }
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
  const Wide determinant = turn(*p[0], *p[1], *p[2]);
  if (determinant != 0) return determinant > 0 ? parity : -parity;
  return parity * perturbed(*p[0], *p[1], *p[2]);
}

std::optional<std::vector<Crossing>> find_crossings(const CurveNetwork& network,
                                                    const ImageStrands& strands, std::size_t most) {
  return CrossingFinder(network, strands).run(most);
}

}  // namespace illustrate
