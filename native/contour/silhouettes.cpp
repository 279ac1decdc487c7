#include "contour/silhouettes.h"

#include <utility>

#include "contour/feature_edges.h"
#include "surface/locate.h"

namespace illustrate {
namespace {

bool is_passage(EdgeKind kind) {
  return kind != EdgeKind::crease && kind != EdgeKind::boundary && kind != EdgeKind::seam;
}

// One triangle's segment: in over the edge that turns from front to back, out over the other.
struct Segment {
  int in = none;
  int out = none;
};

class Tracer {
 public:
  Tracer(const Surface& surface, const ContourFunctions& functions, const Camera& camera)
      : surface_(surface), functions_(functions), camera_(camera) {}

  Silhouettes run() {
    collect_segments();
    for (const int t : result_.triangles) {
      if (!visited_[idx(t)] && before(t).triangle == none) trace(t);
    }
    for (const int t : result_.triangles) {
      if (!visited_[idx(t)]) trace(t);
    }
    return std::move(result_);
  }

 private:
  void collect_segments() {
    segments_.resize(surface_.triangles.size());
    visited_.resize(surface_.triangles.size(), 0);
    for (std::size_t t = 0; t < surface_.triangles.size(); ++t) {
      const int triangle = static_cast<int>(t);
      if (!surface_.object_is_smooth[idx(surface_.triangle_objects[t])]) continue;
      ++result_.triangles_visited;
      segments_[t] = segment_of(triangle);
      if (segments_[t].in != none) result_.triangles.push_back(triangle);
    }
  }

  Segment segment_of(int triangle) const {
    Segment segment;
    for (int k = 0; k < 3; ++k) {
      const bool here = functions_.front(triangle, k);
      if (here == functions_.front(triangle, next_corner(k))) continue;
      (here ? segment.in : segment.out) = k;
    }
    return segment;
  }

  EdgeSide across(int triangle, int corner) const {
    if (!is_passage(surface_.edge_kinds[idx(triangle)][idx(corner)])) return {};
    const EdgeSide other = opposite_side(surface_, {triangle, corner});
    if (other.triangle == none || segments_[idx(other.triangle)].in == none) return {};
    return other;
  }
  EdgeSide before(int triangle) const { return across(triangle, segments_[idx(triangle)].in); }
  EdgeSide after(int triangle) const { return across(triangle, segments_[idx(triangle)].out); }

  void trace(int first) {
    int last = first;
    bool closed = false;
    for (int t = first;;) {
      visited_[idx(t)] = 1;
      last = t;
      push_segment(t);
      const EdgeSide next = after(t);
      if (next.triangle == none) break;
      closed = next.triangle == first;
      if (closed || visited_[idx(next.triangle)]) break;
      t = next.triangle;
    }
    if (!closed) push_edge_point(last, segments_[idx(last)].out);
    result_.chains.close_list();
    result_.closed.push_back(closed);
  }

  void push_segment(int triangle) {
    const Segment& segment = segments_[idx(triangle)];
    const ChainPoint start = edge_point(triangle, segment.in);
    const ChainPoint end = edge_point(triangle, segment.out);
    result_.chains.push(start);
    const double c_start = cusp_value(triangle, start), c_end = cusp_value(triangle, end);
    if ((c_start >= 0) == (c_end >= 0)) return;
    result_.chains.push(cusp_point(start, end, c_start / (c_start - c_end)));
    ++result_.cusps;
  }

  void push_edge_point(int triangle, int corner) {
    result_.chains.push(edge_point(triangle, corner));
  }

  ChainPoint edge_point(int triangle, int corner) const {
    const double fraction = functions_.zero_fraction(triangle, corner);
    const Triangle& corners = surface_.triangles[idx(triangle)];
    const Vec3& a = surface_.positions[idx(corners[idx(corner)])];
    const Vec3& b = surface_.positions[idx(corners[idx(next_corner(corner))])];
    // Both triangles of an edge compute the same bits: from its lower vertex to its higher one.
    const bool ascending = corners[idx(corner)] < corners[idx(next_corner(corner))];
    const Vec3 position =
        ascending ? Vec3(a + fraction * (b - a)) : Vec3(b + (1 - fraction) * (a - b));
    return {position, on_edge(triangle, corner, fraction), corner, fraction, 0};
  }

  double cusp_value(int triangle, const ChainPoint& point) const {
    return functions_.cusp_function(triangle, point.edge, point.fraction);
  }

  ChainPoint cusp_point(const ChainPoint& start, const ChainPoint& end, double fraction) const {
    ChainPoint cusp;
    cusp.position = start.position + fraction * (end.position - start.position);
    cusp.on = {start.on.triangle, start.on.b1 + fraction * (end.on.b1 - start.on.b1),
               start.on.b2 + fraction * (end.on.b2 - start.on.b2)};
    const double approach = (end.position - start.position).dot(camera_.to_eye(cusp.position));
    cusp.cusp_jump = approach < 0 ? 1 : -1;
    return cusp;
  }

  const Surface& surface_;
  const ContourFunctions& functions_;
  const Camera& camera_;
  std::vector<Segment> segments_;
  std::vector<std::uint8_t> visited_;
  Silhouettes result_;
};

}  // namespace

Silhouettes silhouettes(const Surface& surface, const ContourFunctions& functions,
                        const Camera& camera) {
  return Tracer(surface, functions, camera).run();
}

}  // namespace illustrate
