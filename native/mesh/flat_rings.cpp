#include "mesh/flat_rings.h"

#include <algorithm>
#include <map>

#include "core/angles.h"
#include "mesh/flat_pieces.h"

namespace illustrate {
namespace {

constexpr std::size_t fewest_edges_of_circle = 8;
// Of another border: a hexagon beside a circle of ten sides is a polygon, beside an octagon round.
constexpr double coarser = 1.6;

struct Border {
  std::vector<int> half_edges;
  double mean_turn_deg = 0;
  double bend_deg = 0;  // mean over what it bends: straight pieces count nothing
  bool is_tube = false;

  bool is_round() const {
    return half_edges.size() >= fewest_edges_of_circle && bend_deg < octagon_deg && is_rim();
  }
  bool is_rim() const { return mean_turn_deg >= break_deg && !is_tube; }
};

class RingFinder {
 public:
  RingFinder(const Faces& faces, const Points& positions, const EdgeTurns& turns,
             const FlatPieces& flat, std::size_t edge_count)
      : faces_(faces), p_(positions), turns_(turns), flat_(flat) {
    result_.is_rim.assign(edge_count, 0);
    result_.is_angular.assign(positions.size(), 0);
  }

  FlatRings run() {
    gather_borders();
    for (auto& [piece, borders] : borders_) add(borders);
    return std::move(result_);
  }

 private:
  int piece(int h) const { return flat_.pieces[faces_.corner_faces[h]]; }

  bool is_inside(int h) const {
    const int mate = turns_.mate(h);
    return mate != none && piece(h) == piece(mate);
  }

  // Of pieces with several borders alone: on a scan every face is a piece.
  void gather_borders() {
    std::vector<int> counts(faces_.sources.size(), 0);
    for_each_border([&](const Border& border) { ++counts[piece(border.half_edges[0])]; });
    for_each_border([&](const Border& border) {
      const int here = piece(border.half_edges[0]);
      if (counts[here] >= 2) borders_[here].push_back(border);
    });
  }

  template <class Visit>
  void for_each_border(const Visit& visit) const {
    std::vector<std::uint8_t> is_done(faces_.corners.size(), 0);
    Border border;
    for (int h = 0; h < faces_.corner_count(); ++h) {
      if (is_done[h] || !flat_.is_flat[piece(h)] || is_inside(h)) continue;
      border.half_edges.clear();
      for (int g = h; !is_done[g]; g = after(g)) {
        is_done[g] = 1;
        border.half_edges.push_back(g);
      }
      visit(border);
    }
  }

  // The next half-edge on the same border.
  int after(int h) const {
    int next = faces_.next(h);
    while (is_inside(next)) next = faces_.next(turns_.mate(next));
    return next;
  }

  void add(std::vector<Border>& borders) {
    for (Border& border : borders) measure(border);
    const auto is_steep = [](const Border& border) { return border.mean_turn_deg >= steep_deg; };
    const auto is_round = [](const Border& border) { return border.is_round(); };
    if (!std::all_of(borders.begin(), borders.end(), is_steep) ||
        std::none_of(borders.begin(), borders.end(), is_round))
      return;
    double least = 180;
    for (const Border& border : borders) least = std::min(least, border.bend_deg);
    for (const Border& border : borders) {
      if (border.is_rim()) mark(border, border.bend_deg >= std::max(octagon_deg, coarser * least));
    }
  }

  void measure(Border& border) const {
    const std::size_t n = border.half_edges.size();
    double turn = 0, bends = 0, squares = 0;
    std::size_t rounds = 0;
    for (std::size_t k = 0; k < n; ++k) {
      const int h = border.half_edges[k];
      turn += turns_.of_faces(h);
      rounds += turns_.is_round_of_like_sides(idx(turns_.edge_of(h)));
      const double bend = degrees_between(direction(h), direction(border.half_edges[(k + 1) % n]));
      bends += bend;
      squares += bend * bend;
    }
    border.mean_turn_deg = turn / static_cast<double>(n);
    border.bend_deg = bends > 0 ? squares / bends : 0;
    border.is_tube = 2 * rounds >= n;
  }

  Vec3 direction(int h) const { return p_[faces_.head(h)] - p_[faces_.corners[h]]; }

  void mark(const Border& border, bool is_angular) {
    for (const int h : border.half_edges) {
      result_.is_rim[idx(turns_.edge_of(h))] = 1;
      result_.is_angular[faces_.corners[h]] |= is_angular;
    }
  }

  const Faces& faces_;
  const Points& p_;
  const EdgeTurns& turns_;
  const FlatPieces& flat_;
  std::map<int, std::vector<Border>> borders_;  // by pieces
  FlatRings result_;
};

}  // namespace

FlatRings find_flat_rings(const Faces& faces, const Points& positions, const EdgeTurns& turns,
                          const Shading& shading, std::size_t edge_count) {
  const FlatPieces flat = find_flat_pieces(faces, positions, turns, shading);
  return RingFinder(faces, positions, turns, flat, edge_count).run();
}

}  // namespace illustrate
