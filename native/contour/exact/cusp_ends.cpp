#include "contour/exact/cusp_ends.h"

#include <algorithm>

#include "core/direction.h"
#include "surface/locate.h"

namespace illustrate {
namespace {

constexpr double farthest_px = 1.6 * cusp_reach_px;
constexpr double swallowtail_px = 0.25;

constexpr std::array<Direction, 2> directions{Direction::backward, Direction::forward};

// Steps along a chain in one direction, round a closed one.
class Walk {
 public:
  Walk(std::size_t count, bool closed, std::size_t from, Direction direction)
      : count_(count), closed_(closed), at_(from), forward_(direction == Direction::forward) {}

  // False at the end of an open chain, and after a whole round.
  bool step() {
    if (++steps_ >= count_) return false;
    if (!closed_ && at_ == (forward_ ? count_ - 1 : 0)) return false;
    if (forward_) {
      at_ = at_ + 1 < count_ ? at_ + 1 : 0;
    } else {
      at_ = (at_ > 0 ? at_ : count_) - 1;
    }
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

// A polyline with its image.
class Drawn {
 public:
  Drawn(const Camera& camera, const ExactPolyline& line) : camera_(camera), line_(line) {}

  std::size_t size() const { return line_.points.size(); }
  const ExactPoint& operator[](std::size_t i) const { return line_.points[i]; }
  const ExactKnot* knot(std::size_t i) const {
    const int k = line_.points[i].knot;
    return k == none ? nullptr : &line_.knots[idx(k)];
  }
  Vec2 image(std::size_t i) const { return camera_.project(line_.points[i].position).xy; }
  double distance(std::size_t i, std::size_t j) const { return (image(i) - image(j)).norm(); }
  bool closed() const { return line_.closed; }
  Walk walk(std::size_t from, Direction direction) const {
    return {size(), line_.closed, from, direction};
  }

  // Cusps, ends, and points on edges that may be curves.
  bool must_stay(const Surface& surface, std::size_t i) const {
    const ExactPoint& p = line_.points[i];
    const bool is_end = !line_.closed && (i == 0 || i + 1 == size());
    if (is_end || p.is_cusp()) return true;
    return p.edge != none &&
           surface.edge_kinds[idx(p.on.triangle)][idx(p.edge)] != EdgeKind::smooth;
  }

  std::vector<std::size_t> cusps() const {
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < size(); ++i) {
      if (line_.points[i].is_cusp()) result.push_back(i);
    }
    return result;
  }

 private:
  const Camera& camera_;
  const ExactPolyline& line_;
};

void erase(const std::vector<std::uint8_t>& dropped, ExactPolyline& line) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < dropped.size(); ++i) {
    if (!dropped[i]) line.points[kept++] = line.points[i];
  }
  line.points.resize(kept);
}

class Thinner {
 public:
  Thinner(const Surface& surface, const Camera& camera, ExactSegment& segment, ExactPolyline& line)
      : surface_(surface),
        camera_(camera),
        segment_(segment),
        line_(line),
        drawn_(camera, line),
        dropped_(line.points.size(), 0) {}

  void run(const std::vector<std::size_t>& cusps) {
    for (const std::size_t cusp : cusps) {
      for (const Direction direction : directions) clear(cusp, direction);
    }
    put_together();
  }

 private:
  // A point to put behind point `behind`, at `fraction` of the way to the next one.
  struct Added {
    std::size_t behind;
    double fraction;
    ExactPoint point;
    std::optional<ContourKnot> knot;
  };

  void clear(std::size_t cusp, Direction direction) {
    Walk walk = drawn_.walk(cusp, direction);
    std::vector<std::size_t> dropped;
    std::size_t last = cusp;
    while (walk.step()) {
      const std::size_t at = walk.at();
      const double reached = drawn_.distance(cusp, at);
      if (drawn_.must_stay(surface_, at)) {
        if (reached < farthest_px) break;
      } else if (reached < cusp_reach_px) {
        dropped.push_back(at);
        last = at;
        continue;
      }
      const bool forward = direction == Direction::forward;
      if (reached > farthest_px) add_between(cusp, forward ? last : at, forward ? at : last);
      break;
    }
    for (const std::size_t i : dropped) dropped_[i] = 1;
  }

  // A point of the segment from a to b (neighbours in the chain's order), at the right distance.
  void add_between(std::size_t cusp, std::size_t a, std::size_t b) {
    const bool grows = drawn_.distance(cusp, a) < drawn_.distance(cusp, b);
    const Vec2 centre = drawn_.image(cusp);
    double low = 0, high = 1;  // distances below and above what is wanted, or the other way round
    for (int i = 0; i < 24; ++i) {
      const double f = (low + high) / 2;
      std::optional<Added> added = between(a, b, f);
      if (!added) return;
      const double reached = (camera_.project(added->point.position).xy - centre).norm();
      if (reached >= cusp_reach_px && reached <= farthest_px) {
        added_.push_back(*added);
        return;
      }
      ((reached < cusp_reach_px) == grows ? low : high) = f;
    }
  }

  std::optional<Added> between(std::size_t a, std::size_t b, double f) {
    const int t = drawn_[a].on.triangle;
    Added added{a, f, {}, {}};
    added.point.segment = drawn_[a].segment;
    const ExactKnot *from = drawn_.knot(a), *to = drawn_.knot(b);
    if (from && to && share_segment(drawn_[a], drawn_[b])) {
      const PatchTriangle& patch = surface_.patches[idx(t)];
      added.knot = segment_.between(patch.ptex_face, from->leaving, to->arriving, f);
      if (!added.knot) return {};
      added.point.position = added.knot->sample.position;
      added.point.on = on_triangle(patch, t, added.knot->uv);
      return added;
    }
    added.point.position = drawn_[a].position + f * (drawn_[b].position - drawn_[a].position);
    added.point.on = nearest_on(surface_, t, added.point.position);
    return added;
  }

  // Whether the way from a to b, from which points may be gone, lies within one triangle.
  bool share_segment(const ExactPoint& a, const ExactPoint& b) const {
    const int next = (a.segment + 1) % line_.edges;
    return b.segment == a.segment || (b.segment == next && b.edge != none);
  }

  void put_together() {
    std::stable_sort(added_.begin(), added_.end(), [](const Added& a, const Added& b) {
      return a.behind != b.behind ? a.behind < b.behind : a.fraction < b.fraction;
    });
    std::vector<ExactPoint> points;
    points.reserve(line_.points.size() + added_.size());
    auto next = added_.begin();
    for (std::size_t i = 0; i < line_.points.size(); ++i) {
      if (!dropped_[i]) points.push_back(line_.points[i]);
      for (; next != added_.end() && next->behind == i; ++next) {
        if (next->knot) {
          next->point.knot = static_cast<int>(line_.knots.size());
          line_.knots.push_back({*next->knot, *next->knot});
        }
        points.push_back(next->point);
      }
    }
    line_.points = std::move(points);
  }

  const Surface& surface_;
  const Camera& camera_;
  ExactSegment& segment_;
  ExactPolyline& line_;
  Drawn drawn_;
  std::vector<std::uint8_t> dropped_;
  std::vector<Added> added_;
};

// A point of the strand that leaves a cusp in one direction, as long as it recedes from it.
struct RecedingPoint {
  std::size_t point;
  Vec2 image;
  double distance;  // from the cusp
};

std::vector<RecedingPoint> receding(const Drawn& drawn, std::size_t cusp, Direction direction) {
  constexpr std::size_t longest = 100;
  constexpr double farthest = 30;  // px
  std::vector<RecedingPoint> strand;
  strand.reserve(longest);
  strand.push_back({cusp, drawn.image(cusp), 0});
  Walk walk = drawn.walk(cusp, direction);
  while (strand.size() < longest && walk.step()) {
    const Vec2 image = drawn.image(walk.at());
    const double distance = (image - strand[0].image).norm();
    if (distance < strand.back().distance || distance > farthest) break;
    strand.push_back({walk.at(), image, distance});
    if (drawn[walk.at()].is_cusp()) break;
  }
  return strand;
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
  Horn(const Drawn& drawn, std::size_t cusp)
      : drawn_(drawn),
        backward_(receding(drawn, cusp, Direction::backward)),
        forward_(receding(drawn, cusp, Direction::forward)) {}

  void find(std::vector<CrossedSegment>& crossed) const {
    const std::vector<RecedingPoint>&a = backward_, &b = forward_;
    std::size_t from = 0;
    for (std::size_t i = 0; i + 1 < a.size(); ++i) {
      while (from + 1 < b.size() && b[from + 1].distance < a[i].distance) ++from;
      for (std::size_t j = from; j + 1 < b.size() && b[j].distance <= a[i + 1].distance; ++j) {
        const bool share_end = (i == 0 && j == 0) || a[i + 1].point == b[j + 1].point;
        if (share_end || !cross_each_other(a[i].image, a[i + 1].image, b[j].image, b[j + 1].image))
          continue;
        add(a, i, 1, crossed);
        add(b, j, 0, crossed);
      }
    }
  }

 private:
  // The crossed segment and its neighbours; a segment is named by the one of its two points that
  // comes first in the chain.
  void add(const std::vector<RecedingPoint>& strand, std::size_t at, std::size_t first_in_chain,
           std::vector<CrossedSegment>& crossed) const {
    const std::size_t first = at == 0 ? 0 : at - 1;
    const std::size_t last = std::min(at + 2, strand.size() - 1);
    for (std::size_t i = first; i < last; ++i) {
      const double length = (strand[i + 1].image - strand[i].image).norm();
      crossed.push_back({drawn_[strand[i + first_in_chain].point].segment, length});
    }
  }

  const Drawn& drawn_;
  std::vector<RecedingPoint> backward_, forward_;
};

// Whether everything from cusp a to cusp b stays near a.
bool stays_near(const Drawn& drawn, std::size_t a, std::size_t b, double reach) {
  for (std::size_t i = a; i != b; i = (i + 1) % drawn.size()) {
    if (drawn.distance(i, a) > reach) return false;
  }
  return true;
}

// Marks the plain points around point `middle` that lie within reach of it; whether a cusp does.
bool drop_around(const Surface& surface, const Drawn& drawn, std::size_t middle, double reach,
                 std::vector<std::uint8_t>& dropped) {
  bool meets_cusp = false;
  for (const Direction direction : directions) {
    Walk walk = drawn.walk(middle, direction);
    while (walk.step() && drawn.distance(walk.at(), middle) <= reach) {
      if (drawn.must_stay(surface, walk.at())) {
        meets_cusp |= drawn[walk.at()].is_cusp();
        break;
      }
      dropped[walk.at()] = 1;
    }
  }
  return meets_cusp;
}

// Two cusps of one jump, neighbours along the chain.
struct Swallowtail {
  double apart;  // px
  std::size_t first, second;
};

// Those small enough to be one point, the smallest first.
std::vector<Swallowtail> small_swallowtails(const Drawn& drawn) {
  std::vector<Swallowtail> result;
  const std::vector<std::size_t> cusps = drawn.cusps();
  if (cusps.size() < 2) return result;
  for (std::size_t c = 0; c + (drawn.closed() ? 0 : 1) < cusps.size(); ++c) {
    const std::size_t i = cusps[c], j = cusps[(c + 1) % cusps.size()];
    if (drawn[j].cusp_jump != drawn[i].cusp_jump) continue;
    const double apart = drawn.distance(i, j);
    if (apart > swallowtail_px || !stays_near(drawn, i, j, swallowtail_px)) continue;
    result.push_back({apart, i, j});
  }
  std::sort(result.begin(), result.end(), [](const Swallowtail& a, const Swallowtail& b) {
    return a.apart != b.apart ? a.apart < b.apart : a.first < b.first;
  });
  return result;
}

}  // namespace

void thin_at_cusps(const Surface& surface, const Camera& camera, ExactSegment& segment,
                   ExactPolyline& line) {
  const std::vector<std::size_t> cusps = Drawn(camera, line).cusps();
  if (!cusps.empty()) Thinner(surface, camera, segment, line).run(cusps);
}

std::vector<CrossedSegment> crossed_at_cusps(const Camera& camera, const ExactPolyline& line) {
  const Drawn drawn(camera, line);
  std::vector<CrossedSegment> crossed;
  for (const std::size_t cusp : drawn.cusps()) Horn(drawn, cusp).find(crossed);
  return crossed;
}

// The point stays, unless the strand turns back at another cusp beside it: it would overshoot.
int collapse_swallowtails(const Surface& surface, const Camera& camera, ExactPolyline& line) {
  const Drawn drawn(camera, line);
  int collapsed = 0;
  std::vector<std::uint8_t> dropped;
  for (const Swallowtail& s : small_swallowtails(drawn)) {
    if (!line.points[s.first].is_cusp() || !line.points[s.second].is_cusp()) continue;
    for (const std::size_t cusp : {s.first, s.second}) {
      line.points[cusp].cusp_jump = 0;
      line.points[cusp].knot = none;
    }
    dropped.resize(drawn.size(), 0);
    const double reach = std::max(3 * s.apart, swallowtail_px);
    dropped[s.first] = drop_around(surface, drawn, s.first, reach, dropped);
    ++collapsed;
  }
  if (collapsed > 0) erase(dropped, line);
  return collapsed;
}

}  // namespace illustrate
