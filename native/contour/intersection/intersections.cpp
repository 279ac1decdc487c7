#include "contour/intersection/intersections.h"

#include <algorithm>
#include <map>
#include <set>

#include "contour/intersection/crossing_test.h"
#include "contour/intersection/flush.h"
#include "contour/intersection/triple_points.h"
#include "surface/edge_kinds.h"

namespace illustrate {
namespace {

constexpr std::int64_t pairs_between_reports = 1 << 16;

// Pairs of boxes to expect for each triangle; only progress depends on it.
constexpr double expected_pairs = 8;

// Of the work, that which finds the curves.
constexpr double pairs_share = 0.8;

struct Segment {
  std::array<int, 2> triangles;
  std::array<Piercing, 2> ends;
  std::array<int, 2> nodes;  // indices of the ends among all different ones
};

// Segments as they are found, never many more than `most` of them.
class KeptSegments {
 public:
  KeptSegments(const Surface& surface, std::int64_t most)
      : objects_(surface.triangle_objects), most_(most) {}

  bool takes(int s, int t) const {
    return left_out_.empty() || left_out_.count(pair_of(s, t)) == 0;
  }

  void add(const Segment& segment) {
    segments_.push_back(segment);
    ++counts_[pair_of(segment.triangles[0], segment.triangles[1])];
    if (static_cast<std::int64_t>(segments_.size()) > most_) leave_out_largest();
  }

  // The order of the BVH is that of the axes, and curves start where segments come first.
  std::vector<Segment> sorted() && {
    std::sort(segments_.begin(), segments_.end(),
              [](const Segment& a, const Segment& b) { return a.triangles < b.triangles; });
    return std::move(segments_);
  }

  std::vector<ObjectPair> left_out() const { return {left_out_.begin(), left_out_.end()}; }

 private:
  ObjectPair pair_of(int s, int t) const {
    const auto [low, high] = std::minmax({objects_[idx(s)], objects_[idx(t)]});
    return {low, high};
  }

  void leave_out_largest() {
    std::vector<std::pair<ObjectPair, std::int64_t>> largest(counts_.begin(), counts_.end());
    std::stable_sort(largest.begin(), largest.end(),
                     [](const auto& a, const auto& b) { return a.second > b.second; });
    auto left = static_cast<std::int64_t>(segments_.size());
    for (std::size_t i = 0; 2 * left > most_; ++i) {
      left -= largest[i].second;
      left_out_.insert(largest[i].first);
      counts_.erase(largest[i].first);
    }
    const auto is_left_out = [&](const Segment& segment) {
      return !takes(segment.triangles[0], segment.triangles[1]);
    };
    segments_.erase(std::remove_if(segments_.begin(), segments_.end(), is_left_out),
                    segments_.end());
  }

  const std::vector<int>& objects_;
  std::int64_t most_;
  std::vector<Segment> segments_;
  std::map<ObjectPair, std::int64_t> counts_;  // of segments_
  std::set<ObjectPair> left_out_;
};

// What pairs of triangles whose boxes touch have in common.
class PairFinder {
 public:
  PairFinder(const Surface& surface, const CrossingTest& test, std::int64_t most,
             const Progress& progress)
      : surface_(surface), test_(test), progress_(progress), segments_(surface, most) {}

  void run(const Bvh& bvh) {
    bvh.overlapping_pairs([&](int s, int t) { visit(s, t); }, test_.reach());
    std::sort(flush_.begin(), flush_.end(), [](const FlushTriangles& a, const FlushTriangles& b) {
      return a.triangles < b.triangles;
    });
  }

  std::vector<ObjectPair> left_out() const { return segments_.left_out(); }
  std::vector<Segment> take_segments() { return std::move(segments_).sorted(); }
  std::vector<FlushTriangles> take_flush() { return std::move(flush_); }
  std::int64_t undecided() const { return undecided_; }

 private:
  void visit(int s, int t) {
    report();
    Segment segment{{s, t}, {}, {}};
    const TriangleIntersection found =
        segments_.takes(s, t) ? test_.cross(s, t, segment.ends) : TriangleIntersection::apart;
    const bool cross = found == TriangleIntersection::segment;
    if (cross) segments_.add(segment);
    undecided_ += found == TriangleIntersection::undecided;
    // Flush triangles matter where they have a line: copies of a smooth mesh at one place have
    // none.
    const bool has_line = cross || has_crease(surface_, s) || has_crease(surface_, t);
    if (has_line && test_.are_flush(s, t))
      flush_.push_back({{s, t}, {test_.part(s), test_.part(t)}});
  }

  void report() {
    if (++visited_ % pairs_between_reports != 0) return;
    const double expected = expected_pairs * static_cast<double>(surface_.triangles.size());
    const auto done = static_cast<double>(visited_);
    progress_.report(done / (done + expected));
  }

  const Surface& surface_;
  const CrossingTest& test_;
  Progress progress_;
  KeptSegments segments_;
  std::vector<FlushTriangles> flush_;
  std::int64_t undecided_ = 0, visited_ = 0;
};

// The different ends of all segments, sorted; fills Segment::nodes.
std::vector<Piercing> number_nodes(std::vector<Segment>& segments) {
  std::vector<Piercing> nodes;
  for (const Segment& segment : segments)
    nodes.insert(nodes.end(), segment.ends.begin(), segment.ends.end());
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  for (Segment& segment : segments)
    for (std::size_t k = 0; k < 2; ++k)
      segment.nodes[k] = static_cast<int>(
          std::lower_bound(nodes.begin(), nodes.end(), segment.ends[k]) - nodes.begin());
  return nodes;
}

Ragged<int> segments_by_node(const std::vector<Segment>& segments, std::size_t node_count) {
  return sorted_into<int>(node_count, [&](const auto& put) {
    for (std::size_t i = 0; i < segments.size(); ++i)
      for (const int node : segments[i].nodes) put(node, static_cast<int>(i));
  });
}

// Chains segments through the nodes that exactly two of them share.
class Linker {
 public:
  Linker(const Surface& surface, const CrossingTest& test, std::vector<Segment> segments)
      : surface_(surface),
        test_(test),
        segments_(std::move(segments)),
        nodes_(number_nodes(segments_)),
        by_node_(segments_by_node(segments_, nodes_.size())),
        is_used_(segments_.size(), 0) {}

  IntersectionCurves link() {
    for (int node = 0; node < static_cast<int>(nodes_.size()); ++node)
      if (is_end(node))
        for (const int segment : by_node_[idx(node)]) follow(segment, node);
    for (int segment = 0; segment < static_cast<int>(segments_.size()); ++segment)
      follow(segment, segments_[idx(segment)].nodes[0]);
    return std::move(result_);
  }

 private:
  bool is_end(int node) const { return by_node_[idx(node)].size() != 2; }

  void follow(int segment, int start) {
    if (is_used_[idx(segment)]) return;
    std::array<int, 2> triangles = segments_[idx(segment)].triangles;
    int node = start;
    while (true) {
      is_used_[idx(segment)] = 1;
      add_point(node, triangles, triangles);
      const auto& nodes = segments_[idx(segment)].nodes;
      node = nodes[0] == node ? nodes[1] : nodes[0];
      if (node == start || is_end(node)) break;
      segment = other_segment(node, segment);
      triangles = keep_sheets(triangles, segments_[idx(segment)].triangles);
    }
    if (node != start) add_point(node, triangles, {none, none});
    result_.curves.close_list();
    result_.closed.push_back(node == start);
  }

  int other_segment(int node, int segment) const {
    const auto segments = by_node_[idx(node)];
    return segments[0] == segment ? segments[1] : segments[0];
  }

  // The triangle that stays keeps its sheet.
  static std::array<int, 2> keep_sheets(const std::array<int, 2>& before,
                                        const std::array<int, 2>& after) {
    if (before[0] == after[0] || before[1] == after[1]) return after;
    return {after[1], after[0]};
  }

  void add_point(int node, const std::array<int, 2>& triangles,
                 const std::array<int, 2>& segment_triangles) {
    const Piercing& piercing = nodes_[idx(node)];
    const double s = test_.parameter(piercing);
    const Vec3& low = surface_.positions[idx(test_.vertices()[idx(piercing.low)])];
    const Vec3& high = surface_.positions[idx(test_.vertices()[idx(piercing.high)])];
    result_.curves.push({low * (1 - s) + high * s,
                         test_.surface_point(piercing, triangles[0]),
                         test_.surface_point(piercing, triangles[1]),
                         test_.decided(piercing),
                         {piercing.low, piercing.high}});
    result_.segment_triangles.push_back(segment_triangles);
  }

  const Surface& surface_;
  const CrossingTest& test_;
  std::vector<Segment> segments_;
  std::vector<Piercing> nodes_;
  Ragged<int> by_node_;
  std::vector<std::uint8_t> is_used_;
  IntersectionCurves result_;
};

}  // namespace

void complete(const Surface& surface, IntersectionCurves& curves, const Progress& progress) {
  curves.triple_points = triple_points(surface, curves, progress);
  curves.flush_edges = flush_edges(surface, curves);
  curves.flush_segments = flush_segments(surface, curves);
}

IntersectionCurves intersections(const Surface& surface, const Bvh& bvh, Counts& report,
                                 const Progress& progress, std::int64_t most) {
  const CrossingTest test(surface);
  PairFinder pairs(surface, test, most, progress.part(0, pairs_share));
  pairs.run(bvh);
  report["intersection_ties"] += pairs.undecided();
  const std::vector<ObjectPair> left_out = pairs.left_out();
  IntersectionCurves curves = Linker(surface, test, pairs.take_segments()).link();
  curves.left_out = left_out;
  curves.insets = test.insets(surface);
  curves.flush_triangles = pairs.take_flush();
  curves.reach = test.reach();
  curves.one_plane = test.one_plane();
  complete(surface, curves, progress.part(pairs_share, 1));
  report["intersections_left_out"] += static_cast<std::int64_t>(left_out.size());
  report["intersection_curves"] += static_cast<std::int64_t>(curves.curves.size());
  return curves;
}

}  // namespace illustrate
