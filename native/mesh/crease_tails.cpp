#include "mesh/crease_tails.h"

#include <array>
#include <cmath>

#include "core/angles.h"

namespace illustrate {
namespace {

constexpr double least_tail_deg = 10;
const double straight_on = std::cos(radians(40));
constexpr int fewest_line_edges = 3, most_line_edges = 32;

class TailFinder {
 public:
  TailFinder(const Faces& faces, const Points& positions, const Ragged<int>& edges,
             const EdgeTurns& turns, const Shading& shading)
      : faces_(faces),
        p_(positions),
        edges_(edges),
        turns_(turns),
        shading_(shading),
        is_tail_(edges.size(), 0),
        sharp_(positions.size()) {}

  std::vector<std::uint8_t> run() {
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      if (turns_.of_edge(e) == EdgeTurns::sharp_edge) add_sharp(static_cast<int>(e));
    }
    const std::vector<Line> lines = loose_lines();  // tails are no reason for others
    if (!lines.empty()) gather_soft_edges();
    for (const Line& line : lines) follow(line);
    return std::move(is_tail_);
  }

 private:
  // The sharp and open edges at a vertex: how many, and the first two.
  struct Sharp {
    int count = 0;
    std::array<int, 2> edges{none, none};
  };

  // A line of so many edges that ends loosely at a vertex.
  struct Line {
    int vertex, edge, length;
  };

  void add_sharp(int edge) {
    for (const int v : turns_.ends(edge)) {
      Sharp& sharp = sharp_[idx(v)];
      if (sharp.count < 2) sharp.edges[idx(sharp.count)] = edge;
      ++sharp.count;
    }
  }

  // Those that may be of tails.
  void gather_soft_edges() {
    soft_.resize(p_.size());
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      if (turns_.of_edge(e) < least_tail_deg || !are_flat(faces_, edges_[e], shading_)) continue;
      const int edge = static_cast<int>(e);
      for (const int v : turns_.ends(edge)) soft_[idx(v)].push_back(edge);
    }
  }

  // An open edge is not.
  bool is_convex(int edge) const {
    const auto half_edges = edges_[idx(edge)];
    return half_edges.size() == 2 && turns_.is_convex(half_edges[0]);
  }

  // Along an edge, away from v.
  Vec3 way(int edge, int v) const {
    return (p_[idx(turns_.other_end(edge, v))] - p_[idx(v)]).stableNormalized();
  }

  double straightness(int from, int to, int v) const { return -way(from, v).dot(way(to, v)); }

  bool goes_on(int from, int to, int v) const {
    return straightness(from, to, v) > straight_on && is_convex(from) == is_convex(to);
  }

  std::vector<Line> loose_lines() const {
    std::vector<Line> lines;
    for (int v = 0; v < static_cast<int>(sharp_.size()); ++v) {
      if (sharp_[idx(v)].count != 1) continue;
      const Line line{v, sharp_[idx(v)].edges[0], line_length(v)};
      if (line.length >= fewest_line_edges) lines.push_back(line);
    }
    return lines;
  }

  // Edges of the line that ends at v.
  int line_length(int v) const {
    int edge = sharp_[idx(v)].edges[0], length = 0;
    for (int at = v; length < most_line_edges;) {
      if (edges_[idx(edge)].size() != 2) return length;
      ++length;
      at = turns_.other_end(edge, at);
      const Sharp& sharp = sharp_[idx(at)];
      if (sharp.count != 2) return length;
      const int next = sharp.edges[sharp.edges[0] == edge ? 1 : 0];
      if (!goes_on(edge, next, at)) return length;
      edge = next;
    }
    return length;
  }

  void follow(const Line& line) {
    int v = line.vertex, edge = line.edge;
    for (int k = 0; k < line.length && sharp_[idx(v)].count == 1; ++k) {
      edge = next_edge(v, edge);
      if (edge == none) return;
      is_tail_[idx(edge)] = 1;
      add_sharp(edge);
      v = turns_.other_end(edge, v);
    }
  }

  int next_edge(int v, int edge) const {
    int best = none;
    for (const int next : soft_[idx(v)]) {
      if (!goes_on(edge, next, v)) continue;
      if (best == none || straightness(edge, next, v) > straightness(edge, best, v)) best = next;
    }
    return best;
  }

  const Faces& faces_;
  const Points& p_;
  const Ragged<int>& edges_;
  const EdgeTurns& turns_;
  const Shading& shading_;
  std::vector<std::uint8_t> is_tail_;   // (edges)
  std::vector<Sharp> sharp_;            // (n) with tails
  std::vector<std::vector<int>> soft_;  // (n) edges that may be of tails
};

}  // namespace

std::vector<std::uint8_t> find_crease_tails(const Faces& faces, const Points& positions,
                                            const Ragged<int>& edges, const EdgeTurns& turns,
                                            const Shading& shading) {
  return TailFinder(faces, positions, edges, turns, shading).run();
}

}  // namespace illustrate
