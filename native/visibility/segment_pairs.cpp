#include "visibility/segment_pairs.h"

#include <algorithm>
#include <numeric>

namespace illustrate {
namespace {

constexpr int leaf_size = 8;

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

// A binary tree of boxes; a node's children are `left` and `left + 1`, leaves hold a range of
// `order`.
class BoxTree {
 public:
  explicit BoxTree(const std::vector<SegmentBox>& boxes) : boxes_(boxes), order_(boxes.size()) {
    std::iota(order_.begin(), order_.end(), 0);
    if (boxes.empty()) return;
    nodes_.push_back({});
    build(0, 0, static_cast<int>(boxes.size()));
  }

  void self_pairs(const std::function<void(int, int)>& visit) const {
    if (!nodes_.empty()) within(0, visit);
  }

 private:
  struct Node {
    SegmentBox box;
    int left = none;
    int begin = 0;
    int end = 0;
  };

  void build(int node, int begin, int end) {
    SegmentBox box = boxes_[idx(order_[idx(begin)])];
    for (int i = begin + 1; i < end; ++i) grow(box, boxes_[idx(order_[idx(i)])]);
    nodes_[idx(node)] = {box, none, begin, end};
    if (end - begin <= leaf_size) return;
    const std::size_t axis = box.high[0] - box.low[0] >= box.high[1] - box.low[1] ? 0 : 1;
    const int middle = (begin + end) / 2;
    const auto centre = [&](int i) { return boxes_[idx(i)].low[axis] + boxes_[idx(i)].high[axis]; };
    std::nth_element(
        order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
        [&](int i, int j) { return centre(i) != centre(j) ? centre(i) < centre(j) : i < j; });
    const int left = static_cast<int>(nodes_.size());
    nodes_[idx(node)].left = left;
    nodes_.resize(nodes_.size() + 2);
    build(left, begin, middle);
    build(left + 1, middle, end);
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

  void between(int a, int b, const std::function<void(int, int)>& visit) const {
    const Node& p = nodes_[idx(a)];
    const Node& q = nodes_[idx(b)];
    if (!overlap(p.box, q.box)) return;
    if (p.left == none && q.left == none) {
      for (int i = p.begin; i < p.end; ++i) {
        for (int j = q.begin; j < q.end; ++j) offer(i, j, visit);
      }
      return;
    }
    const bool descend_first =
        q.left == none || (p.left != none && p.end - p.begin >= q.end - q.begin);
    if (descend_first) {
      between(p.left, b, visit);
      between(p.left + 1, b, visit);
    } else {
      between(a, q.left, visit);
      between(a, q.left + 1, visit);
    }
  }

  void offer(int i, int j, const std::function<void(int, int)>& visit) const {
    const int a = order_[idx(i)], b = order_[idx(j)];
    if (overlap(boxes_[idx(a)], boxes_[idx(b)])) visit(std::min(a, b), std::max(a, b));
  }

  const std::vector<SegmentBox>& boxes_;
  std::vector<int> order_;
  std::vector<Node> nodes_;
};

}  // namespace

void overlapping_boxes(const std::vector<SegmentBox>& boxes,
                       const std::function<void(int, int)>& visit) {
  BoxTree(boxes).self_pairs(visit);
}

}  // namespace illustrate
