#include "mesh/gaps.h"

#include <algorithm>
#include <limits>

#include "core/disjoint_sets.h"
#include "mesh/bvh.h"

namespace illustrate {
namespace {

// Of an edge: what is moved so far keeps its shape.
constexpr double most_of_length = 0.01;

// The open edge that may be the other side of one.
struct OtherSide {
  int edge = none;
  double distance = std::numeric_limits<double>::infinity();

  // Of several that are equally near, the first.
  void offer(int other, double other_distance) {
    if (!(other_distance < distance)) return;
    distance = other_distance;
    edge = other;
  }
};

class GapFinder {
 public:
  GapFinder(const Points& positions, const BorderEdges& edges)
      : positions_(positions), edges_(edges), nearest_(idx(edges.size())) {}

  // Two edges, ascending, for each gap.
  std::vector<Edge> run() {
    // Edges that are close at both ends are so in the middle; at their ends thousands may meet.
    Points middles;
    std::vector<Triangle> boxes;
    for (int e = 0; e < edges_.size(); ++e) {
      middles.push_back((positions_[idx(edges_[e].tail)] + positions_[idx(edges_[e].head)]) / 2);
      boxes.push_back({e, e, e});
    }
    Bvh(middles, boxes, 1)
        .overlapping_pairs([&](int a, int b) { compare(a, b); }, edges_.widest_reach());
    std::vector<Edge> gaps;
    for (int a = 0; a < edges_.size(); ++a) {
      const int b = nearest_[idx(a)].edge;
      if (b > a && nearest_[idx(b)].edge == a) gaps.push_back({a, b});
    }
    return gaps;
  }

 private:
  double apart(int vertex, int other) const {
    return (positions_[idx(vertex)] - positions_[idx(other)]).stableNorm();
  }

  double reach(const BorderEdge& edge) const {
    return std::min(edge.reach, most_of_length * apart(edge.tail, edge.head));
  }

  void compare(int a, int b) {
    const BorderEdge &edge = edges_[a], &other = edges_[b];
    const double distance = std::max(apart(edge.tail, other.head), apart(edge.head, other.tail));
    if (!(distance < std::min(reach(edge), reach(other)))) return;
    if (!edges_.shaded_alike(edge, edge.tail_normal, other, other.head_normal) ||
        !edges_.shaded_alike(edge, edge.head_normal, other, other.tail_normal))
      return;
    nearest_[idx(a)].offer(b, distance);
    nearest_[idx(b)].offer(a, distance);
  }

  const Points& positions_;
  const BorderEdges& edges_;
  std::vector<OtherSide> nearest_;
};

}  // namespace

void close_gaps(const Points& positions, const BorderEdges& open, Faces& faces,
                std::vector<int>& numbers, Counts& report) {
  const std::vector<Edge> gaps = GapFinder(positions, open).run();
  if (gaps.empty()) return;
  report["closed_gaps"] += static_cast<std::int64_t>(gaps.size());
  DisjointSets sets(positions.size());
  for (const auto& [a, b] : gaps) {
    sets.join(open[a].tail, open[b].head);
    sets.join(open[a].head, open[b].tail);
  }
  weld(sets, positions, faces, numbers, report);
}

}  // namespace illustrate
