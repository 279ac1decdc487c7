#include "visibility/labels/path_arcs.h"

#include <algorithm>

namespace illustrate {
namespace {

class PathWalker {
 public:
  PathWalker(const Arrangement& arrangement, const Path& path)
      : arrangement_(arrangement), path_(path) {}

  std::vector<PathArc> run() {
    for (std::size_t i = 0; i < path_.strands.size(); ++i) walk(static_cast<int>(i));
    return std::move(arcs_);
  }

 private:
  void walk(int step) {
    const int strand = path_.strands[idx(step)];
    const int count = static_cast<int>(arrangement_.visits(strand).size());
    const bool closed = arrangement_.strand(strand).closed();
    if (!closed || count == 0) add_arc(step, none, count == 0 ? none : 0);
    for (int v = 0; v < count; ++v) {
      const bool is_last = v + 1 == count;
      add_arc(step, v, is_last ? (closed ? 0 : none) : v + 1);
    }
  }

  StrandPlace place(int strand, int visit, int point) const {
    if (visit != none) return arrangement_.visits(strand)[idx(visit)].place;
    return {strand, point, 0};
  }

  void add_arc(int step, int begin, int end) {
    const int strand = path_.strands[idx(step)];
    const int count = arrangement_.point_count(strand);
    const bool closed = arrangement_.strand(strand).closed();
    const StrandPlace from = place(strand, begin, 0);
    StrandPlace to = place(strand, end, closed ? count : count - 1);
    const bool wraps = closed && begin != none && end != none && end <= begin;
    if (wraps) to.segment += count;
    measure({strand, begin, end, step, 0, {}}, from, to);
  }

  // Image length and the sample places.
  void measure(PathArc arc, const StrandPlace& from, const StrandPlace& to) {
    places_.assign(1, from);
    for (int i = from.segment + 1; i <= to.segment; ++i) places_.push_back({arc.strand, i, 0});
    places_.push_back(to);
    reach_.assign(1, 0);
    Vec2 last = image_of(from);
    for (std::size_t i = 1; i < places_.size(); ++i) {
      const Vec2 next = image_of(places_[i]);
      reach_.push_back(reach_.back() + (next - last).norm());
      last = next;
    }
    arc.length_px = reach_.back();
    for (std::size_t k = 0; k < arc.samples.size(); ++k) {
      arc.samples[k] = at_share(static_cast<double>(k + 1) / 4);
    }
    arcs_.push_back(arc);
  }

  StrandPlace at_share(double share) const {
    const double wanted = reach_.back() * share;
    std::size_t i = 1;
    while (i + 1 < reach_.size() && reach_[i] < wanted) ++i;
    const double step = reach_[i] - reach_[i - 1];
    return between(places_[i - 1], places_[i], step > 0 ? (wanted - reach_[i - 1]) / step : 0.5);
  }

  Vec2 image_of(const StrandPlace& p) const {
    if (p.fraction == 0) return arrangement_.image_of(p.strand, p.segment);
    return arrangement_.image_at(p);
  }

  // A place within a stretch of one segment, whose `to` may be written as the start of the next
  // one.
  StrandPlace between(const StrandPlace& from, const StrandPlace& to, double share) const {
    const double end = to.segment == from.segment ? to.fraction : 1;
    const int count = arrangement_.point_count(from.strand);
    return {from.strand, from.segment % count, from.fraction + share * (end - from.fraction)};
  }

  const Arrangement& arrangement_;
  const Path& path_;
  std::vector<PathArc> arcs_;
  std::vector<StrandPlace> places_;  // of one arc
  std::vector<double> reach_;
};

}  // namespace

int imbalance(const Arrangement& arrangement, const Path& path) {
  int sum = 0;
  for (std::size_t i = 0; path.cyclic && i < path.strands.size(); ++i) {
    sum += path.jumps[i];
    for (const Visit& visit : arrangement.visits(path.strands[i])) {
      if (visit.front || !arrangement.is_live(visit.crossing)) continue;
      sum += back_change(arrangement, arrangement.crossing(visit.crossing));
    }
  }
  return sum;
}

std::vector<PathArc> path_arcs(const Arrangement& arrangement, const Path& path) {
  return PathWalker(arrangement, path).run();
}

std::vector<std::vector<PathArc>> arcs_of_paths(const Arrangement& arrangement) {
  std::vector<std::vector<PathArc>> arcs;
  for (const Path& path : arrangement.paths()) arcs.push_back(path_arcs(arrangement, path));
  return arcs;
}

}  // namespace illustrate
