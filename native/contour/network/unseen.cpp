#include "contour/network/unseen.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "surface/locate.h"

namespace illustrate {
namespace {

// In pixels of the camera, units of paper in a drawing.
constexpr double cell_px = 1;
constexpr double least_gap_px = 3;  // in front of what is covered
constexpr double beyond_frame_px = 32;
constexpr double most_pieces = 1024;
// What crosses a buried place within a piece, and is not cut off for being short, is covered.
constexpr int covered_cells = 2, buried_cells = 8;

// Curves are looked at piece by piece, and cut where a run of pieces is long enough.
struct Fineness {
  double piece_px, least_cut_px;
};
Fineness fineness(Unseen::Evidence evidence) {
  return evidence == Unseen::Evidence::certain ? Fineness{4, 8} : Fineness{1, 2};
}

class Cutter {
 public:
  Cutter(const Unseen& unseen, const CurveNetwork& network)
      : unseen_(unseen), network_(network), fineness_(fineness(unseen.evidence())) {
    result_.nodes = network.nodes;
  }

  CurveNetwork run() {
    const std::size_t count = network_.strands.size();
    std::vector<int> first(count), last(count);
    for (std::size_t s = 0; s < count; ++s) {
      first[s] = static_cast<int>(result_.strands.size());
      points_ = network_.points[s];
      cut(network_.strands[s]);
      last[s] = static_cast<int>(result_.strands.size()) - 1;
    }
    for (const Tie& tie : network_.ties) keep(tie, last[idx(tie.a)], first[idx(tie.b)]);
    return std::move(result_);
  }

 private:
  // A place of the strand: behind point `segment`, a share of the way to the next. Segments of a
  // closed strand go on to be counted beyond its start.
  struct Place {
    std::size_t segment;
    double share;
  };
  struct Run {
    Place begin, end;
    Sight sight;
    double length_px;
  };

  // What is under cover has no label that others could follow.
  void keep(const Tie& tie, int a, int b) {
    const auto is_possible = [&](int s) {
      return result_.strands[idx(s)].sight == Sight::possible;
    };
    if (is_possible(a) == is_possible(b)) {
      result_.ties.push_back({tie.node, a, b, tie.jump});
    } else {
      result_.nodes[idx(tie.node)].kind = NodeKind::joint;
    }
  }

  const CurvePoint& point(std::size_t i) const { return points_[i % points_.size()]; }

  CurvePoint point_at(const Place& place) const {
    const CurvePoint& a = point(place.segment);
    if (place.share == 0) return a;
    if (place.share == 1) return point(place.segment + 1);
    const Vec3 p = a.position + place.share * (point(place.segment + 1).position - a.position);
    return {p, locate(unseen_.surface(), a.on.triangle, p)};
  }

  void cut(const Strand& strand) {
    const std::size_t segments = points_.size() - (strand.closed() ? 0 : 1);
    std::vector<Run> runs =
        without_short(Sight::covered, Sight::possible,
                      without_short(Sight::buried, Sight::covered, runs_of(segments)));
    if (runs.size() == 1) return push_whole(strand, runs.front().sight);
    // The start of a closed strand is no cut.
    if (strand.closed() && runs.front().sight == runs.back().sight) {
      runs.back().end = runs.front().end;
      runs.back().end.segment += segments;
      runs.erase(runs.begin());
    }
    const int first = strand.closed() ? add_node(runs.front().begin) : strand.start_node;
    const int last = strand.closed() ? first : strand.end_node;
    int node = first;
    for (std::size_t r = 0; r < runs.size(); ++r) {
      const int end = r + 1 == runs.size() ? last : add_node(runs[r].end);
      push_points(runs[r]);
      push(strand, node, end, runs[r].sight);
      node = end;
    }
  }

  std::vector<Run> runs_of(std::size_t segments) const {
    std::vector<Run> runs;
    for (std::size_t i = 0; i < segments; ++i) {
      const Vec3 &a = point(i).position, &b = point(i + 1).position;
      const double length =
          (unseen_.camera().project(b).xy - unseen_.camera().project(a).xy).norm();
      const double pieces = std::clamp(std::ceil(length / fineness_.piece_px), 1.0, most_pieces);
      for (double k = 0; k < pieces; ++k) {
        const double from = k / pieces, to = (k + 1) / pieces;
        const Sight sight = unseen_.segment(a + from * (b - a), a + to * (b - a));
        append(runs, {{i, from}, {i, to}, sight, length / pieces});
      }
    }
    return runs;
  }

  static void append(std::vector<Run>& runs, const Run& run) {
    if (runs.empty() || runs.back().sight != run.sight) return runs.push_back(run);
    runs.back().end = run.end;
    runs.back().length_px += run.length_px;
  }

  // Short runs of one kind become another, but a whole strand.
  std::vector<Run> without_short(Sight kind, Sight other, const std::vector<Run>& runs) const {
    if (runs.size() == 1) return runs;
    std::vector<Run> result;
    for (Run run : runs) {
      if (run.sight == kind && run.length_px < fineness_.least_cut_px) run.sight = other;
      append(result, run);
    }
    return result;
  }

  int add_node(const Place& at) {
    result_.nodes.push_back({NodeKind::joint, point_at(at).position});
    return static_cast<int>(result_.nodes.size()) - 1;
  }

  void push_points(const Run& run) {
    result_.points.push(point_at(run.begin));
    for (std::size_t i = run.begin.segment + 1; i <= run.end.segment; ++i) {
      result_.points.push(point(i));
    }
    result_.points.push(point_at(run.end));
  }

  void push_whole(const Strand& strand, Sight sight) {
    for (const CurvePoint& p : points_) result_.points.push(p);
    push(strand, strand.start_node, strand.end_node, sight);
  }

  void push(Strand strand, int start, int end, Sight sight) {
    strand.start_node = start;
    strand.end_node = end;
    strand.sight = sight;
    result_.points.close_list();
    result_.strands.push_back(strand);
  }

  const Unseen& unseen_;
  const CurveNetwork& network_;
  Fineness fineness_;
  Span<const CurvePoint> points_;  // of the strand that is being cut
  CurveNetwork result_;
};

// Segments of one chain whose triangles are covered (or buried), or beyond the frame, all along.
class Marker {
 public:
  explicit Marker(const Unseen& unseen)
      : unseen_(unseen), least_px_(fineness(unseen.evidence()).least_cut_px) {}

  void mark(Span<EdgePoint> chain) {
    std::size_t begin = 0;
    Hidden hidden = Hidden::no;
    for (std::size_t i = 0; i < chain.size(); ++i) {
      const Hidden here = hidden_by(unseen_.triangle(chain[i].on.triangle));
      if (here == hidden) continue;
      mark_run(chain, begin, i, hidden);
      begin = i;
      hidden = here;
    }
    mark_run(chain, begin, chain.size(), hidden);
  }

 private:
  enum class Hidden : std::uint8_t { no, by_surfaces, by_frame };

  static Hidden hidden_by(Sight sight) {
    if (sight == Sight::possible) return Hidden::no;
    return sight == Sight::beyond_frame ? Hidden::by_frame : Hidden::by_surfaces;
  }

  void mark_run(Span<EdgePoint> chain, std::size_t begin, std::size_t end, Hidden hidden) const {
    if (hidden == Hidden::no) return;
    const bool is_whole = begin == 0 && end == chain.size();
    const bool may_be_short = is_whole || hidden == Hidden::by_frame;
    if (!may_be_short && length_px(chain, begin, end) < least_px_) return;
    for (std::size_t i = begin; i < end; ++i) chain[i].is_unseen = true;
  }

  double length_px(Span<EdgePoint> chain, std::size_t begin, std::size_t end) const {
    double length = 0;
    for (std::size_t i = begin + 1; i < std::min(end + 1, chain.size()); ++i) {
      length += (image(chain[i]) - image(chain[i - 1])).norm();
    }
    return length;
  }

  Vec2 image(const EdgePoint& p) const { return unseen_.camera().project(p.position).xy; }

  const Unseen& unseen_;
  double least_px_;
};

OcclusionMap map_of(const Surface& surface, const Camera& camera, Unseen::Evidence evidence,
                    int threads) {
  const VisibleImage image = render_visible(surface, camera, cell_px, {}, threads);
  if (evidence == Unseen::Evidence::likely) return {surface, image, camera};
  return {surface, image, covered_cells};
}

}  // namespace

Unseen::Unseen(const Surface& surface, const Camera& camera, Evidence evidence, int threads)
    : surface_(surface),
      camera_(camera),
      evidence_(evidence),
      covered_(map_of(surface, camera, evidence, threads)),
      buried_(evidence == Evidence::certain ? covered_.with_more_reach(buried_cells - covered_cells)
                                            : covered_) {}

Sight Unseen::box(Span<const Vec3> points) const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Vec2 low(infinity, infinity), high = -low;
  double depth = infinity;
  for (const Vec3& p : points) {
    if (!(camera_.near_distance(p) > 0)) return Sight::possible;
    const ImagePoint image = camera_.project(p);
    low = low.cwiseMin(image.xy);
    high = high.cwiseMax(image.xy);
    depth = std::min(depth, image.depth - least_gap_px * camera_.pixel_size(p));
  }
  const Vec2 frame(camera_.width_px(), camera_.height_px());
  const bool is_beyond =
      high.minCoeff() < -beyond_frame_px || (low - frame).maxCoeff() > beyond_frame_px;
  if (is_beyond) return Sight::beyond_frame;
  if (!covered_.hides(low, high, depth)) return Sight::possible;
  return buried_.hides(low, high, depth) ? Sight::buried : Sight::covered;
}

Sight Unseen::triangle(int triangle) const {
  const Triangle& v = surface_.triangles[idx(triangle)];
  std::array<Vec3, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) corners[k] = surface_.positions[idx(v[k])];
  return box({corners.data(), corners.size()});
}

Sight Unseen::segment(const Vec3& a, const Vec3& b) const {
  const std::array<Vec3, 2> ends{a, b};
  return box({ends.data(), ends.size()});
}

int leave_out_unseen_chains(const Unseen& unseen, LinearSilhouettes& silhouettes) {
  silhouettes.left_out.assign(silhouettes.chains.size(), 0);
  for (std::size_t c = 0; c < silhouettes.chains.size(); ++c) {
    const Span<EdgePoint> chain = silhouettes.chains[c];
    silhouettes.left_out[c] = std::all_of(chain.begin(), chain.end(), [&](const EdgePoint& p) {
      return !takes_part_in_crossings(unseen.triangle(p.on.triangle));
    });
  }
  return static_cast<int>(
      std::count(silhouettes.left_out.begin(), silhouettes.left_out.end(), std::uint8_t{1}));
}

void mark_unseen_segments(const Unseen& unseen, LinearSilhouettes& silhouettes) {
  Marker marker(unseen);
  for (std::size_t c = 0; c < silhouettes.chains.size(); ++c) marker.mark(silhouettes.chains[c]);
}

CurveNetwork cut_at_unseen(const Unseen& unseen, const CurveNetwork& network) {
  return Cutter(unseen, network).run();
}

}  // namespace illustrate
