#include "contour/cusp_ends.h"

#include <algorithm>

#include "surface/locate.h"

namespace illustrate {
namespace {

constexpr double farthest_px = 1.6 * cusp_reach_px;
constexpr double swallowtail_px = 0.25;

// Steps along a chain in one direction, round a closed one.
class Walk {
 public:
  Walk(std::size_t count, bool closed, std::size_t from, bool forward)
      : count_(count), closed_(closed), at_(from), forward_(forward) {}

  // False at the end of an open chain, and after a whole round.
  bool step() {
    if (++steps_ >= count_) return false;
    if (!closed_ && at_ == (forward_ ? count_ - 1 : 0)) return false;
    at_ = forward_ ? (at_ + 1) % count_ : (at_ + count_ - 1) % count_;
    return true;
  }
  std::size_t at() const { return at_; }

 private:
  std::size_t count_;
  bool closed_;
  std::size_t at_;
  bool forward_;
  std::size_t steps_ = 0;
};

// Cusps, ends, and points on edges that may be curves.
bool must_stay(const Surface& surface, bool closed, const std::vector<ExactPoint>& chain,
               std::size_t i) {
  const ChainPoint& p = chain[i].point;
  const bool is_end = !closed && (i == 0 || i + 1 == chain.size());
  if (is_end || chain[i].is_cusp()) return true;
  return p.edge != none && surface.edge_kinds[idx(p.on.triangle)][idx(p.edge)] != EdgeKind::smooth;
}

// What happens on one side of a cusp: points to drop, and one to put behind point `behind` of the
// chain.
struct Clearing {
  std::vector<std::size_t> dropped;
  std::size_t behind = 0;
  std::optional<ExactPoint> added;
};

class Thinner {
 public:
  Thinner(const Surface& surface, const Camera& camera, ExactSegment& segment, bool closed,
          const std::vector<ExactPoint>& chain)
      : surface_(surface), camera_(camera), segment_(segment), closed_(closed), chain_(chain) {}

  std::vector<ExactPoint> run() {
    std::vector<std::uint8_t> dropped(chain_.size(), 0);
    std::vector<std::vector<ExactPoint>> added(chain_.size());
    for (std::size_t i = 0; i < chain_.size(); ++i) {
      if (!chain_[i].is_cusp()) continue;
      for (const bool forward : {false, true}) {
        Clearing clearing = clear(i, forward);
        for (const std::size_t k : clearing.dropped) dropped[k] = 1;
        if (clearing.added) added[clearing.behind].push_back(*clearing.added);
      }
    }
    return put_together(dropped, added);
  }

 private:
  double distance(std::size_t cusp, const Vec2& image) const {
    return (image - chain_[cusp].image).norm();
  }

  Clearing clear(std::size_t cusp, bool forward) {
    Clearing result;
    Walk walk(chain_.size(), closed_, cusp, forward);
    std::size_t last = cusp;
    while (walk.step()) {
      const std::size_t at = walk.at();
      const double reached = distance(cusp, chain_[at].image);
      if (is_kept(at)) {
        if (reached < farthest_px) return result;
      } else if (reached < cusp_reach_px) {
        result.dropped.push_back(at);
        last = at;
        continue;
      }
      if (reached > farthest_px)
        add_between(cusp, forward ? last : at, forward ? at : last, result);
      return result;
    }
    return {};
  }

  bool is_kept(std::size_t i) const { return must_stay(surface_, closed_, chain_, i); }

  // A point of the segment from a to b (neighbours in the chain's order), at the right distance.
  void add_between(std::size_t cusp, std::size_t a, std::size_t b, Clearing& clearing) {
    const bool grows = distance(cusp, chain_[a].image) < distance(cusp, chain_[b].image);
    double low = 0, high = 1;  // distances below and above what is wanted, or the other way round
    for (int i = 0; i < 24; ++i) {
      const double f = (low + high) / 2;
      const std::optional<ExactPoint> p = point_between(chain_[a], chain_[b], f);
      if (!p) return;
      const double reached = distance(cusp, p->image);
      if (reached >= cusp_reach_px && reached <= farthest_px) {
        clearing.behind = a;
        clearing.added = p;
        return;
      }
      ((reached < cusp_reach_px) == grows ? low : high) = f;
    }
  }

  std::optional<ExactPoint> point_between(const ExactPoint& a, const ExactPoint& b, double f) {
    const int t = a.point.on.triangle;
    ExactPoint result;
    result.segment = a.segment;
    if (a.knot && b.knot) {
      const PatchTriangle& patch = surface_.patches[idx(t)];
      ContourKnot end = *b.knot;
      end.uv = b.arrival;
      const auto knot = segment_.between(patch.ptex_face, *a.knot, end, f);
      if (!knot) return {};
      result.knot = knot;
      result.image = knot->image;
      result.point.position = knot->sample.position;
      result.point.on = on_triangle(patch, t, knot->uv);
      return result;
    }
    result.point.position = a.point.position + f * (b.point.position - a.point.position);
    result.point.on = locate(surface_, t, result.point.position);
    result.image = camera_.project(result.point.position).xy;
    return result;
  }

  std::vector<ExactPoint> put_together(const std::vector<std::uint8_t>& dropped,
                                       const std::vector<std::vector<ExactPoint>>& added) {
    std::vector<ExactPoint> result;
    for (std::size_t i = 0; i < chain_.size(); ++i) {
      if (!dropped[i]) result.push_back(chain_[i]);
      result.insert(result.end(), added[i].begin(), added[i].end());
    }
    return result;
  }

  const Surface& surface_;
  const Camera& camera_;
  ExactSegment& segment_;
  bool closed_;
  const std::vector<ExactPoint>& chain_;
};

// The points of the strand that leaves a cusp in one direction, as long as they recede from it.
std::vector<std::size_t> receding(bool closed, const std::vector<ExactPoint>& chain,
                                  std::size_t cusp, bool forward) {
  constexpr std::size_t longest = 100;
  constexpr double farthest = 30;  // px
  std::vector<std::size_t> result{cusp};
  Walk walk(chain.size(), closed, cusp, forward);
  double reached = 0;
  while (result.size() < longest && walk.step()) {
    const double distance = (chain[walk.at()].image - chain[cusp].image).norm();
    if (distance < reached || distance > farthest) break;
    reached = distance;
    result.push_back(walk.at());
    if (chain[walk.at()].is_cusp()) break;
  }
  return result;
}

bool cross_each_other(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const auto turns_left = [](const Vec2& p, const Vec2& q, const Vec2& r) {
    return cross(q - p, r - p) > 0;
  };
  return turns_left(a, b, c) != turns_left(a, b, d) && turns_left(c, d, a) != turns_left(c, d, b);
}

// The two strands of one cusp.
class Horn {
 public:
  Horn(bool closed, const std::vector<ExactPoint>& chain, std::size_t cusp)
      : chain_(chain),
        strands_{receding(closed, chain, cusp, false), receding(closed, chain, cusp, true)} {}

  void find(std::vector<CrossedSegment>& crossed) const {
    const auto& [a, b] = strands_;
    std::size_t from = 0;
    for (std::size_t i = 0; i + 1 < a.size(); ++i) {
      while (from + 1 < b.size() && distance(b[from + 1]) < distance(a[i])) ++from;
      for (std::size_t j = from; j + 1 < b.size() && distance(b[j]) <= distance(a[i + 1]); ++j) {
        const bool share_end = (i == 0 && j == 0) || a[i + 1] == b[j + 1];
        if (share_end ||
            !cross_each_other(image(a[i]), image(a[i + 1]), image(b[j]), image(b[j + 1]))) {
          continue;
        }
        add(a, i, crossed);
        add(b, j, crossed);
      }
    }
  }

 private:
  const Vec2& image(std::size_t i) const { return chain_[i].image; }
  double distance(std::size_t i) const { return (image(i) - image(strands_[0][0])).norm(); }

  // The crossed segment and its neighbours.
  void add(const std::vector<std::size_t>& strand, std::size_t at,
           std::vector<CrossedSegment>& crossed) const {
    const std::size_t first = at == 0 ? 0 : at - 1, last = std::min(at + 2, strand.size() - 1);
    for (std::size_t i = first; i < last; ++i) {
      const double length = (image(strand[i + 1]) - image(strand[i])).norm();
      // The segment between two points is that of the one that comes first in the chain.
      const bool forward = strand == strands_[1];
      crossed.push_back({chain_[forward ? strand[i] : strand[i + 1]].segment, length});
    }
  }

  const std::vector<ExactPoint>& chain_;
  std::array<std::vector<std::size_t>, 2> strands_;
};

// The next cusp along the chain, none where there is no other.
std::optional<std::size_t> next_cusp(const std::vector<ExactPoint>& chain, bool closed,
                                     std::size_t from) {
  Walk walk(chain.size(), closed, from, true);
  while (walk.step()) {
    if (chain[walk.at()].is_cusp()) return walk.at();
  }
  return {};
}

// Whether everything from cusp a to cusp b stays near a.
bool stays_near(const std::vector<ExactPoint>& chain, std::size_t a, std::size_t b, double reach) {
  for (std::size_t i = a; i != b; i = (i + 1) % chain.size()) {
    if ((chain[i].image - chain[a].image).norm() > reach) return false;
  }
  return true;
}

// Marks the plain points around point `middle` that lie within reach of it.
void drop_around(const Surface& surface, const std::vector<ExactPoint>& chain, bool closed,
                 std::size_t middle, double reach, std::vector<std::uint8_t>& dropped) {
  for (const bool forward : {false, true}) {
    Walk walk(chain.size(), closed, middle, forward);
    while (walk.step()) {
      const double apart = (chain[walk.at()].image - chain[middle].image).norm();
      if (apart > reach || must_stay(surface, closed, chain, walk.at())) break;
      dropped[walk.at()] = 1;
    }
  }
}

}  // namespace

void thin_at_cusps(const Surface& surface, const Camera& camera, ExactSegment& segment, bool closed,
                   std::vector<ExactPoint>& chain) {
  chain = Thinner(surface, camera, segment, closed, chain).run();
}

std::vector<CrossedSegment> crossed_at_cusps(bool closed, const std::vector<ExactPoint>& chain) {
  std::vector<CrossedSegment> crossed;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    if (chain[i].is_cusp()) Horn(closed, chain, i).find(crossed);
  }
  return crossed;
}

int collapse_swallowtails(const Surface& surface, bool closed, std::vector<ExactPoint>& chain) {
  int collapsed = 0;
  std::vector<std::uint8_t> dropped(chain.size(), 0);
  for (std::size_t i = 0; i < chain.size(); ++i) {
    if (!chain[i].is_cusp()) continue;
    const std::optional<std::size_t> j = next_cusp(chain, closed, i);
    if (!j || chain[*j].point.cusp_jump != chain[i].point.cusp_jump) continue;
    const double apart = (chain[*j].image - chain[i].image).norm();
    if (apart > swallowtail_px || !stays_near(chain, i, *j, 2 * apart)) continue;
    for (const std::size_t cusp : {i, *j}) {
      chain[cusp].point.cusp_jump = 0;
      chain[cusp].knot.reset();
    }
    drop_around(surface, chain, closed, i, std::max(3 * apart, swallowtail_px), dropped);
    dropped[i] = 0;
    ++collapsed;
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    if (!dropped[i]) chain[kept++] = chain[i];
  }
  chain.resize(kept);
  return collapsed;
}

}  // namespace illustrate
