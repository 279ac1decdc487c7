#include "hatch/streamlines/cut_streamlines.h"

#include <algorithm>
#include <numeric>

#include "hatch/streamlines/neighbours.h"

namespace illustrate {
namespace {

// Streamlines whose nodes lie farther apart, in node steps, or not along their directions (cosine)
// are cut.
constexpr double most_gap = 3;
constexpr double least_straightness = 0.85;

class Cutter {
 public:
  Cutter(StreamlineSet& set, const HatchView& view, double test, double least_length)
      : set_(set), view_(view), test_(test), least_length_(least_length) {
    for (const Streamline& streamline : set.streamlines)
      alive_.emplace_back(streamline.nodes.size(), 1);
  }

  void cut() {
    std::vector<double> length;
    for (const Streamline& streamline : set_.streamlines)
      length.push_back(length_of(streamline.nodes));
    std::vector<int> order(length.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return length[idx(a)] < length[idx(b)]; });
    Streamlines pieces;
    for (const int streamline : order) cut_streamline(streamline, pieces);
    set_.streamlines = std::move(pieces);
    set_.rebuild();
  }

 private:
  bool stays(const Streamline& streamline, int number, int index) const {
    const StreamlineNode& node = streamline.nodes[idx(index)];
    if (node.is_held) return true;
    if (!view_.may_pass(node, streamline.spacing)) return false;
    const double radius = test_ * streamline.spacing;
    return !set_.grid.any_near(node.image, radius, [&](const GridNode& other) {
      if (other.streamline == number && std::abs(other.index - index) <= own_nodes) return false;
      return HatchView::distance(node, other, streamline.spacing, radius) < radius &&
             alive_[idx(other.streamline)][idx(other.index)] &&
             !view_.curves.separate(node.image, other.image);
    });
  }

  void cut_streamline(int number, Streamlines& pieces) {
    const Streamline& streamline = set_.streamlines[idx(number)];
    if (streamline.is_fixed) return pieces.push_back(streamline);
    std::vector<std::uint8_t>& alive = alive_[idx(number)];
    const int count = static_cast<int>(alive.size());
    for (int i = 0; i < count; ++i) alive[idx(i)] = stays(streamline, number, i);
    for (int from = 0, to; from < count; from = std::max(to, from + 1)) {
      for (to = from; to < count && alive[idx(to)] && (to == from || are_joined(streamline, to));)
        ++to;
      Streamline piece{{streamline.nodes.begin() + from, streamline.nodes.begin() + to},
                       streamline.object,
                       streamline.spacing};
      const bool is_long = length_of(piece.nodes) >= least_length_ * streamline.spacing;
      if (to - from >= 2 && (is_long || any_is_held(piece.nodes))) {
        pieces.push_back(std::move(piece));
      } else {
        std::fill(alive.begin() + from, alive.begin() + to, std::uint8_t{0});
      }
    }
  }

  // Whether nothing lies between a node and the one before it, and the way there is no kink.
  bool are_joined(const Streamline& streamline, int index) const {
    const StreamlineNode& a = streamline.nodes[idx(index - 1)];
    const StreamlineNode& b = streamline.nodes[idx(index)];
    if (a.is_held && b.is_held) return true;
    const Vec3 way = b.position - a.position;
    const double along = least_straightness * way.norm();
    return (b.image - a.image).norm() < most_gap * streamline.spacing * node_step &&
           way.dot(a.tangent) >= along && way.dot(b.tangent) >= along &&
           !view_.curves.separate(a.image, b.image);
  }

  StreamlineSet& set_;
  const HatchView& view_;
  double test_, least_length_;
  std::vector<std::vector<std::uint8_t>> alive_;  // of each node
};

}  // namespace

void cut_streamlines(StreamlineSet& set, const HatchView& view, double test, double least_length) {
  Cutter(set, view, test, least_length).cut();
}

}  // namespace illustrate
