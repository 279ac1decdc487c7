#include "mesh/fine_bends.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace illustrate {
namespace {

// What turns less is the diagonal of a quad, or flat.
constexpr double least_turn_deg = 0.5;
// Edges that are crossed run this much the same way: those of a strip round a bore of twelve sides
// turn by 30 degrees.
constexpr double same_way = 0.86;
constexpr double longer_than_wide = 3;
constexpr double most_deg = 170;
constexpr double reaches_looked_at = 4, least_reaches = 6;
constexpr int most_steps = 32;
// Of the whole turn: rounding shall not tell which edge is in the middle.
constexpr double tie_share = 0.02;

// What lies on one side of an edge.
struct BendSide {
  double near_deg = 0, whole_deg = 0;  // turns within half of the reach, and within four
  double strip = 0;                    // the width of the first; 0: it does not turn on
  double last = 0;                     // how far away the last edge is that turns
  int next = none;                     // the first edge that turns
};

class FineBendFinder {
 public:
  FineBendFinder(const Faces& faces, const Points& positions, const Ragged<int>& edges,
                 const EdgeTurns& turns, double reach, double least_deg)
      : faces_(faces),
        p_(positions),
        edges_(edges),
        turns_(turns),
        reach_(reach),
        least_deg_(least_deg) {}

  std::vector<std::uint8_t> run() {
    find_middles();
    gather_ends();
    chosen_.assign(edges_.size(), 0);
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      if (is_middle_[e]) choose_line(static_cast<int>(e));
    }
    return std::move(chosen_);
  }

 private:
  Vec3 along(int h) const { return p_[idx(faces_.head(h))] - p_[idx(faces_.corners[idx(h)])]; }
  Vec3 middle(int h) const {
    return (p_[idx(faces_.head(h))] + p_[idx(faces_.corners[idx(h)])]) / 2;
  }
  double length(int edge) const { return along(edges_[idx(edge)][0]).stableNorm(); }

  void find_middles() {
    is_middle_.assign(edges_.size(), 0);
    rivals_.assign(edges_.size(), {none, none});
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      if (!(turns_.of_edge(e) > least_turn_deg)) continue;
      const std::array<BendSide, 2> sides{side(edges_[e][0]), side(edges_[e][1])};
      is_middle_[e] = is_in_the_middle(e, sides);
      rivals_[e] = {sides[0].next, sides[1].next};
    }
  }

  bool is_in_the_middle(std::size_t e, const std::array<BendSide, 2>& sides) const {
    const double own = turns_.of_edge(e);
    const double whole = sides[0].whole_deg + own + sides[1].whole_deg;
    const double near = sides[0].near_deg + sides[1].near_deg;
    const double strip = std::max(sides[0].strip, sides[1].strip);
    return near > 0 && own + near >= least_deg_ && whole <= most_deg &&
           std::abs(sides[0].whole_deg - sides[1].whole_deg) <= own + tie_share * whole &&
           length(static_cast<int>(e)) >= longer_than_wide * strip;
  }

  // From an edge into the face of its half-edge and on.
  BendSide side(int h) const {
    BendSide result;
    const Vec3 way = along(h).stableNormalized(), from = middle(h);
    const bool convex = turns_.is_convex(h);
    int in = h;
    for (int step = 0; step < most_steps; ++step) {
      const int out = way_on(in, way);
      if (out == none || turns_.mate(out) == none) break;
      const double distance = way.cross(middle(out) - from).stableNorm();
      const double turn = turns_.at(out);
      if (!(distance <= reaches_looked_at * reach_) || turn == EdgeTurns::sharp_edge) break;
      if (turn > least_turn_deg) {
        if (turns_.is_convex(out) != convex) break;
        add(turns_.edge_of(out), turn, distance, result);
      }
      in = turns_.mate(out);
    }
    return result;
  }

  void add(int edge, double turn, double distance, BendSide& side) const {
    if (side.next == none) side.next = edge;
    side.whole_deg += turn;
    // A smooth surface turns at an edge from the middle of one strip to that of the next.
    const double width = std::max(0., distance - side.last), begin = distance - width / 2;
    if (side.strip == 0) side.strip = width;
    if (begin < reach_ / 2) side.near_deg += turn * std::min(1., (reach_ / 2 - begin) / width);
    side.last = distance;
  }

  // The other edge of the face that runs the way; none: no other does.
  int way_on(int in, const Vec3& way) const {
    int best = none;
    double most = same_way;
    for (int h = faces_.next(in); h != in; h = faces_.next(h)) {
      const double cosine = std::abs(along(h).stableNormalized().dot(way));
      if (!(cosine > most)) continue;
      most = cosine;
      best = h;
    }
    return best;
  }

  void gather_ends() {
    ends_.assign(p_.size(), {});
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      if (!is_middle_[e]) continue;
      for (const int v : turns_.ends(static_cast<int>(e)))
        ends_[idx(v)].push_back(static_cast<int>(e));
    }
  }

  // The line of middles on which an edge lies, from whose sides others are no longer chosen.
  void choose_line(int first) {
    std::vector<int> line;
    double sum = 0;
    const auto take = [&](int edge) {
      is_middle_[idx(edge)] = 0;
      for (const int rival : rivals_[idx(edge)])
        if (rival != none) is_middle_[idx(rival)] = 0;
      line.push_back(edge);
      sum += length(edge);
    };
    take(first);
    for (const int end : turns_.ends(first)) {
      int edge = first, vertex = end;
      while ((edge = goes_on(edge, vertex)) != none) {
        take(edge);
        vertex = turns_.other_end(edge, vertex);
      }
    }
    if (sum < least_reaches * reach_) return;
    for (const int edge : line) chosen_[idx(edge)] = 1;
  }

  // The straightest middle from the end of an edge.
  int goes_on(int edge, int vertex) const {
    const auto away = [&](int e) {
      return Vec3((p_[idx(turns_.other_end(e, vertex))] - p_[idx(vertex)]).stableNormalized());
    };
    const Vec3 back = away(edge);
    int best = none;
    double least = -std::sqrt(0.5);
    for (const int e : ends_[idx(vertex)]) {
      if (!is_middle_[idx(e)] || !(back.dot(away(e)) < least)) continue;
      least = back.dot(away(e));
      best = e;
    }
    return best;
  }

  const Faces& faces_;
  const Points& p_;
  const Ragged<int>& edges_;
  const EdgeTurns& turns_;
  double reach_, least_deg_;
  std::vector<std::uint8_t> is_middle_;     // (edges)
  std::vector<std::array<int, 2>> rivals_;  // (edges) side by side with it, that turn
  std::vector<std::vector<int>> ends_;      // (n) middles that end there
  std::vector<std::uint8_t> chosen_;        // (edges)
};

}  // namespace

std::vector<std::uint8_t> find_fine_bends(const Faces& faces, const Points& positions,
                                          const Ragged<int>& edges, const EdgeTurns& turns,
                                          double reach, double least_deg) {
  return FineBendFinder(faces, positions, edges, turns, reach, least_deg).run();
}

}  // namespace illustrate
