#include "hatch/streamlines/relax_streamlines.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "hatch/streamlines/neighbours.h"

namespace illustrate {
namespace {

// In spacings.
constexpr double most_pull = 0.4;
constexpr double most_sweep_move = 0.19;  // in a sweep
constexpr double stiffness = 2.4;         // length over which a streamline bends

constexpr double share_moved = 0.75;  // of the solution, in a sweep

// Every other node is drawn to its place, in turn; each stands for two.
constexpr double full_weight = 2;
constexpr double one_sided = 0.5;  // share of it for a pull that knows one neighbour only

// Of a streamline that is straightened: how its nodes are drawn to where they are, and how far in
// spacings it stays from others.
constexpr double stay_weight = 12;
constexpr double least_apart = 0.51;

// Of a node that is held.
constexpr double holding_weight = 1e6;

// A node moves in the image at most so many times as far as it is meant to.
constexpr double most_overshoot = 1.3;

// Angles of streamlines to the cross grow no further than this: what is beyond weighs more.
constexpr double most_drift = 0.055;  // radians
constexpr double most_stiffening = 30;
// On flat faces any drift shows: there they move as they are.
constexpr double flat_stiffening = 1e4;

// How far ahead the surface is asked for.
constexpr std::size_t nodes_ahead = 3;

struct Pull {
  double by = 0;  // px to the left
  double weight = 0;
};

// Between two nodes.
struct Segment {
  double px;
  double angle;        // in the image, from the field to the segment
  double angle_ratio;  // mean of the nodes
  double bending;      // weight of the angle, against pulls of weight 1
};

class Relaxer {
 public:
  Relaxer(const StreamlineSet& set, const HatchView& view, int sweep)
      : set_(set), view_(view), sweep_(sweep) {}

  // The nodes drawn to the middle between neighbours; those that would move by less than
  // `least_move` spacings are held.
  std::vector<StreamlineNode> evened(int number, double least_move) const {
    const Streamline& streamline = set_.streamlines[idx(number)];
    const int count = static_cast<int>(streamline.nodes.size());
    std::vector<Pull> pulls;
    pulls.reserve(streamline.nodes.size());
    if (are_all_held(streamline.nodes)) return streamline.nodes;
    for (int i = 0; i < count; ++i) {
      const bool is_drawn = (i + sweep_) % 2 == 0 || count == 2;
      pulls.push_back(is_drawn ? pull_at(streamline, number, i) : Pull{});
    }
    std::vector<StreamlineNode> nodes = moved(streamline, pulls, least_move);
    drop_stuck_ends(streamline.nodes, nodes);
    return nodes;
  }

  // The nodes drawn to where they are, if none comes too near to another streamline by that.
  std::vector<StreamlineNode> straightened(int number) const {
    const Streamline& streamline = set_.streamlines[idx(number)];
    const std::vector<Pull> pulls(streamline.nodes.size(), Pull{0, stay_weight});
    std::vector<StreamlineNode> nodes = moved(streamline, pulls, 0);
    const double radius = least_apart * streamline.spacing;
    const auto is_near = [&](const StreamlineNode& node, std::size_t i) {
      return view_.is_near(set_.grid, node, streamline.spacing, radius, number,
                           static_cast<int>(i));
    };
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (is_near(nodes[i], i) && !is_near(streamline.nodes[i], i)) return streamline.nodes;
    }
    return nodes;
  }

 private:
  std::vector<StreamlineNode> moved(const Streamline& streamline, std::vector<Pull> pulls,
                                    double least_move) const {
    for (std::size_t i = 0; i < pulls.size(); ++i) {
      if (streamline.nodes[i].is_held) pulls[i] = {0, holding_weight};
    }
    std::vector<Segment> segments = segments_of(streamline);
    std::vector<double> shift = solve(segments, pulls);
    if (stiffen(segments, shift)) shift = solve(segments, pulls);
    if (least_move > 0) shift = held(segments, pulls, shift, least_move * streamline.spacing);
    std::vector<StreamlineNode> nodes;
    nodes.reserve(streamline.nodes.size());
    for (std::size_t i = 0; i < streamline.nodes.size(); ++i) {
      if (i + nodes_ahead < streamline.nodes.size()) {
        view_.walker.fetch(streamline.nodes[i + nodes_ahead].on);
      }
      const StreamlineNode& node = streamline.nodes[i];
      const double most = most_sweep_move * streamline.spacing;
      const double px = std::clamp(share_moved * shift[i], -most, most);
      nodes.push_back(node.is_held ? node : shifted(node, px));
    }
    return nodes;
  }

  // The solution again, nodes that it would move by less than `least` held where they are.
  static std::vector<double> held(const std::vector<Segment>& segments, std::vector<Pull>& pulls,
                                  const std::vector<double>& shift, double least) {
    const auto stays = [&](double by) { return std::abs(share_moved * by) < least; };
    if (std::none_of(shift.begin(), shift.end(), stays)) return shift;
    for (std::size_t i = 0; i < shift.size(); ++i) {
      if (stays(shift[i])) pulls[i] = {0, holding_weight};
    }
    std::vector<double> result = solve(segments, pulls);
    for (std::size_t i = 0; i < shift.size(); ++i) {
      if (stays(shift[i])) result[i] = 0;
    }
    return result;
  }

  // On flat faces ends that could not go with the others, since an edge is there, would be hooks:
  // ends are extended again.
  void drop_stuck_ends(const std::vector<StreamlineNode>& from,
                       std::vector<StreamlineNode>& to) const {
    const auto is_stuck = [&](std::size_t i) {
      return is_flat(from[i]) && from[i].image == to[i].image && !from[i].is_held;
    };
    std::size_t begin = 0, end = to.size();
    while (begin < end && is_stuck(begin)) ++begin;
    while (end > begin && is_stuck(end - 1)) --end;
    if (end - begin < 2) return;
    to.erase(to.begin() + static_cast<std::ptrdiff_t>(end), to.end());
    to.erase(to.begin(), to.begin() + static_cast<std::ptrdiff_t>(begin));
  }

  // A critical curve nearer than the neighbour takes its place: as far beyond as the node is before
  // it.
  double mirrored(const StreamlineNode& node, const Vec2& side, double distance,
                  double spacing) const {
    const double most = curve_reach * spacing, far = std::min(distance, most);
    const double at = curve_beside(view_, node, side, far);
    return at <= far ? std::clamp(2 * at, 0.5 * spacing, most) : distance;
  }

  Pull pull_at(const Streamline& streamline, int number, int index) const {
    const StreamlineNode& node = streamline.nodes[idx(index)];
    const double spacing = streamline.spacing, most = most_pull * spacing;
    const auto beside = neighbours(set_, number, index);
    const double left = mirrored(node, node.left(), beside[0].distance, spacing);
    const double right = mirrored(node, -node.left(), beside[1].distance, spacing);
    Pull pull;
    if (std::isfinite(left) && std::isfinite(right)) {
      pull = {(left - right) / 2, full_weight};
    } else if (std::isfinite(left)) {
      pull = {(left - spacing) / 2, one_sided * full_weight};
    } else if (std::isfinite(right)) {
      pull = {(spacing - right) / 2, one_sided * full_weight};
    }
    pull.by = std::clamp(pull.by, -most, most);
    return pull;
  }

  static bool are_all_held(const std::vector<StreamlineNode>& nodes) {
    return std::all_of(nodes.begin(), nodes.end(),
                       [](const StreamlineNode& node) { return node.is_held; });
  }

  bool is_flat(const StreamlineNode& node) const { return view_.plane_of(node) != none; }

  std::vector<Segment> segments_of(const Streamline& streamline) const {
    const double length = stiffness * streamline.spacing, least_px = 1e-3 * streamline.spacing;
    std::vector<Segment> segments;
    segments.reserve(streamline.nodes.size());
    for (std::size_t i = 0; i + 1 < streamline.nodes.size(); ++i) {
      const StreamlineNode &a = streamline.nodes[i], &b = streamline.nodes[i + 1];
      const Vec2 field = a.heading + b.heading, chord = b.image - a.image;
      const double angle_ratio = (a.angle_ratio + b.angle_ratio) / 2;
      const double stiffening = is_flat(a) && is_flat(b) ? flat_stiffening : 1;
      segments.push_back(
          {std::max(chord.norm(), least_px), std::atan2(cross(field, chord), field.dot(chord)),
           angle_ratio,
           stiffening * length * length * std::clamp(angle_ratio * angle_ratio, 0.1, 9.0)});
    }
    return segments;
  }

  // Minimises sum of weight (x - pull)^2 + bending (angle + x')^2.
  static std::vector<double> solve(const std::vector<Segment>& segments,
                                   const std::vector<Pull>& pulls) {
    const std::size_t count = pulls.size();
    std::vector<double> diagonal(count, 1e-9), next(count, 0), right(count, 0);
    for (std::size_t i = 0; i < count; ++i) {
      diagonal[i] += pulls[i].weight;
      right[i] += pulls[i].weight * pulls[i].by;
    }
    for (std::size_t i = 0; i + 1 < count; ++i) {
      const double px = segments[i].px, k = segments[i].bending / (px * px);
      const double turn = k * segments[i].angle * px;
      diagonal[i] += k, diagonal[i + 1] += k, next[i] = -k;
      right[i] += turn, right[i + 1] -= turn;
    }
    for (std::size_t i = 1; i < count; ++i) {
      const double factor = next[i - 1] / diagonal[i - 1];
      diagonal[i] -= factor * next[i - 1];
      right[i] -= factor * right[i - 1];
    }
    for (std::size_t i = count; i-- > 0;) {
      if (i + 1 < count) right[i] -= next[i] * right[i + 1];
      right[i] /= diagonal[i];
    }
    return right;
  }

  // Segments that would turn too far off the cross weigh more; whether there are any.
  static bool stiffen(std::vector<Segment>& segments, const std::vector<double>& shift) {
    bool any = false;
    for (std::size_t i = 0; i < segments.size(); ++i) {
      Segment& segment = segments[i];
      const double turn = (shift[i + 1] - shift[i]) / segment.px;
      const double excess = std::abs(segment.angle + turn) * segment.angle_ratio / most_drift;
      if (!(excess > 1)) continue;
      segment.bending *= std::min(excess * excess, most_stiffening);
      any = true;
    }
    return any;
  }

  // Stays where it would leave its side of a critical curve, or the surface. Near outlines the way
  // that is right at the node may lead too far: then less of it.
  StreamlineNode shifted(const StreamlineNode& node, double px) const {
    if (px == 0) return node;
    const double facing = view_.walker.facing_at(node.on);
    double way = px;
    for (int attempt = 0; attempt < 3; ++attempt) {
      SurfacePoint on = node.on;
      if (!view_.walker.on_surface().slide(on, way * node.aside)) return node;
      const StreamlineNode result = view_.node(on, node.tangent);
      const double moved = (result.image - node.image).norm();
      if (moved <= most_overshoot * std::abs(px)) {
        const bool stays = view_.walker.facing_at(on) * facing > 0 &&
                           !view_.curves.separate(node.image, result.image);
        return stays ? result : node;
      }
      way *= std::abs(px) / moved;
    }
    return node;
  }

  const StreamlineSet& set_;
  const HatchView& view_;
  int sweep_;
};

// Calls moved(relaxer, number) for the streamlines that are chosen. Threads share the nodes evenly:
// each takes the streamlines that start in its part.
template <class Chosen, class Moved>
void sweep(StreamlineSet& set, const HatchView& view, int number, int threads,
           const Chosen& is_chosen, const Moved& moved) {
  if (set.grid.has_additions()) set.rebuild();
  std::vector<std::vector<StreamlineNode>> nodes(set.streamlines.size());
  std::vector<std::size_t> starts;
  std::size_t count = 0;
  for (const Streamline& streamline : set.streamlines) {
    starts.push_back(count);
    count += streamline.nodes.size();
  }
  const Relaxer relaxer(set, view, number);
  parallel_for(count, threads, [&](std::size_t begin, std::size_t end) {
    const auto first = std::lower_bound(starts.begin(), starts.end(), begin);
    for (auto s = static_cast<std::size_t>(first - starts.begin());
         s < starts.size() && starts[s] < end; ++s) {
      if (is_chosen(set.streamlines[s])) nodes[s] = moved(relaxer, static_cast<int>(s));
    }
  });
  for (std::size_t s = 0; s < nodes.size(); ++s) {
    if (is_chosen(set.streamlines[s])) set.streamlines[s].nodes = std::move(nodes[s]);
  }
  set.rebuild();
}

void forget_joins(StreamlineSet& set) {
  for (Streamline& streamline : set.streamlines) streamline.is_joined = false;
}

}  // namespace

void relax_streamlines(StreamlineSet& set, const HatchView& view, int sweeps, int threads,
                       const Progress& progress, double least_move) {
  for (int k = 0; k < sweeps; ++k) {
    progress.report(static_cast<double>(k) / sweeps);
    sweep(
        set, view, k, threads, [](const Streamline& streamline) { return !streamline.is_fixed; },
        [&](const Relaxer& relaxer, int number) { return relaxer.evened(number, least_move); });
  }
  forget_joins(set);
}

void straighten_joined(StreamlineSet& set, const HatchView& view, int sweeps, int threads) {
  for (int k = 0; k < sweeps; ++k) {
    sweep(
        set, view, k, threads, [](const Streamline& streamline) { return streamline.is_joined; },
        [](const Relaxer& relaxer, int number) { return relaxer.straightened(number); });
  }
  forget_joins(set);
}

}  // namespace illustrate
