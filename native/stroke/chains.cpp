#include "stroke/chains.h"

#include <algorithm>
#include <cmath>

namespace illustrate {
namespace {

// Directions at a node are taken this far along an arc (in units of the graph, as below), so that
// rounding to the image grid and the tiny hooks near cusps do not decide how a line goes on.
constexpr double direction_units = 1.0;

// A line whose tail is cut off goes on in another one if it turns by less than 150 degrees, one
// whose free end faces another across a gap by less than 60.
constexpr double cosine_of_sharpest_corner = 0.866;
constexpr double cosine_of_largest_turn = -0.5;
constexpr double gap_units = 1.0;
constexpr double steepest_gap = 8;  // in the world, in times the lines' own length for a pixel

// Ends are numbered 2 arc for the start of an arc, 2 arc + 1 for its end.
int number_of(const ArcEnd& end) { return 2 * end.arc + (end.at_start ? 0 : 1); }

int node_of(const LabelledGraph& graph, const ArcEnd& end) {
  const GraphArc& arc = graph.arcs[idx(end.arc)];
  return end.at_start ? arc.start_node : arc.end_node;
}

bool kind_is_drawn(Kind kind, const StrokeOptions& options) {
  switch (kind) {
    case Kind::seam:
      return false;
    case Kind::mark:
      return options.marks;
    case Kind::material:
      return options.materials;
    case Kind::flat_outline:
      return options.flat_outlines;
    default:
      return true;
  }
}

bool layers_are_drawn(int layers, const StrokeOptions& options) {
  if (layers == 0) return true;
  const auto& range = options.hidden_lines;
  return range && (*range)[0] <= layers && layers <= (*range)[1];
}

bool are_one_line(const GraphArc& a, const GraphArc& b) {
  return a.kind == b.kind && a.object == b.object && layers_over(a) == layers_over(b);
}

// Unit direction in which an arc leaves the node at this end; zero for an arc of no length.
Vec2 leaving_direction(const LabelledGraph& graph, const ArcEnd& end) {
  const Span<const Vec2> image = graph.image[idx(end.arc)];
  const auto nth = [&](std::size_t i) { return image[end.at_start ? i : image.size() - 1 - i]; };
  Vec2 away = Vec2::Zero();
  const double reach = direction_units * graph.unit_px;
  for (std::size_t i = 1; i < image.size() && away.norm() < reach; ++i) {
    away = nth(i) - nth(0);
  }
  const double length = away.norm();
  return length > 0 ? Vec2(away / length) : Vec2(Vec2::Zero());
}

class Mates {
 public:
  Mates(const LabelledGraph& graph, const std::vector<std::uint8_t>& drawn)
      : graph_(graph),
        drawn_(drawn),
        gap_px_(gap_units * graph.unit_px),
        mates_(2 * graph.arcs.size(), none) {
    for (std::size_t arc = 0; arc < graph.arcs.size(); ++arc) {
      lengths_px_.push_back(image_length(graph, static_cast<int>(arc)));
    }
  }

  void pair_at_crossing(const GraphNode& node) {
    const auto& arcs = node.arcs;
    join({arcs[0], false}, {arcs[1], true});
    join({arcs[2], false}, {arcs[3], true});
  }

  // Greedily, the smallest turn first; of equal turns the ends that come first.
  void pair_by_turn(Span<const ArcEnd> ends) {
    struct Candidate {
      double
          cosine;  // of the angle between the two directions away from the node: -1 is straight on
      std::size_t a, b;
    };
    std::vector<Candidate> candidates;
    for (std::size_t a = 0; a < ends.size(); ++a) {
      for (std::size_t b = a + 1; b < ends.size(); ++b) {
        if (!are_one_line(graph_.arcs[idx(ends[a].arc)], graph_.arcs[idx(ends[b].arc)])) continue;
        const double cosine =
            leaving_direction(graph_, ends[a]).dot(leaving_direction(graph_, ends[b]));
        candidates.push_back({cosine, a, b});
      }
    }
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.cosine < b.cosine; });
    for (const Candidate& c : candidates) join(ends[c.a], ends[c.b]);
  }

  // Where a line goes on for less than `speck_px` after a node and then ends freely, and another
  // one starts at that node in its direction: that one is its continuation, and the tail a speck.
  // Of several such nodes, the one nearest to the free end. Whether there is one.
  bool cut_tail(const ArcEnd& free_end, const Ragged<ArcEnd>& ends, double speck_px) {
    double length = 0;
    ArcEnd end = free_end;  // of the tail
    while (true) {
      length += lengths_px_[idx(end.arc)];
      end.at_start = !end.at_start;
      const ArcEnd before = of(end);
      if (before.arc == none || length >= speck_px) return false;
      const ArcEnd onward = continuation(before, ends[idx(node_of(graph_, before))]);
      if (onward.arc != none && !dangles(onward, ends, speck_px)) {
        mates_[idx(number_of(end))] = mates_[idx(number_of(before))] = none;
        join(before, onward);
        return true;
      }
      end = before;
    }
  }

  // A line that runs on from swallowtail to swallowtail does not dangle once the later tails are
  // cut.
  void cut_tails(const Ragged<ArcEnd>& ends, double speck_px) {
    for (bool changed = true; changed;) {
      changed = false;
      for (std::size_t n = 0; n < graph_.nodes.size(); ++n) {
        if (ends[n].size() == 1) changed |= cut_tail(ends[n][0], ends, speck_px);
      }
    }
  }

  // Two free ends less than a unit apart that face each other: their line is hidden for less than
  // the eye can see. The nearest pairs first.
  void close_gaps(const Ragged<ArcEnd>& ends) {
    std::vector<ArcEnd> free;
    for (std::size_t n = 0; n < graph_.nodes.size(); ++n) {
      if (ends[n].size() == 1 && of(ends[n][0]).arc == none) free.push_back(ends[n][0]);
    }
    std::stable_sort(free.begin(), free.end(), [&](const ArcEnd& a, const ArcEnd& b) {
      return image_at(a).x() < image_at(b).x();
    });
    struct Gap {
      double width;
      ArcEnd a, b;
    };
    std::vector<Gap> gaps;
    for (std::size_t i = 0; i < free.size(); ++i) {
      for (std::size_t j = i + 1; j < free.size(); ++j) {
        if (image_at(free[j]).x() - image_at(free[i]).x() > gap_px_) break;
        if (!face_each_other(free[i], free[j])) continue;
        gaps.push_back({(image_at(free[j]) - image_at(free[i])).norm(), free[i], free[j]});
      }
    }
    std::stable_sort(gaps.begin(), gaps.end(),
                     [](const Gap& a, const Gap& b) { return a.width < b.width; });
    for (const Gap& gap : gaps) join(gap.a, gap.b);
  }

  ArcEnd of(const ArcEnd& end) const {
    const int mate = mates_[idx(number_of(end))];
    return mate == none ? ArcEnd{} : ArcEnd{mate / 2, mate % 2 == 0};
  }

 private:
  // Of the ends without a mate the one that `end` turns into least, none where it turns too much.
  ArcEnd continuation(const ArcEnd& end, Span<const ArcEnd> ends) const {
    ArcEnd best;
    double least = cosine_of_sharpest_corner;
    for (const ArcEnd& other : ends) {
      if (other.arc == end.arc || of(other).arc != none) continue;
      if (!are_one_line(graph_.arcs[idx(end.arc)], graph_.arcs[idx(other.arc)])) continue;
      const double cosine = leaving_direction(graph_, end).dot(leaving_direction(graph_, other));
      if (cosine >= least) continue;
      least = cosine;
      best = other;
    }
    return best;
  }

  const Vec2& image_at(const ArcEnd& end) const {
    const Span<const Vec2> image = graph_.image[idx(end.arc)];
    return end.at_start ? image.front() : image.back();
  }

  const Vec3& world_at(const ArcEnd& end) const {
    const Span<const CurvePoint> points = graph_.points[idx(end.arc)];
    return (end.at_start ? points.front() : points.back()).position;
  }

  double world_length(int arc) const {
    const Span<const CurvePoint> points = graph_.points[idx(arc)];
    double length = 0;
    for (std::size_t i = 1; i < points.size(); ++i)
      length += (points[i].position - points[i - 1].position).norm();
    return length;
  }

  bool face_each_other(const ArcEnd& a, const ArcEnd& b) const {
    if (a.arc == b.arc || !are_one_line(graph_.arcs[idx(a.arc)], graph_.arcs[idx(b.arc)]))
      return false;
    if ((image_at(a) - image_at(b)).norm() > gap_px_) return false;
    const double px = lengths_px_[idx(a.arc)] + lengths_px_[idx(b.arc)];
    const double world = world_length(a.arc) + world_length(b.arc);
    if ((world_at(a) - world_at(b)).norm() * px > steepest_gap * gap_px_ * world) return false;
    return leaving_direction(graph_, a).dot(leaving_direction(graph_, b)) < cosine_of_largest_turn;
  }

  // Whether the line that starts at this end runs freely to its other one, in less than a speck.
  bool dangles(ArcEnd end, const Ragged<ArcEnd>& ends, double speck_px) const {
    double length = 0;
    while (true) {
      length += lengths_px_[idx(end.arc)];
      end.at_start = !end.at_start;
      const ArcEnd next = of(end);
      if (length >= speck_px) return false;
      if (next.arc == none) return ends[idx(node_of(graph_, end))].size() == 1;
      end = next;
    }
  }

  void join(const ArcEnd& a, const ArcEnd& b) {
    if (a.arc == none || b.arc == none || !drawn_[idx(a.arc)] || !drawn_[idx(b.arc)]) return;
    if (!are_one_line(graph_.arcs[idx(a.arc)], graph_.arcs[idx(b.arc)])) return;
    int& mate_of_a = mates_[idx(number_of(a))];
    int& mate_of_b = mates_[idx(number_of(b))];
    if (mate_of_a != none || mate_of_b != none) return;
    mate_of_a = number_of(b);
    mate_of_b = number_of(a);
  }

  const LabelledGraph& graph_;
  const std::vector<std::uint8_t>& drawn_;
  double gap_px_;
  std::vector<int> mates_;          // (ends) by number
  std::vector<double> lengths_px_;  // (arcs)
};

// The end at which the chain through `arc` starts; on a closed one, the start of `arc`.
ArcEnd first_end(const Mates& mates, int arc) {
  ArcEnd first{arc, true};
  for (ArcEnd before = mates.of(first); before.arc != none; before = mates.of(first)) {
    first = {before.arc, !before.at_start};
    if (first.arc == arc && first.at_start) break;
  }
  return first;
}

Chain follow(const LabelledGraph& graph, const Mates& mates, const ArcEnd& first) {
  Chain chain;
  ArcEnd last;
  for (ArcEnd next = first; next.arc != none; next = mates.of(last)) {
    if (!chain.arcs.empty() && next.arc == first.arc && next.at_start == first.at_start) {
      chain.closed = true;
      return chain;
    }
    chain.arcs.push_back(next.arc);
    chain.reversed.push_back(next.at_start ? 0 : 1);
    last = {next.arc, !next.at_start};
  }
  chain.start_node = node_of(graph, first);
  chain.end_node = node_of(graph, last);
  chain.closed = chain.start_node == none;  // a loop without nodes
  return chain;
}

}  // namespace

double image_length(const LabelledGraph& graph, int arc) {
  const Span<const Vec2> image = graph.image[idx(arc)];
  double length = 0;
  for (std::size_t i = 1; i < image.size(); ++i) length += (image[i] - image[i - 1]).norm();
  if (graph.arcs[idx(arc)].start_node == none) length += (image.back() - image.front()).norm();
  return length;
}

std::vector<std::uint8_t> drawn_arcs(const LabelledGraph& graph,
                                     const std::vector<std::uint8_t>& undrawn,
                                     const StrokeOptions& options) {
  std::vector<std::uint8_t> drawn;
  for (const GraphArc& arc : graph.arcs) {
    const bool object_is_drawn = undrawn.empty() || arc.object == none || !undrawn[idx(arc.object)];
    // An edge stands for such an intersection, or there is none to be seen.
    const bool is_double = arc.is_flush && arc.kind == Kind::intersection;
    drawn.push_back(object_is_drawn && kind_is_drawn(arc.kind, options) && !is_double &&
                    layers_are_drawn(layers_over(arc), options));
  }
  return drawn;
}

Ragged<ArcEnd> ends_at_nodes(const LabelledGraph& graph, const std::vector<std::uint8_t>& drawn) {
  return sorted_into<ArcEnd>(graph.nodes.size(), [&](const auto& put) {
    for (int a = 0; a < static_cast<int>(graph.arcs.size()); ++a) {
      if (!drawn[idx(a)] || graph.arcs[idx(a)].start_node == none) continue;
      for (const ArcEnd end : {ArcEnd{a, true}, ArcEnd{a, false}}) put(node_of(graph, end), end);
    }
  });
}

std::vector<Chain> chain_arcs(const LabelledGraph& graph, const std::vector<std::uint8_t>& drawn,
                              const Ragged<ArcEnd>& ends, double speck_px) {
  Mates mates(graph, drawn);
  for (std::size_t n = 0; n < graph.nodes.size(); ++n) {
    if (graph.nodes[n].kind == NodeKind::crossing) {
      mates.pair_at_crossing(graph.nodes[n]);
    } else {
      mates.pair_by_turn(ends[n]);
    }
  }
  mates.cut_tails(ends, speck_px);
  mates.close_gaps(ends);
  std::vector<Chain> chains;
  std::vector<std::uint8_t> chained(graph.arcs.size(), 0);
  for (int a = 0; a < static_cast<int>(graph.arcs.size()); ++a) {
    if (!drawn[idx(a)] || chained[idx(a)]) continue;
    chains.push_back(follow(graph, mates, first_end(mates, a)));
    for (const int arc : chains.back().arcs) chained[idx(arc)] = 1;
  }
  return chains;
}

}  // namespace illustrate
