#include "visibility/potential.h"

#include <algorithm>

namespace illustrate {
namespace {

constexpr double tip_px = 0.5;  // how near to an arc's ends its first and last samples are

class PathWalker {
 public:
  PathWalker(const Arrangement& arrangement, const Path& path)
      : arrangement_(arrangement), path_(path) {}

  PathLabels run() {
    for (std::size_t i = 0; i < path_.strands.size(); ++i) {
      if (i > 0) offset_ += path_.jumps[i];
      walk(path_.strands[i], path_.freed[i] != 0);
    }
    if (path_.cyclic) labels_.residual = offset_ + path_.jumps[0];
    return std::move(labels_);
  }

 private:
  void walk(int strand, bool freed) {
    const std::vector<Visit>& visits = arrangement_.visits[idx(strand)];
    const int count = static_cast<int>(visits.size());
    const bool closed = arrangement_.network->strands[idx(strand)].closed();
    if (!closed || count == 0) add_arc(strand, none, count == 0 ? none : 0, freed);
    for (int v = 0; v < count; ++v) {
      const Visit& visit = visits[idx(v)];
      if (!visit.front) {
        offset_ += back_change(arrangement_, arrangement_.crossings[idx(visit.crossing)]);
      }
      const bool last = v + 1 == count;
      add_arc(strand, v, last ? (closed ? 0 : none) : v + 1, is_demoted(strand, v));
    }
  }

  bool is_demoted(int strand, int visit) const {
    return !arrangement_.is_live(arrangement_.visits[idx(strand)][idx(visit)].crossing);
  }

  StrandPlace place(int strand, int visit, int point) const {
    if (visit != none) return arrangement_.visits[idx(strand)][idx(visit)].place;
    return {strand, point, 0};
  }

  void add_arc(int strand, int begin, int end, bool starts_free) {
    const int count = arrangement_.point_count(strand);
    const bool closed = arrangement_.network->strands[idx(strand)].closed();
    const StrandPlace from = place(strand, begin, 0);
    StrandPlace to = place(strand, end, closed ? count : count - 1);
    const bool wraps = closed && begin != none && end != none && end <= begin;
    if (wraps) to.segment += count;
    measure({strand, begin, end, offset_, starts_free, 0, {}}, from, to);
  }

  // Image length and the sample places.
  void measure(PathArc arc, const StrandPlace& from, const StrandPlace& to) {
    std::vector<StrandPlace>& places = places_;
    places.assign(1, from);
    for (int i = from.segment + 1; i <= to.segment; ++i) places.push_back({arc.strand, i, 0});
    places.push_back(to);
    std::vector<double>& reach = reach_;
    reach.assign(1, 0);
    Vec2 last = image_of(from);
    for (std::size_t i = 1; i < places.size(); ++i) {
      const Vec2 next = image_of(places[i]);
      reach.push_back(reach.back() + (next - last).norm());
      last = next;
    }
    arc.length_px = reach.back();
    const double tip = std::min(0.25, tip_px / std::max(reach.back(), tip_px));
    const std::array<double, 5> shares{tip, 0.25, 0.5, 0.75, 1 - tip};
    for (std::size_t k = 0; k < shares.size(); ++k) {
      const double wanted = reach.back() * shares[k];
      std::size_t i = 1;
      while (i + 1 < reach.size() && reach[i] < wanted) ++i;
      const double step = reach[i] - reach[i - 1];
      arc.samples[k] =
          between(places[i - 1], places[i], step > 0 ? (wanted - reach[i - 1]) / step : 0.5);
    }
    labels_.arcs.push_back(arc);
  }

  Vec2 image_of(const StrandPlace& p) const {
    if (p.fraction == 0) return arrangement_.image.image[arrangement_.point(p.strand, p.segment)];
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
  PathLabels labels_;
  int offset_ = 0;
  std::vector<StrandPlace> places_;  // of one arc
  std::vector<double> reach_;
};

}  // namespace

int imbalance(const Arrangement& arrangement, const Path& path) {
  int sum = 0;
  for (std::size_t i = 0; path.cyclic && i < path.strands.size(); ++i) {
    sum += path.jumps[i];
    for (const Visit& visit : arrangement.visits[idx(path.strands[i])]) {
      if (visit.front || !arrangement.is_live(visit.crossing)) continue;
      sum += back_change(arrangement, arrangement.crossings[idx(visit.crossing)]);
    }
  }
  return sum;
}

PathLabels relative_labels(const Arrangement& arrangement, const Path& path) {
  return PathWalker(arrangement, path).run();
}

}  // namespace illustrate
