#include "core/segment_pairs.h"

#include <algorithm>

namespace illustrate {
namespace {

// Segments of a leaf. Runs of a polyline keep together what lies together, with an eighth of the
// nodes; much longer ones have boxes that overlap everywhere.
constexpr int longest_run = 8;

bool overlap(const SegmentBox& a, const SegmentBox& b) {
  return a.low[0] <= b.high[0] && b.low[0] <= a.high[0] && a.low[1] <= b.high[1] &&
         b.low[1] <= a.high[1];
}

void grow(SegmentBox& box, const SegmentBox& other) {
  for (std::size_t k = 0; k < 2; ++k) {
    box.low[k] = std::min(box.low[k], other.low[k]);
    box.high[k] = std::max(box.high[k], other.high[k]);
  }
}

// Boxes that follow one another and touch, as those of a polyline do.
struct Run {
  SegmentBox box;
  int begin;
  int end;
};

std::vector<Run> runs_of(const std::vector<SegmentBox>& boxes) {
  std::vector<Run> runs;
  for (int i = 0; i < static_cast<int>(boxes.size()); ++i) {
    const SegmentBox& box = boxes[idx(i)];
    const bool goes_on =
        !runs.empty() && i - runs.back().begin < longest_run && overlap(boxes[idx(i - 1)], box);
    if (!goes_on) runs.push_back({box, i, i});
    grow(runs.back().box, box);
    runs.back().end = i + 1;
  }
  return runs;
}

// A binary tree of runs; a node's children are `left` and `left + 1`, a leaf is one run.
class RunTree {
 public:
  explicit RunTree(const std::vector<SegmentBox>& boxes) : boxes_(boxes), runs_(runs_of(boxes)) {
    if (runs_.empty()) return;
    nodes_.reserve(2 * runs_.size());
    nodes_.push_back({});
    build(0, runs_.begin(), runs_.end());
  }

  void self_pairs(const std::function<void(int, int)>& visit) const {
    if (!nodes_.empty()) within(0, visit);
  }

 private:
  struct Node {
    SegmentBox box;
    int left = none;
    int begin = 0;  // boxes of a leaf
    int end = 0;
    int size = 0;  // boxes of the whole
  };

  using RunIterator = std::vector<Run>::iterator;

  void build(int node, RunIterator begin, RunIterator end) {
    Node made{begin->box, none, begin->begin, begin->end, 0};
    for (auto run = begin; run != end; ++run) {
      grow(made.box, run->box);
      made.size += run->end - run->begin;
    }
    if (end - begin > 1) made.left = static_cast<int>(nodes_.size());
    nodes_[idx(node)] = made;
    if (made.left == none) return;
    const SegmentBox& box = made.box;
    const std::size_t axis = box.high[0] - box.low[0] >= box.high[1] - box.low[1] ? 0 : 1;
    const auto middle = begin + (end - begin) / 2;
    std::nth_element(begin, middle, end, [axis](const Run& a, const Run& b) {
      const std::int64_t at = a.box.low[axis] + a.box.high[axis];
      const std::int64_t other = b.box.low[axis] + b.box.high[axis];
      return at != other ? at < other
                         : a.begin < b.begin;  // no two alike: one tree for all systems
    });
    nodes_.resize(nodes_.size() + 2);
    build(made.left, begin, middle);
    build(made.left + 1, middle, end);
  }

  void within(int n, const std::function<void(int, int)>& visit) const {
    const Node& node = nodes_[idx(n)];
    if (node.left == none) {
      for (int i = node.begin; i < node.end; ++i) {
        for (int j = i + 1; j < node.end; ++j) offer(i, j, visit);
      }
      return;
    }
    within(node.left, visit);
    within(node.left + 1, visit);
    between(node.left, node.left + 1, visit);
  }

  // The larger one is divided, so that boxes of about one size are compared.
  void between(int a, int b, const std::function<void(int, int)>& visit) const {
    const Node& p = nodes_[idx(a)];
    const Node& q = nodes_[idx(b)];
    if (!overlap(p.box, q.box)) return;
    if (p.left == none && q.left == none) {
      for (int i = p.begin; i < p.end; ++i) {
        if (!overlap(boxes_[idx(i)], q.box)) continue;
        for (int j = q.begin; j < q.end; ++j) offer(i, j, visit);
      }
      return;
    }
    if (q.left == none || (p.left != none && p.size >= q.size)) {
      between(p.left, b, visit);
      between(p.left + 1, b, visit);
    } else {
      between(a, q.left, visit);
      between(a, q.left + 1, visit);
    }
  }

  void offer(int i, int j, const std::function<void(int, int)>& visit) const {
    if (overlap(boxes_[idx(i)], boxes_[idx(j)])) visit(std::min(i, j), std::max(i, j));
  }

  const std::vector<SegmentBox>& boxes_;
  std::vector<Run> runs_;
  std::vector<Node> nodes_;
};

}  // namespace

void overlapping_boxes(const std::vector<SegmentBox>& boxes,
                       const std::function<void(int, int)>& visit) {
  RunTree(boxes).self_pairs(visit);
}

}  // namespace illustrate
