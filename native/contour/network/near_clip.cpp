#include "contour/network/near_clip.h"

#include <algorithm>

#include "surface/locate.h"

namespace illustrate {
namespace {

class NearClipper {
 public:
  NearClipper(const Surface& surface, const CurveNetwork& network, const Camera& camera)
      : surface_(surface), network_(network), camera_(camera) {}

  CurveNetwork run() {
    result_.nodes = network_.nodes;
    ends_.resize(network_.strands.size(), {none, none});
    for (std::size_t s = 0; s < network_.strands.size(); ++s) clip_strand(static_cast<int>(s));
    for (const Tie& tie : network_.ties) keep_tie(tie);
    drop_lonely_nodes();
    return std::move(result_);
  }

 private:
  // Which of a strand's own ends a piece of it has.
  struct Kept {
    bool start = false;
    bool end = false;
  };
  static constexpr Kept whole{true, true};

  bool seen(const CurvePoint& p) const { return camera_.near_distance(p.position) > 0; }

  void clip_strand(int s) {
    const Span<const CurvePoint> points = network_.points[idx(s)];
    const Strand& strand = network_.strands[idx(s)];
    if (std::all_of(points.begin(), points.end(), [&](const CurvePoint& p) { return seen(p); })) {
      for (const CurvePoint& p : points) result_.points.push(p);
      finish(strand, s, whole);
      return;
    }
    cut_strand(s, points, strand);
  }

  // A closed strand starts behind a hidden point, so that no visible run goes round its start.
  void cut_strand(int s, Span<const CurvePoint> points, const Strand& strand) {
    const std::size_t n = points.size();
    std::size_t start = 0;
    if (strand.closed()) {
      while (start < n && seen(points[start])) ++start;
    }
    const std::size_t count = strand.closed() ? n + 1 : n;
    bool open = false;
    Kept kept;
    Strand piece = strand;
    for (std::size_t i = 0; i < count; ++i) {
      const CurvePoint& p = points[(start + i) % n];
      const bool here = seen(p);
      if (here && !open) {
        open = true;
        kept.start = i == 0;
        piece.start_node = strand.start_node;
        if (!kept.start) piece.start_node = push_cut(points[(start + i + n - 1) % n], p);
      }
      if (here) result_.points.push(p);
      if (!here && open) {
        piece.end_node = push_cut(p, points[(start + i + n - 1) % n]);
        finish(piece, s, kept);
        open = false;
      }
    }
    if (!open) return;
    piece.end_node = strand.end_node;
    kept.end = true;
    finish(piece, s, kept);
  }

  // A point on the near plane between a hidden and a seen point, as a new node.
  int push_cut(const CurvePoint& hidden, const CurvePoint& seen_point) {
    const double before = camera_.near_distance(hidden.position);
    const double behind = camera_.near_distance(seen_point.position);
    const double fraction = std::clamp(behind / (behind - before), 0.0, 1.0) * (1 - 1e-9);
    const Vec3 position = seen_point.position + fraction * (hidden.position - seen_point.position);
    const int triangle = seen_point.on.triangle;
    result_.points.push(
        {position, triangle == none ? SurfacePoint{} : locate(surface_, triangle, position)});
    result_.nodes.push_back({NodeKind::end, position});
    return static_cast<int>(result_.nodes.size()) - 1;
  }

  void finish(const Strand& strand, int source, const Kept& kept) {
    const int index = static_cast<int>(result_.strands.size());
    result_.points.close_list();
    result_.strands.push_back(strand);
    if (kept.start) ends_[idx(source)][0] = index;
    if (kept.end) ends_[idx(source)][1] = index;
  }

  void keep_tie(const Tie& tie) {
    const int a = ends_[idx(tie.a)][1], b = ends_[idx(tie.b)][0];
    if (a != none && b != none) result_.ties.push_back({tie.node, a, b, tie.jump});
  }

  // Nodes that no strand reaches any more go; joints and cusps with one strand left become ends.
  void drop_lonely_nodes() {
    std::vector<int> degree(result_.nodes.size(), 0);
    for (const Strand& s : result_.strands) {
      if (s.closed()) continue;
      ++degree[idx(s.start_node)];
      ++degree[idx(s.end_node)];
    }
    std::vector<int> renamed(result_.nodes.size(), none);
    std::vector<NetworkNode> kept;
    for (std::size_t n = 0; n < result_.nodes.size(); ++n) {
      if (degree[n] == 0) continue;
      renamed[n] = static_cast<int>(kept.size());
      kept.push_back(result_.nodes[n]);
      if (degree[n] == 1) kept.back().kind = NodeKind::end;
    }
    for (Strand& s : result_.strands) {
      if (s.closed()) continue;
      s.start_node = renamed[idx(s.start_node)];
      s.end_node = renamed[idx(s.end_node)];
    }
    for (Tie& tie : result_.ties) tie.node = renamed[idx(tie.node)];
    result_.nodes = std::move(kept);
  }

  const Surface& surface_;
  const CurveNetwork& network_;
  const Camera& camera_;
  CurveNetwork result_;
  std::vector<std::array<int, 2>>
      ends_;  // new strands that hold the start and the end of each old one
};

}  // namespace

CurveNetwork clip_near(const Surface& surface, const CurveNetwork& network, const Camera& camera) {
  return NearClipper(surface, network, camera).run();
}

}  // namespace illustrate
