#include "contour/network/joints.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <unordered_map>

#include "contour/contour_functions.h"
#include "contour/intersection/flush.h"
#include "contour/intersection/meetings.h"
#include "core/intervals.h"
#include "surface/locate.h"

namespace illustrate {
namespace {

std::int64_t side_key(int triangle, int corner) { return std::int64_t{triangle} * 3 + corner; }

std::array<double, 3> weights(const SurfacePoint& on) { return {1 - on.b1 - on.b2, on.b1, on.b2}; }

class JointFinder {
 public:
  JointFinder(const Surface& surface, const std::vector<FeatureEdge>& features,
              const Silhouettes& silhouettes, const IntersectionCurves& intersections,
              const FreeLines& free_lines, const Camera& camera)
      : surface_(surface),
        features_(features),
        silhouettes_(silhouettes),
        intersections_(intersections),
        lines_(free_lines.lines),
        camera_(camera) {}

  Joints run() {
    index_features();
    cut_flush();
    for (std::size_t c = 0; c < silhouettes_.chains.size(); ++c) cut_chain(static_cast<int>(c));
    if (!intersections_.curves.empty() || !lines_.curves.empty()) {
      chain_pieces_ = pieces_of_chains(surface_, silhouettes_, triangles_of_others());
    }
    for (std::size_t c = 0; c < intersections_.curves.size(); ++c) {
      cut_intersection(static_cast<int>(c));
    }
    cut_where_chains_pass();
    cut_at_triple_points();
    joints_.first_line_node = static_cast<int>(joints_.nodes.size());
    if (!lines_.curves.empty()) index_intersections();
    for (std::size_t c = 0; c < lines_.curves.size(); ++c) cut_line(static_cast<int>(c));
    sort_cuts();
    return std::move(joints_);
  }

 private:
  // Of intersection curves and free lines.
  std::vector<int> triangles_of_others() const {
    std::vector<int> result = triangles_of_lines();
    for (const std::array<int, 2>& sheets : intersections_.segment_triangles) {
      result.insert(result.end(), sheets.begin(), sheets.end());
    }
    return result;
  }

  std::vector<int> triangles_of_lines() const {
    std::vector<int> result;
    for (const ZeroPoint& p : lines_.curves.values) result.push_back(p.on.triangle);
    return result;
  }

  void index_features() {
    for (std::size_t f = 0; f < features_.size(); ++f) {
      for (const EdgeSide& side : features_[f].sides) {
        if (side.triangle == none) continue;
        feature_of_side_[side_key(side.triangle, side.corner)] = static_cast<int>(f);
      }
    }
  }

  void index_intersections() {
    intersection_pieces_ = PiecesByTriangle(triangles_of_lines());
    for (std::size_t c = 0; c < intersections_.curves.size(); ++c) {
      for (std::size_t i = 0; i < intersections_.curves[c].size(); ++i) {
        const int curve = static_cast<int>(c), segment = static_cast<int>(i);
        for (const int triangle : intersections_.segment_triangles[global_point(curve, segment)]) {
          if (triangle == none || !intersection_pieces_.holds(triangle)) continue;
          const Span<const IntersectionPoint> points = intersections_.curves[c];
          const Vec2 start = barycentrics(surface_, triangle, points[i].position);
          const Vec2 end =
              barycentrics(surface_, triangle, points[(i + 1) % points.size()].position);
          intersection_pieces_.add(triangle, {curve, segment, start, end, 0, 1});
        }
      }
    }
  }

  int add_node(NodeKind kind, const Vec3& position) {
    joints_.nodes.push_back({kind, position});
    return static_cast<int>(joints_.nodes.size()) - 1;
  }

  // Runs along the feature's first side.
  double along_feature(int feature, int triangle, int corner, double fraction) const {
    const EdgeSide& first = features_[idx(feature)].sides[0];
    if (first.triangle == triangle && first.corner == corner) return fraction;
    const auto place = [&](int t, int k) {
      return surface_.places[idx(surface_.triangles[idx(t)][idx(k)])];
    };
    const bool parallel = place(first.triangle, first.corner) == place(triangle, corner);
    return parallel ? fraction : 1 - fraction;
  }

  // The node where a point of a curve lies on a feature edge, none where the edge is no feature.
  // The curve comes from this side of the edge; that of a free line tells nothing.
  int cut_feature(const EdgeSide& side, double fraction, const Vec3& position) {
    return cut_feature(side, fraction, position, side);
  }
  int cut_feature(const EdgeSide& at, double fraction, const Vec3& position, const EdgeSide& told) {
    const auto [triangle, corner] = at;
    if (surface_.edge_kinds[idx(triangle)][idx(corner)] == EdgeKind::smooth) return none;
    const auto found = feature_of_side_.find(side_key(triangle, corner));
    if (found == feature_of_side_.end()) return none;
    const int node = add_node(NodeKind::joint, position);
    joints_.edges.push_back(
        {found->second, along_feature(found->second, triangle, corner, fraction), node, told});
    return node;
  }

  void cut_flush() {
    for (auto& [feature, parts] : flush_in_sight()) {
      const auto [start, end] = ends_of(feature);
      const double length = (end - start).norm();
      for (const Interval& part :
           joined(std::move(parts), flush_gap(intersections_.reach) / length)) {
        joints_.flush.push_back({feature, part.from, part.to});
        for (const double share : {part.from, part.to}) {
          if (share > 0 && share < 1) cut_feature_at(feature, share);
        }
      }
    }
  }

  // By feature: of both its sides where the faces are seen from their fronts.
  std::map<int, Intervals> flush_in_sight() const {
    std::map<int, Intervals> result;
    for (const FlushEdge& edge : intersections_.flush_edges) {
      if (!is_front_face(surface_, camera_, edge.plane)) continue;
      const auto [triangle, corner] = edge.side;
      const int feature = feature_of_side_.at(side_key(triangle, corner));
      const auto [from, to] = std::minmax({along_feature(feature, triangle, corner, edge.from),
                                           along_feature(feature, triangle, corner, edge.to)});
      result[feature].push_back({from, to});
    }
    return result;
  }

  // Of a feature's first side.
  std::array<Vec3, 2> ends_of(int feature) const {
    const EdgeSide& first = features_[idx(feature)].sides[0];
    const Triangle& corners = surface_.triangles[idx(first.triangle)];
    return {surface_.positions[idx(corners[idx(first.corner)])],
            surface_.positions[idx(corners[idx(next_corner(first.corner))])]};
  }

  void cut_feature_at(int feature, double fraction) {
    const auto [start, end] = ends_of(feature);
    const int node = add_node(NodeKind::joint, start + fraction * (end - start));
    joints_.edges.push_back({feature, fraction, node, EdgeSide{}});
  }

  // Whether a curve begins or ends to be flush at a point; open ones do not at their ends.
  bool flush_changes(int c, int i) const {
    const int count = static_cast<int>(intersections_.curves[idx(c)].size());
    const auto is_flush = [&](int k) {
      return intersections_.flush_segments[global_point(c, (k + count) % count)] != 0;
    };
    return (i > 0 || intersections_.closed[idx(c)]) && is_flush(i - 1) != is_flush(i);
  }

  void cut_chain(int c) {
    const Span<const ChainPoint> chain = silhouettes_.chains[idx(c)];
    const bool closed = silhouettes_.closed[idx(c)];
    for (std::size_t i = 0; i < chain.size(); ++i) {
      const ChainPoint& p = chain[i];
      const bool tip = !closed && (i == 0 || i + 1 == chain.size());
      int node = none;
      if (p.cusp_jump != 0)
        node = add_node(NodeKind::cusp, p.position);
      else if (p.edge != none)
        node = cut_feature({p.on.triangle, p.edge}, p.fraction, p.position);
      if (node == none && tip) node = add_node(NodeKind::end, p.position);
      if (node != none) joints_.chains.push_back({c, static_cast<int>(i), 0, node, p.cusp_jump});
    }
  }

  void cut_intersection(int c) {
    const Span<const IntersectionPoint> curve = intersections_.curves[idx(c)];
    const bool closed = intersections_.closed[idx(c)];
    for (std::size_t i = 0; i < curve.size(); ++i) {
      const bool tip = !closed && (i == 0 || i + 1 == curve.size());
      int node = cut_at_edge(curve[i].a, curve[i]);
      if (node == none) node = cut_at_edge(curve[i].b, curve[i]);
      if (node != none) cut_touched_edges(curve[i], node);
      if (node == none && tip) node = add_node(NodeKind::end, curve[i].position);
      if (node != none) {
        joints_.intersections.push_back({c, static_cast<int>(i), 0, node, {}});
      } else if (flush_changes(c, static_cast<int>(i))) {
        node = add_node(NodeKind::joint, curve[i].position);
        joints_.intersections.push_back({c, static_cast<int>(i), 0, node, 0});
      }
    }
  }

  // At the edge that pierces. Other edges may pass through the same place, but the curve does not
  // come to them.
  int cut_at_edge(const SurfacePoint& on, const IntersectionPoint& point) {
    const int k = piercing_corner(on, point);
    if (k == none) return none;
    return cut_feature({on.triangle, k}, weights(on)[idx(next_corner(k))], point.position);
  }

  // Of the half-edge of the triangle that pierces the other one at a point; none: the other does.
  int piercing_corner(const SurfacePoint& on, const IntersectionPoint& point) const {
    if (on.triangle == none) return none;
    const auto place = [&](int corner) {
      return surface_.places[idx(surface_.triangles[idx(on.triangle)][idx(corner)])];
    };
    for (int k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax({place(k), place(next_corner(k))});
      if (Edge{low, high} == point.edge) return k;
    }
    return none;
  }

  // The pierced triangle's own edge, where that is in one plane with the edge that pierces and
  // passes within reach of the point: from there the curve runs beside it. In the image both edges
  // and the curve meet in one point, whichever way rounding orders them.
  void cut_touched_edges(const IntersectionPoint& point, int node) {
    for (const SurfacePoint& on : {point.a, point.b}) {
      if (on.triangle == none || piercing_corner(on, point) != none) continue;
      for (int k = 0; k < 3; ++k) {
        const auto found = feature_of_side_.find(side_key(on.triangle, k));
        const double fraction = weights(on)[idx(next_corner(k))];
        if (found == feature_of_side_.end() || !passes(on, k)) continue;
        joints_.edges.push_back(
            {found->second, along_feature(found->second, on.triangle, k, fraction), node, {}});
      }
    }
  }

  // Whether a point is within reach of a half-edge and of neither of its ends.
  bool passes(const SurfacePoint& on, int k) const {
    const auto corner = [&](int i) -> const Vec3& {
      return surface_.positions[idx(surface_.triangles[idx(on.triangle)][idx(i)])];
    };
    const std::array<double, 3> shares = weights(on);
    const Vec3 along = corner(next_corner(k)) - corner(k);
    const double length = along.norm(), reach = intersections_.reach;
    const double height = along.cross(corner(previous_corner(k)) - corner(k)).norm() / length;
    return shares[idx(previous_corner(k))] * height <= reach && shares[idx(k)] * length > reach &&
           shares[idx(next_corner(k))] * length > reach;
  }

  void cut_where_chains_pass() {
    for (const Meeting& m :
         find_meetings(surface_, silhouettes_, chain_pieces_, intersections_, camera_)) {
      const int node = add_node(NodeKind::joint, m.position);
      joints_.intersections.push_back(
          {m.curve, m.curve_segment, m.curve_fraction, node, m.curve_change});
      joints_.chains.push_back({m.chain, m.chain_segment, m.chain_fraction, node, m.chain_change});
    }
  }

  void cut_line(int c) {
    const Span<const ZeroPoint> line = lines_.curves[idx(c)];
    const bool closed = lines_.closed[idx(c)];
    for (std::size_t i = 0; i < line.size(); ++i) {
      const ZeroPoint& p = line[i];
      const bool tip = !closed && (i == 0 || i + 1 == line.size());
      int node = none;
      if (p.edge != none) {
        node = cut_feature({p.on.triangle, p.edge}, p.fraction, p.position, EdgeSide{});
      }
      if (node == none && tip) node = add_node(NodeKind::end, p.position);
      if (node != none) joints_.lines.push_back({c, static_cast<int>(i), 0, node, {}});
      if (i + 1 < line.size() || closed) cut_line_segment(c, static_cast<int>(i));
    }
  }

  void cut_line_segment(int c, int i) {
    const Span<const ZeroPoint> line = lines_.curves[idx(c)];
    const int triangle = line[idx(i)].on.triangle;
    const Vec2 start = barycentrics(surface_, triangle, line[idx(i)].position);
    const Vec2 end = barycentrics(surface_, triangle, line[(idx(i) + 1) % line.size()].position);
    const auto cut = [&](const PiecesByTriangle& pieces, const auto& curves,
                         std::vector<CurveCut>& cuts) {
      for (const CurvePiece& s : pieces[triangle]) {
        double f, h;
        if (!segments_cross(start, end, s.start, s.end, f, h)) continue;
        h = s.from + h * (s.to - s.from);
        const auto curve = curves[idx(s.curve)];
        const Vec3& a = curve[idx(s.segment)].position;
        const Vec3& b = curve[(idx(s.segment) + 1) % curve.size()].position;
        const int node = add_node(NodeKind::joint, a + h * (b - a));
        joints_.lines.push_back({c, i, f, node, {}});
        cuts.push_back({s.curve, s.segment, h, node, 0});
      }
    };
    cut(chain_pieces_, silhouettes_.chains, joints_.chains);
    cut(intersection_pieces_, intersections_.curves, joints_.intersections);
  }

  std::size_t global_point(int c, int i) const {
    return idx(intersections_.curves.offsets[idx(c)] + i);
  }

  void cut_at_triple_points() {
    for (const TriplePoint& point : intersections_.triple_points) {
      const int node = add_node(NodeKind::joint, point.position);
      for (const Passage& p : point.passages) {
        joints_.intersections.push_back(
            {p.curve, p.segment, p.fraction, node, change_through(p.through, p.along_normal)});
      }
    }
  }

  // Of what passes through a triangle: +1 from its near side to its far side.
  int change_through(int triangle, bool along_normal) const {
    const Vec3 normal = winding_normal(surface_, triangle);
    const Vec3& corner = surface_.positions[idx(surface_.triangles[idx(triangle)][0])];
    return (normal.dot(camera_.to_eye(corner)) >= 0) == along_normal ? -1 : 1;
  }

  void sort_cuts() {
    const auto order = [](const CurveCut& a, const CurveCut& b) {
      return std::tie(a.curve, a.segment, a.fraction, a.node) <
             std::tie(b.curve, b.segment, b.fraction, b.node);
    };
    std::sort(joints_.chains.begin(), joints_.chains.end(), order);
    std::sort(joints_.intersections.begin(), joints_.intersections.end(), order);
    std::sort(joints_.lines.begin(), joints_.lines.end(), order);
    sort_edge_cuts();
  }

  // Contours of both sides may come to an edge at one place; that of the earlier node is first, and
  // there is a piece of the edge between them.
  void sort_edge_cuts() {
    constexpr double one_place = 0x1p-32, apart = 0x1p-40;
    std::vector<EdgeCut>& cuts = joints_.edges;
    const auto order = [](const EdgeCut& a, const EdgeCut& b) {
      const double of_a = std::round(a.fraction / one_place);
      const double of_b = std::round(b.fraction / one_place);
      return std::tie(a.feature, of_a, a.node) < std::tie(b.feature, of_b, b.node);
    };
    std::sort(cuts.begin(), cuts.end(), order);
    for (std::size_t i = 1; i < cuts.size(); ++i) {
      if (cuts[i].feature != cuts[i - 1].feature) continue;
      const double least = std::min(1., cuts[i - 1].fraction + apart);
      cuts[i].fraction = std::max(cuts[i].fraction, least);
    }
  }

  const Surface& surface_;
  const std::vector<FeatureEdge>& features_;
  const Silhouettes& silhouettes_;
  const IntersectionCurves& intersections_;
  const ZeroCurves& lines_;
  const Camera& camera_;
  std::unordered_map<std::int64_t, int> feature_of_side_;
  PiecesByTriangle chain_pieces_;
  PiecesByTriangle intersection_pieces_;
  Joints joints_;
};

}  // namespace

Joints find_joints(const Surface& surface, const std::vector<FeatureEdge>& features,
                   const Silhouettes& silhouettes, const IntersectionCurves& intersections,
                   const FreeLines& free_lines, const Camera& camera) {
  return JointFinder(surface, features, silhouettes, intersections, free_lines, camera).run();
}

}  // namespace illustrate
