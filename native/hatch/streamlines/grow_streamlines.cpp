#include "hatch/streamlines/grow_streamlines.h"

#include <algorithm>
#include <cmath>

namespace illustrate {
namespace {

// Hatches end this share of a spacing before a critical curve: on their own side of it.
constexpr double curve_margin = 0.0025;

// Nodes nearer than this share of a step have no direction between them.
constexpr double least_step = 0.05;

// The last steps of tips, in spacings, and how many of them.
constexpr double tip_step = 0.125;
constexpr int tip_steps = 4;

// Where the cross turns more than this in a node step, in radians, there is none to follow.
constexpr double most_turn = 0.6;

// No streamline needs more nodes.
constexpr int most_steps = 20'000;

constexpr std::size_t seeds_between_reports = 512;

struct Pace {
  double step;  // px
  double test;  // px
  int most;     // steps
};

// One end of a streamline that grows.
class Tip {
 public:
  Tip(const HatchView& view, StreamlineSet& set, int streamline, double spacing)
      : view_(view), set_(set), streamline_(streamline), spacing_(spacing) {}

  // Appends nodes beyond the last one, along its tangent; the first gets number `index + way`.
  void grow(std::vector<StreamlineNode>& nodes, int index, int way, const Pace& pace) const {
    Walk walk = view_.walker.start(nodes.back().on, nodes.back().tangent);
    for (int k = 1; k <= pace.most; ++k) {
      ++set_.steps;
      StreamlineNode node;
      const bool goes_on = step(walk, nodes.back(), pace.step, node);
      const bool is_long = (node.image - nodes.back().image).norm() > least_step * pace.step;
      if (!is_long || !view_.may_pass(node, spacing_)) return;
      if (view_.is_near(set_.grid, node, spacing_, pace.test, streamline_, index + way * k)) return;
      nodes.push_back(node);
      set_.grid.add(node, spacing_ * node_step / 2, streamline_, index + way * k);
      if (!goes_on) return;
    }
  }

 private:
  // One step; false where the streamline ends with it, at a critical curve or the edge of the
  // surface.
  bool step(Walk& walk, const StreamlineNode& from, double step_px, StreamlineNode& node) const {
    const Walk before = walk;
    node = from;
    WalkEnd end = view_.walker.advance(walk, step_px);
    if (walk.tangent.dot(before.tangent) < std::cos(most_turn)) return false;
    const HatchPoint point = view_.walker.point(walk.on);
    if (!view_.area.is_in_frame(point)) return false;
    const double crossing = view_.curves.first_crossing(from.image, point.image);
    if (crossing <= 1 || end == WalkEnd::silhouette) {
      const double reach =
          (point.image - from.image).norm() * std::min(1.0, crossing) - curve_margin * spacing_;
      if (!(reach > 0)) return false;
      walk = before;
      view_.walker.advance(walk, reach);
      end = WalkEnd::silhouette;
    }
    node = view_.node(walk.on, walk.tangent);
    return end == WalkEnd::whole;
  }

  const HatchView& view_;
  StreamlineSet& set_;
  int streamline_;
  double spacing_;
};

Pace whole_steps(double spacing, double test) {
  return {spacing * node_step, test * spacing, most_steps};
}

void grow_new(StreamlineSet& set, const HatchView& view, const StreamlineNode& first,
              const GrowRules& rules) {
  const Surface& surface = view.walker.on_surface().surface();
  const int object = surface.object_of(first.on.triangle);
  const double spacing = view.spacing_on(first.on.triangle);
  const int number = static_cast<int>(set.streamlines.size());
  if (view.is_near(set.grid, first, spacing, rules.clear * spacing, number, 0)) return;
  const std::size_t before = set.grid.size();
  set.grid.add(first, spacing * node_step / 2, number, 0);
  Streamline streamline{{first}, object, spacing};
  const Tip tip(view, set, number, spacing);
  tip.grow(streamline.nodes, 0, 1, whole_steps(spacing, rules.test));
  turn(streamline.nodes);
  tip.grow(streamline.nodes, 0, -1, whole_steps(spacing, rules.test));
  if (streamline.nodes.size() < 2 || length_of(streamline.nodes) < rules.least_length * spacing) {
    set.grid.shrink(before);
    return;
  }
  set.streamlines.push_back(std::move(streamline));
}

// Calls use(tip, nodes, index, way, spacing) for both ends of all streamlines, but those held.
template <class Use>
void at_all_ends(StreamlineSet& set, const HatchView& view, const Use& use) {
  for (std::size_t s = 0; s < set.streamlines.size(); ++s) {
    Streamline& streamline = set.streamlines[s];
    if (streamline.is_fixed) continue;
    const Tip tip(view, set, static_cast<int>(s), streamline.spacing);
    const int last = static_cast<int>(streamline.nodes.size()) - 1;
    if (!streamline.nodes.back().is_held) use(tip, streamline.nodes, last, 1, streamline.spacing);
    if (streamline.nodes.front().is_held) continue;
    turn(streamline.nodes);
    use(tip, streamline.nodes, 0, -1, streamline.spacing);
    turn(streamline.nodes);
  }
  set.rebuild();
}

}  // namespace

std::vector<StreamlineNode> seed_nodes(const HatchView& view,
                                       const std::vector<SurfacePoint>& seeds) {
  const Surface& surface = view.walker.on_surface().surface();
  std::vector<StreamlineNode> nodes;
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    view.walker.fetch_ahead(seeds, i);
    const SurfacePoint& on = seeds[i];
    if (!view.is_hatched(surface.object_of(on.triangle))) continue;
    StreamlineNode one = view.node_at(on);
    if (!view.lies_well(one)) continue;
    const Vec3 normal = normal_at(surface, on);
    const double spacing = view.spacing_on(on.triangle);
    view.direct(one, normal, normal.unitOrthogonal());
    const StreamlineNode other = view.across(one, normal);
    if (view.runs_well(one, spacing)) nodes.push_back(one);
    if (view.runs_well(other, spacing)) nodes.push_back(other);
  }
  return nodes;
}

void fill_streamlines(StreamlineSet& set, const HatchView& view,
                      const std::vector<StreamlineNode>& seeds, const GrowRules& rules,
                      const Progress& progress) {
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    if (i % seeds_between_reports == 0) {
      progress.report(static_cast<double>(i) / static_cast<double>(seeds.size()));
    }
    grow_new(set, view, seeds[i], rules);
  }
}

void extend_streamlines(StreamlineSet& set, const HatchView& view, double test) {
  at_all_ends(set, view, [&](const Tip& tip, auto& nodes, int index, int way, double spacing) {
    tip.grow(nodes, index, way, whole_steps(spacing, test));
  });
}

void extend_tips(StreamlineSet& set, const HatchView& view, double test, double tip_test) {
  at_all_ends(set, view, [&](const Tip& tip, auto& nodes, int index, int way, double spacing) {
    const std::size_t before = nodes.size();
    tip.grow(nodes, index, way, whole_steps(spacing, test));
    const int grown = static_cast<int>(nodes.size() - before);
    tip.grow(nodes, index + way * grown, way, {tip_step * spacing, tip_test * spacing, tip_steps});
  });
}

}  // namespace illustrate
