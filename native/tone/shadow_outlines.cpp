#include "tone/shadow_outlines.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "contour/contour_functions.h"
#include "contour/shape/plane_section.h"
#include "surface/locate.h"
#include "tone/light_views.h"
#include "visibility/label_network.h"

namespace illustrate {
namespace {

// How far beside an outline the ray to what is behind it passes, and how near hits may be the
// outline's own surface, px of the light's view.
constexpr double aside_px = 0.2, blind_px = 3;

// A shadow that lies on the edge that casts it, within this share of the scene's diagonal, is none:
// the foot of a box on the floor.
constexpr double touching = 1e-6;

// Outlines are moved by this share of the scene's diagonal, far less than can be seen: artists put
// boxes and lamps where shadows run along edges and through vertices, and a way along an edge is in
// neither of its triangles.
const Vec3 off_the_edges = 1e-7 * Vec3(0.58, 0.21, 0.79);

// An outline of one thing before another, as the light sees it. Segment i runs from point i to the
// next; `outside` is the side on which there is less: 1 right, -1 left, seen along it.
struct Outline {
  std::vector<Vec3> points;
  std::vector<int> outside;  // (segments)
  bool closed = false;       // the last point is then the first again
};

// Outlines of a labelled view, chained where just two of them meet.
class OutlineChains {
 public:
  OutlineChains(const LabelledGraph& graph, const Vec3& shift)
      : graph_(graph),
        shift_(shift),
        mates_(2 * graph.arcs.size(), none),
        used_(graph.arcs.size(), 0) {}

  std::vector<Outline> run() {
    meet();
    for (int end = 0; end < static_cast<int>(mates_.size()); ++end) {
      if (mates_[idx(end)] == none) follow(end);
    }
    for (int a = 0; a < static_cast<int>(used_.size()); ++a) follow(2 * a);
    return std::move(result_);
  }

 private:
  // Ends are numbered 2 arc + (0: start, 1: end).
  bool is_outline(int arc) const {
    const GraphArc& a = graph_.arcs[idx(arc)];
    return layers_over(a) == 0 && a.left_layers != a.right_layers && a.kind != Kind::seam;
  }

  void meet() {
    std::vector<std::vector<int>> ends(graph_.nodes.size());
    for (int a = 0; a < static_cast<int>(used_.size()); ++a) {
      const GraphArc& arc = graph_.arcs[idx(a)];
      if (!is_outline(a) || arc.start_node == none) continue;
      ends[idx(arc.start_node)].push_back(2 * a);
      ends[idx(arc.end_node)].push_back(2 * a + 1);
    }
    for (std::size_t n = 0; n < ends.size(); ++n) {
      const GraphNode& node = graph_.nodes[n];
      if (node.kind == NodeKind::crossing) {
        join_through(node.arcs[0], node.arcs[1]);
        join_through(node.arcs[2], node.arcs[3]);
      } else if (ends[n].size() == 2) {
        join(ends[n][0], ends[n][1]);
      }
    }
  }

  void join_through(int in, int out) {
    if (is_outline(in) && is_outline(out)) join(2 * in + 1, 2 * out);
  }

  void join(int a, int b) {
    mates_[idx(a)] = b;
    mates_[idx(b)] = a;
  }

  void follow(int first) {
    if (used_[idx(first / 2)] || !is_outline(first / 2)) return;
    Outline chain;
    for (int end = first; !used_[idx(end / 2)];) {
      used_[idx(end / 2)] = 1;
      add_arc(end, chain);
      const int next = mates_[idx(end ^ 1)];
      chain.closed = next == first || graph_.arcs[idx(end / 2)].start_node == none;
      if (next == none) break;
      end = next;
    }
    if (chain.points.size() > 1) result_.push_back(std::move(chain));
  }

  // From one end of an arc to the other.
  void add_arc(int end, Outline& chain) const {
    const GraphArc& arc = graph_.arcs[idx(end / 2)];
    std::vector<Vec3> points;
    for (const CurvePoint& p : graph_.points[idx(end / 2)]) points.push_back(p.position + shift_);
    if (arc.start_node == none) points.push_back(points.front());
    const bool forward = end % 2 == 0;
    if (!forward) std::reverse(points.begin(), points.end());
    const int outside = (arc.right_layers < arc.left_layers) == forward ? 1 : -1;
    const bool goes_on = !chain.points.empty();
    chain.points.insert(chain.points.end(), points.begin() + (goes_on ? 1 : 0), points.end());
    chain.outside.resize(chain.points.size() - 1, outside);
  }

  const LabelledGraph& graph_;
  const Vec3 shift_;
  std::vector<int> mates_;
  std::vector<std::uint8_t> used_;
  std::vector<Outline> result_;
};

// The shadow of one outline.
class OutlineShadow {
 public:
  OutlineShadow(const Surface& surface, const LightCasters& casters, const Light& light,
                const Camera& view, const Camera& viewer, const Outline& outline, FreeLines& result)
      : surface_(surface),
        casters_(casters),
        light_(light),
        view_(view),
        viewer_(viewer),
        outline_(outline),
        result_(result) {}

  void add() { cover(0, static_cast<int>(outline_.outside.size())); }

 private:
  const Vec3& point(int i) const { return outline_.points[idx(i)]; }

  // Of the segments first .. last - 1.
  void cover(int first, int last) {
    if (first >= last) return;
    const int middle = (first + last) / 2;
    const std::optional<ZeroPoint> start = behind(middle);
    if (!start) {
      cover(first, middle);
      cover(middle + 1, last);
      return;
    }
    const Vec3 from = (point(middle) + point(middle + 1)) / 2;
    std::vector<ZeroSegment> ahead, back;
    int end = middle, begin = middle + 1;
    ZeroPoint at = *start;
    while (end < last && step(end == middle ? from : point(end), point(end + 1), at, ahead)) ++end;
    at = *start;
    while (begin > first &&
           step(begin == middle + 1 ? from : point(begin), point(begin - 1), at, back))
      --begin;
    add_line(back, ahead, end - begin == static_cast<int>(outline_.outside.size()));
    cover(first, std::min(begin - 1, middle));
    cover(std::max(end, middle) + 1, last);
  }

  // One segment's plane through the light, followed to its end.
  bool step(const Vec3& from, const Vec3& to, ZeroPoint& at, std::vector<ZeroSegment>& way) const {
    const Vec3 normal = view_.to_eye(from).cross(to - from);
    if (normal.isZero(0)) return true;  // along a ray of the light, which stays where it is
    SectionPlane goal{to, normal.cross(view_.to_eye(to))};
    if (goal.side(from) > 0) goal.normal = -goal.normal;
    const std::size_t before = way.size();
    const bool starts_there = touches(from, at);
    if (!follow_section(surface_, {from, normal}, goal, at, way)) return false;
    if (!starts_there || !touches(to, at)) return true;
    way.resize(before);
    return false;
  }

  bool touches(const Vec3& outline, const ZeroPoint& shadow) const {
    return (outline - shadow.position).norm() < touching * surface_.diagonal;
  }

  // What the light reaches beside the middle of a segment, moved back to where its own ray goes.
  std::optional<ZeroPoint> behind(int segment) const {
    const Vec3 middle = (point(segment) + point(segment + 1)) / 2;
    if (!is_in_view(middle) || !shines_at(light_, middle)) return {};
    const Vec3 aside = beside(segment, middle), away = -view_.to_eye(aside);
    const double length = away.norm(), blind = blind_px * view_.pixel_size(middle) / length;
    const std::optional<RayHit> hit = first_hit(aside, away, blind);
    const int triangle = hit ? casters_.seen_triangle(hit->triangle) : none;
    if (triangle == none) return {};
    ZeroPoint at;
    at.position = aside + hit->distance * away;
    at.on = locate(surface_, triangle, at.position);
    std::vector<ZeroSegment> way;
    if (!step(aside, middle, at, way)) return {};
    return at;
  }

  // Beyond the blind distance; none where the ray is then within something, which it entered
  // before.
  std::optional<RayHit> first_hit(const Vec3& origin, const Vec3& away, double blind) const {
    std::vector<RayHit> hits;
    casters_.bvh.hits(origin, away, 0, std::numeric_limits<double>::infinity(), hits);
    std::sort(hits.begin(), hits.end(),
              [](const RayHit& a, const RayHit& b) { return a.distance < b.distance; });
    const auto beyond = std::find_if(hits.begin(), hits.end(),
                                     [&](const RayHit& hit) { return hit.distance > blind; });
    if (beyond == hits.end() || (beyond - hits.begin()) % 2 == 1) return {};
    return *beyond;
  }

  // Image x runs along the view's first row, image y against its second.
  Vec3 beside(int segment, const Vec3& p) const {
    const Vec2 along = view_.project_direction(p, point(segment + 1) - point(segment));
    const Vec2 right = Vec2(-along.y(), along.x()) * outline_.outside[idx(segment)];  // y is down
    const double scale = aside_px * view_.pixel_size(p) / std::max(right.norm(), 1e-300);
    const Vec3 x = view_.view().row(0).head<3>(), y = view_.view().row(1).head<3>();
    return p + scale * (right.x() * x - right.y() * y);
  }

  bool is_in_view(const Vec3& p) const {
    if (!(view_.near_distance(p) > 0)) return false;
    const Vec2 at = view_.project(p).xy;
    return at.minCoeff() >= 0 && at.x() <= view_.width_px() && at.y() <= view_.height_px();
  }

  void add_line(std::vector<ZeroSegment> back, const std::vector<ZeroSegment>& ahead,
                bool covers_all) {
    std::reverse(back.begin(), back.end());
    for (ZeroSegment& s : back) std::swap(s[0], s[1]);
    back.insert(back.end(), ahead.begin(), ahead.end());
    if (back.empty()) return;
    std::vector<ZeroPoint> line;
    for (const ZeroSegment& s : back) line.push_back(s[0]);
    const bool closed =
        covers_all && outline_.closed && back.front()[0].on.triangle == back.back()[1].on.triangle;
    if (!closed) line.push_back(back.back()[1]);
    for (ZeroPoint& p : line) p.unseen = is_seen_from_behind(p);
    result_.add({line.data(), line.size()}, closed, Kind::shadow_outline);
  }

  bool is_seen_from_behind(const ZeroPoint& p) const {
    const Vec3 normal = winding_normal(surface_, p.on.triangle);
    return (normal.dot(view_.to_eye(p.position)) < 0) !=
           (normal.dot(viewer_.to_eye(p.position)) < 0);
  }

  const Surface& surface_;  // that is seen
  const LightCasters& casters_;
  const Light& light_;
  const Camera& view_;    // of the light
  const Camera& viewer_;  // who looks at its shadows
  const Outline& outline_;
  FreeLines& result_;
};

}  // namespace

void add_shadow_outlines(const Surface& seen, const LightCasters& casters, const Light& light,
                         const Camera& view, const Camera& viewer, int threads,
                         const Progress& progress, FreeLines& result) {
  NetworkOptions options;
  options.threads = threads;
  Counts counts;
  const ContourScene& scene = casters.scene;
  const ContourScene plain{scene.surface,       scene.limit, scene.features,
                           scene.intersections, scene.dual,  nullptr};
  const CurveNetwork network = build_network(plain, view, options, counts, progress.part(0, 0.4));
  const LabelledGraph graph =
      label_network(network, scene.surface, casters.bvh, view, counts, progress.part(0.4, 0.8),
                    threads, scene.intersections.insets);
  const Vec3 shift = scene.surface.diagonal * off_the_edges;
  for (const Outline& outline : OutlineChains(graph, shift).run()) {
    OutlineShadow(seen, casters, light, view, viewer, outline, result).add();
  }
}

}  // namespace illustrate
