#include "tone/fold_extents.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include "core/disjoint_sets.h"

namespace illustrate {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

constexpr double loop_share = 0.125;

double length_of(Span<const Vec2> line, bool closed) {
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i) length += (line[i] - line[i - 1]).norm();
  return closed && line.size() > 0 ? length + (line[0] - line[line.size() - 1]).norm() : length;
}

class ExtentFinder {
 public:
  ExtentFinder(const LabelledGraph& graph, const Camera& camera)
      : graph_(graph), camera_(camera), folds_of_(graph.nodes.size()), sets_(graph.arcs.size()) {
    extents_.length.assign(graph.arcs.size(), 0);
    for (int arc = 0; arc < static_cast<int>(graph.arcs.size()); ++arc) add(arc);
  }

  FoldExtents find() {
    const std::vector<double> distance = distances();
    const std::size_t count = graph_.arcs.size();
    std::vector<double> joined(count, 0);
    for (int arc = 0; arc < static_cast<int>(count); ++arc)
      joined[idx(sets_.root(arc))] += extents_.length[idx(arc)];
    for (int arc = 0; arc < static_cast<int>(count); ++arc) {
      const GraphArc& data = graph_.arcs[idx(arc)];
      const auto at = [&](int node) { return node == none ? infinite : distance[idx(node)]; };
      extents_.from_start.push_back(at(data.start_node));
      extents_.from_end.push_back(at(data.end_node));
      extents_.most.push_back(std::isfinite(extents_.from_start.back())
                                  ? infinite
                                  : loop_share * joined[idx(sets_.root(arc))]);
    }
    return std::move(extents_);
  }

 private:
  void add(int arc) {
    const GraphArc& data = graph_.arcs[idx(arc)];
    if (!is_visible_fold(data)) return;
    extents_.length[idx(arc)] = length_of(graph_.image[idx(arc)], data.start_node == none);
    for (const int node : {data.start_node, data.end_node}) {
      if (node == none) continue;
      std::vector<int>& folds = folds_of_[idx(node)];
      if (!folds.empty()) sets_.join(arc, folds.front());
      folds.push_back(arc);
    }
  }

  bool is_end(std::size_t node) const {
    const Vec2& p = graph_.nodes[node].image;
    const bool in_frame =
        p.x() > 0 && p.y() > 0 && p.x() < camera_.width_px() && p.y() < camera_.height_px();
    return folds_of_[node].size() == 1 && in_frame;
  }

  // Of the nodes from the nearest end (Dijkstra).
  std::vector<double> distances() const {
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> next;
    std::vector<double> distance(graph_.nodes.size(), infinite);
    for (std::size_t node = 0; node < distance.size(); ++node) {
      if (!is_end(node)) continue;
      distance[node] = 0;
      next.push({0, static_cast<int>(node)});
    }
    while (!next.empty()) {
      const auto [so_far, node] = next.top();
      next.pop();
      if (so_far > distance[idx(node)]) continue;
      for (const int arc : folds_of_[idx(node)]) {
        const GraphArc& data = graph_.arcs[idx(arc)];
        const int other = data.start_node == node ? data.end_node : data.start_node;
        const double there = so_far + extents_.length[idx(arc)];
        if (there >= distance[idx(other)]) continue;
        distance[idx(other)] = there;
        next.push({there, other});
      }
    }
    return distance;
  }

  const LabelledGraph& graph_;
  const Camera& camera_;
  std::vector<std::vector<int>> folds_of_;  // (nodes)
  DisjointSets sets_;                       // of arcs
  FoldExtents extents_;
};

}  // namespace

bool is_visible_fold(const GraphArc& arc) {
  return layers_over(arc) == 0 && arc.kind != Kind::seam &&
         (arc.kind == Kind::intersection || arc.left_layers != arc.right_layers);
}

double FoldExtents::to_end(int arc, double along) const {
  const double on = length[idx(arc)] - along;
  return std::min({most[idx(arc)], from_start[idx(arc)] + along, from_end[idx(arc)] + on});
}

FoldExtents fold_extents(const LabelledGraph& graph, const Camera& camera) {
  return ExtentFinder(graph, camera).find();
}

}  // namespace illustrate
