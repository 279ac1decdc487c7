#include "hatch/streamlines/merge_streamlines.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/disjoint_sets.h"

namespace illustrate {
namespace {

// In spacings.
constexpr double most_along = 3;
constexpr double most_across = 0.5;
// On flat faces any bridge shows in a line that is long enough to be seen as straight.
constexpr double most_across_ruled = 0.2;
constexpr double least_straight = 4;
constexpr double bridge_clear = 0.45;
constexpr double bridge_error = 0.25;  // how far from the other end a bridge may come out

constexpr double least_opposite = 0.755;  // cosine of 41 degrees

// Ends give up nodes until a bridge turns aside by no more than this, in radians: no kinks.
constexpr double most_offset = 0.15;
// The bridge of two ends that bend towards each other makes a greater angle with both.
constexpr double most_bend = 0.6;
constexpr std::size_t most_given_up = 6;

// An end of a streamline: number 2 s is its front, 2 s + 1 its back.
struct EndPair {
  double cost;
  int a, b;
  bool operator<(const EndPair& other) const {
    return std::tie(cost, a, b) < std::tie(other.cost, other.a, other.b);
  }
};

using Nodes = std::vector<StreamlineNode>;
using GivenUp = std::array<std::size_t, 2>;  // nodes of both ends

// What joins an end to its mate.
struct Join {
  int mate = none;
  std::size_t given_up = 0;  // nodes of the end
  Nodes bridge;              // from the end to its mate
};

class Merger {
 public:
  Merger(StreamlineSet& set, const HatchView& view, bool ruled)
      : set_(set),
        view_(view),
        ruled_(ruled),
        joins_(2 * set.streamlines.size()),
        yields_(set.streamlines.size(), 0),
        groups_(set.streamlines.size()) {}

  void merge() {
    std::vector<EndPair> pairs = facing_pairs();
    std::sort(pairs.begin(), pairs.end());
    for (const EndPair& pair : pairs) try_join(pair.a, pair.b);
    set_.streamlines = chained();
    set_.rebuild();
  }

 private:
  const Nodes& nodes_of(int end) const { return set_.streamlines[idx(end / 2)].nodes; }
  double spacing_of(int end) const { return set_.streamlines[idx(end / 2)].spacing; }

  // A streamline's node, counted from one of its ends.
  const StreamlineNode& node_from(int end, std::size_t i) const {
    const Nodes& nodes = nodes_of(end);
    return end % 2 == 0 ? nodes[i] : nodes[nodes.size() - 1 - i];
  }

  StreamlineNode outward(int end) const {
    StreamlineNode node = node_from(end, 0);
    if (end % 2 == 1) return node;
    node.tangent = -node.tangent;
    node.heading = -node.heading;
    return node;
  }

  std::vector<EndPair> facing_pairs() {
    const int count = static_cast<int>(joins_.size());
    Eigen::AlignedBox2d box;
    for (int end = 0; end < count; ++end) box.extend(node_from(end, 0).image);
    StreamlineGrid ends = view_.empty_grid(box);
    for (int end = 0; end < count; ++end) {
      if (!node_from(end, 0).is_held) ends.add(outward(end), 0, end / 2, end);
    }
    std::vector<EndPair> pairs;
    for (int end = 0; end < count; ++end) {
      if (node_from(end, 0).is_held) continue;
      const StreamlineNode node = outward(end);
      const bool ruled = is_ruled(end);
      const double spacing = set_.streamlines[idx(end / 2)].spacing;
      const double reach = most_along * spacing;
      ends.any_in_box(node.image, Vec2(reach, reach), [&](const GridNode& other) {
        if (other.streamline <= end / 2) return false;
        const double cost = cost_of(node, other, spacing);
        if (cost < 0) return false;
        const bool is_crooked = across(node, other) > most_across_ruled * spacing;
        if (is_crooked && ruled != is_ruled(other.index)) {
          yields_[idx(ruled ? other.streamline : end / 2)] = 1;
        } else if (!is_crooked || !ruled) {
          pairs.push_back({cost, end, other.index});
        }
        return false;
      });
    }
    return pairs;
  }

  // Negative where the two ends do not face each other.
  static double across(const StreamlineNode& node, const GridNode& other) {
    return std::abs((other.image - node.image).dot(node.left()));
  }

  double cost_of(const StreamlineNode& node, const GridNode& other, double spacing) const {
    const Vec2 offset = other.image - node.image;
    const double along = offset.dot(node.heading), aside = across(node, other);
    const bool faces = node.heading.dot(other.heading) < -least_opposite &&
                       node.tangent.dot(other.tangent.cast<double>()) < -least_opposite;
    if (!faces || along < 0 || along > most_along * spacing || aside > most_across * spacing ||
        !HatchView::is_alike(node, other, spacing) ||
        view_.curves.separate(node.image, other.image)) {
      return -1;
    }
    return along + 3 * aside;
  }

  // Whether an end is on a flat face and its streamline is seen as straight.
  bool is_ruled(int end) const {
    return ruled_ && view_.plane_of(node_from(end, 0)) != none &&
           length_of(nodes_of(end)) > least_straight * spacing_of(end);
  }

  void try_join(int a, int b) {
    const int one = groups_.root(a / 2), other = groups_.root(b / 2);
    if (joins_[idx(a)].mate != none || joins_[idx(b)].mate != none || one == other) return;
    if (set_.streamlines[idx(a / 2)].object != set_.streamlines[idx(b / 2)].object) return;
    const GivenUp given_up = nodes_to_give_up(a, b);
    Nodes bridge;
    if (!build_bridge(a, b, given_up, bridge)) return;
    for (const StreamlineNode& node : bridge) {
      set_.grid.add(node, spacing_of(a) * node_step / 2, a / 2, 0);
    }
    joins_[idx(b)] = {a, given_up[1], bridge};
    std::reverse(joins_[idx(b)].bridge.begin(), joins_[idx(b)].bridge.end());
    joins_[idx(a)] = {b, given_up[0], std::move(bridge)};
    groups_.join(one, other);
  }

  // Angles in the image from the ends' directions to the bridge, counted the same way round.
  struct Bend {
    double from, to;
    double offset() const { return std::abs(from + to) / 2; }
    double most() const { return std::max(std::abs(from), std::abs(to)); }
  };

  Bend bend_between(int a, int b, const GivenUp& given_up) const {
    const StreamlineNode &from = node_from(a, given_up[0]), &to = node_from(b, given_up[1]);
    const Vec2 way = to.image - from.image;
    const auto angle = [&](const Vec2& heading) {
      return std::atan2(cross(heading, way), heading.dot(way));
    };
    return {angle((a % 2 == 0 ? -1 : 1) * from.heading), angle((b % 2 == 0 ? 1 : -1) * to.heading)};
  }

  // Nodes of both ends, in turn, until the bridge turns aside little enough.
  GivenUp nodes_to_give_up(int a, int b) const {
    GivenUp given_up{0, 0};
    const auto may_give = [&](int end, std::size_t count) {
      return count < std::min(most_given_up, (nodes_of(end).size() - 1) / 2);
    };
    while (bend_between(a, b, given_up).offset() > most_offset) {
      const bool can_a = may_give(a, given_up[0]), can_b = may_give(b, given_up[1]);
      if (!can_a && !can_b) break;
      const bool is_a = can_a && (!can_b || given_up[0] <= given_up[1]);
      ++given_up[is_a ? 0 : 1];
    }
    return given_up;
  }

  bool build_bridge(int a, int b, const GivenUp& given_up, Nodes& bridge) const {
    const double spacing = spacing_of(a);
    const StreamlineNode &from = node_from(a, given_up[0]), &to = node_from(b, given_up[1]);
    if (bend_between(a, b, given_up).most() > most_bend) return false;
    const double gap = (to.image - from.image).norm();
    const int parts = std::max(1, static_cast<int>(std::lround(gap / (spacing * node_step))));
    const FieldWalker& walker = view_.walker.on_surface();
    SurfacePoint on = from.on;
    Vec3 position = from.position;
    for (int k = 1; k <= parts; ++k) {
      if (!walker.slide(on, (to.position - position) / (parts - k + 1))) return false;
      position = position_at(walker.surface(), on);
      if (k == parts) break;
      bridge.push_back(view_.node(on, to.position - from.position));
      if (!is_free(bridge.back(), spacing, a / 2, b / 2)) return false;
    }
    return (position - to.position).norm() < bridge_error * spacing * to.pixel &&
           !view_.curves.separate(from.image, to.image);
  }

  bool is_free(const StreamlineNode& node, double spacing, int one, int other) const {
    const double radius = bridge_clear * spacing;
    return view_.may_pass(node, spacing) &&
           !set_.grid.any_near(node.image, radius, [&](const auto& n) {
             return n.streamline != one && n.streamline != other &&
                    HatchView::distance(node, n, spacing, radius) < radius;
           });
  }

  // All streamlines, those that are joined as one; the others, and those that yield, are taken
  // away.
  Streamlines chained() {
    for (std::size_t s = 0; s < yields_.size(); ++s) {
      const bool is_joined = joins_[2 * s].mate != none || joins_[2 * s + 1].mate != none;
      if (yields_[s] && !is_joined) set_.streamlines[s].nodes.clear();
    }
    Streamlines result;
    std::vector<std::uint8_t> done(set_.streamlines.size(), 0);
    for (int end = 0; end < static_cast<int>(joins_.size()); ++end) {
      if (done[idx(end / 2)] || joins_[idx(end)].mate != none) continue;
      if (joins_[idx(end ^ 1)].mate == none) {
        result.push_back(std::move(set_.streamlines[idx(end / 2)]));
        done[idx(end / 2)] = 1;
        continue;
      }
      Streamline streamline{{}, set_.streamlines[idx(end / 2)].object, spacing_of(end)};
      append_chain(end, streamline.nodes, done);
      streamline.is_joined = true;
      resample(streamline, view_);
      result.push_back(std::move(streamline));
    }
    return result;
  }

  // The streamline from a free end on, and all that follow.
  void append_chain(int end, Nodes& chain, std::vector<std::uint8_t>& done) const {
    for (; end != none; end = joins_[idx(end ^ 1)].mate) {
      done[idx(end / 2)] = 1;
      const Join &before = joins_[idx(end)], &after = joins_[idx(end ^ 1)];
      const std::size_t last = nodes_of(end).size() - after.given_up;
      for (std::size_t i = before.given_up; i < last; ++i) chain.push_back(node_from(end, i));
      chain.insert(chain.end(), after.bridge.begin(), after.bridge.end());
    }
  }

  StreamlineSet& set_;
  const HatchView& view_;
  bool ruled_;
  std::vector<Join> joins_;  // of each end
  // Of each streamline: whether it goes where a long one beside its line will go on.
  std::vector<std::uint8_t> yields_;
  DisjointSets groups_;  // of streamlines that are joined
};

// Turns tangents along the streamline.
void orient(Nodes& nodes) {
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const std::size_t a = i == 0 ? 0 : i - 1, b = std::min(i + 1, nodes.size() - 1);
    if (nodes[i].tangent.dot(nodes[b].position - nodes[a].position) < 0) turn(nodes[i]);
  }
}

// Nodes along a line, about a step apart, but its ends.
void add_between(const Nodes& line, double spacing, const HatchView& view, Nodes& nodes) {
  const double length = length_of(line);
  const int parts = std::max(1, static_cast<int>(std::lround(length / (spacing * node_step))));
  double passed = 0;  // up to node `i`
  std::size_t i = 0;
  for (int k = 1; k < parts; ++k) {
    const double target = length * k / parts;
    double step = (line[i + 1].image - line[i].image).norm();
    for (; i + 2 < line.size() && passed + step < target;) {
      passed += step;
      ++i;
      step = (line[i + 1].image - line[i].image).norm();
    }
    const double share = step > 0 ? std::clamp((target - passed) / step, 0.0, 1.0) : 0;
    const Vec3 run = line[i + 1].position - line[i].position;
    SurfacePoint on = line[i].on;
    view.walker.on_surface().slide(on, share * run);
    nodes.push_back(view.node(on, run));
  }
}

}  // namespace

void merge_streamlines(StreamlineSet& set, const HatchView& view, bool ruled) {
  Merger(set, view, ruled).merge();
}

void resample(Streamline& streamline, const HatchView& view) {
  const Nodes old = std::move(streamline.nodes);
  Nodes& nodes = streamline.nodes;
  nodes.assign(1, old.front());
  for (std::size_t from = 0; from + 1 < old.size();) {
    std::size_t to = from + 1;
    while (to + 1 < old.size() && !old[to].is_held) ++to;
    const bool stays = old[from].is_held && to == from + 1;
    const Nodes stretch(old.begin() + static_cast<std::ptrdiff_t>(from),
                        old.begin() + static_cast<std::ptrdiff_t>(to) + 1);
    if (!stays) add_between(stretch, streamline.spacing, view, nodes);
    nodes.push_back(old[to]);
    from = to;
  }
  orient(nodes);
}

}  // namespace illustrate
