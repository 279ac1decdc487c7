#include "visibility/loose_labels.h"

#include <algorithm>
#include <tuple>

#include "contour/network/near_clip.h"
#include "core/segment_pairs.h"
#include "visibility/arrangement/image_strands.h"
#include "visibility/reaches.h"

namespace illustrate {
namespace {

// Of a curve: behind its point `segment`, `fraction` of the way in the world to the next.
struct Place {
  int segment;
  double fraction;
  bool operator<(const Place& other) const {
    return std::tie(segment, fraction) < std::tie(other.segment, other.fraction);
  }
};

struct ImageSegment {
  Vec2 a, b;
  double depth_a, depth_b;

  double depth(double fraction, bool perspective) const {
    const double t = world_fraction(fraction, depth_a, depth_b, perspective);
    return depth_a + t * (depth_b - depth_a);
  }
};

std::int64_t clamped(double px) { return static_cast<std::int64_t>(within_reach(px)); }

SegmentBox box_of(const ImageSegment& s) {
  const Vec2 low = s.a.cwiseMin(s.b), high = s.a.cwiseMax(s.b);
  return {{clamped(low.x()) - 1, clamped(low.y()) - 1},
          {clamped(high.x()) + 1, clamped(high.y()) + 1}};
}

class LooseLabeller {
 public:
  LooseLabeller(const CurveNetwork& curves, const Surface& surface, const Bvh& bvh,
                const Camera& camera, LabelledGraph& graph)
      : curves_(clip_near(surface, curves, camera)),
        bvh_(bvh),
        camera_(camera),
        graph_(graph),
        first_node_(static_cast<int>(graph.nodes.size())),
        cuts_(curves_.strands.size()) {}

  void run() {
    cut_behind_curves();
    cut_at_surfaces();
    for (const NetworkNode& node : curves_.nodes)
      graph_.nodes.push_back({node.kind, camera_.project(node.position).xy});
    for (std::size_t s = 0; s < cuts_.size(); ++s) add(static_cast<int>(s));
  }

 private:
  int segments_of(int strand) const {
    const auto count = static_cast<int>(curves_.points[idx(strand)].size());
    return curves_.strands[idx(strand)].closed() ? count : count - 1;
  }

  const Vec3& point(int strand, int i) const {
    const Span<const CurvePoint> points = curves_.points[idx(strand)];
    return points[idx(i) % points.size()].position;
  }

  Vec3 world_at(int strand, const Place& place) const {
    const Vec3 &a = point(strand, place.segment), &b = point(strand, place.segment + 1);
    return a + place.fraction * (b - a);
  }

  ImageSegment projected(const Vec3& a, const Vec3& b) const {
    const ImagePoint from = camera_.project(a), to = camera_.project(b);
    return {from.xy, to.xy, from.depth, to.depth};
  }

  // --- Places where labels may change ---

  void cut_behind_curves() {
    std::vector<ImageSegment> segments;
    std::vector<Edge> sources;  // strand and segment
    for (int s = 0; s < static_cast<int>(cuts_.size()); ++s) {
      for (int i = 0; i < segments_of(s); ++i) {
        segments.push_back(projected(point(s, i), point(s, i + 1)));
        sources.push_back({s, i});
      }
    }
    add_hiding_segments(segments);
    std::vector<SegmentBox> boxes;
    for (const ImageSegment& s : segments) boxes.push_back(box_of(s));
    const int own = static_cast<int>(sources.size());
    overlapping_boxes(boxes, [&](int i, int j) {
      if (i < own && j >= own) cut(sources[idx(i)], segments[idx(i)], segments[idx(j)]);
    });
  }

  void add_hiding_segments(std::vector<ImageSegment>& segments) const {
    for (std::size_t a = 0; a < graph_.arcs.size(); ++a) {
      const GraphArc& arc = graph_.arcs[a];
      if (arc.left_layers == arc.right_layers) continue;
      const auto points = graph_.points[a];
      const auto image = graph_.image[a];
      const std::size_t count = points.size() - (arc.start_node == none ? 0 : 1);
      for (std::size_t i = 0; i < count; ++i) {
        const std::size_t k = (i + 1) % points.size();
        segments.push_back({image[i], image[k], camera_.depth(points[i].position),
                            camera_.depth(points[k].position)});
      }
    }
  }

  void cut(const Edge& source, const ImageSegment& s, const ImageSegment& front) {
    const Vec2 along = s.b - s.a, other = front.b - front.a;
    const double area = cross(along, other);
    if (area == 0) return;
    const double t = cross(front.a - s.a, other) / area, u = cross(front.a - s.a, along) / area;
    if (!(t >= 0 && t <= 1 && u >= 0 && u <= 1)) return;
    const bool perspective = camera_.is_perspective();
    if (front.depth(u, perspective) > s.depth(t, perspective)) return;
    cuts_[idx(source[0])].push_back(
        {source[1], world_fraction(t, s.depth_a, s.depth_b, perspective)});
  }

  void cut_at_surfaces() {
    std::vector<RayHit> hits;
    for (int s = 0; s < static_cast<int>(cuts_.size()); ++s) {
      for (int i = 0; i < segments_of(s); ++i) {
        hits.clear();
        bvh_.hits(point(s, i), point(s, i + 1) - point(s, i), 0, 1, hits);
        for (const RayHit& hit : hits) cuts_[idx(s)].push_back({i, hit.distance});
      }
      std::sort(cuts_[idx(s)].begin(), cuts_[idx(s)].end());
    }
  }

  // --- Pieces between them ---

  struct Piece {
    Place start, end;
    int label;
  };

  void add(int strand) {
    const std::vector<Piece> pieces = labelled_pieces(strand);
    const Strand& whole = curves_.strands[idx(strand)];
    if (whole.closed() && pieces.size() == 1) {
      for (int i = 0; i < segments_of(strand); ++i) push(point(strand, i));
      finish(whole, none, none, pieces[0].label);
      return;
    }
    const int first = whole.closed() ? new_joint(point(strand, 0)) : first_node_ + whole.start_node;
    int start = first;
    for (std::size_t p = 0; p < pieces.size(); ++p) {
      const bool is_last = p + 1 == pieces.size();
      const int last = whole.closed() ? first : first_node_ + whole.end_node;
      const int end = is_last ? last : new_joint(world_at(strand, pieces[p].end));
      push_points(strand, pieces[p]);
      finish(whole, start, end, pieces[p].label);
      start = end;
    }
  }

  // Neighbours have different labels.
  std::vector<Piece> labelled_pieces(int strand) {
    std::vector<Place> places = cuts_[idx(strand)];
    places.insert(places.begin(), {0, 0});
    places.push_back({segments_of(strand) - 1, 1});
    std::vector<Piece> pieces;
    for (std::size_t i = 1; i < places.size(); ++i) {
      const bool is_whole = places.size() == 2;  // asked, however short
      if (!is_whole &&
          length_px(strand, places[i - 1], places[i]) < reaches.least_loose * graph_.unit_px)
        continue;
      const int label = label_between(strand, places[i - 1], places[i]);
      if (pieces.empty() || pieces.back().label != label)
        pieces.push_back({places[i - 1], places[i], label});
    }
    if (pieces.empty()) pieces.push_back({places.front(), places.back(), 0});
    pieces.front().start = places.front();
    for (std::size_t p = 0; p + 1 < pieces.size(); ++p) pieces[p].end = pieces[p + 1].start;
    pieces.back().end = places.back();
    return pieces;
  }

  double length_px(int strand, const Place& from, const Place& to) const {
    double length = 0;
    Vec2 last = camera_.project(world_at(strand, from)).xy;
    for (int i = from.segment + 1; i <= to.segment; ++i) {
      const Vec2 next = camera_.project(point(strand, i)).xy;
      length += (next - last).norm();
      last = next;
    }
    return length + (camera_.project(world_at(strand, to)).xy - last).norm();
  }

  int label_between(int strand, const Place& from, const Place& to) {
    std::array<int, 3> counts{};
    for (int k = 0; k < 3; ++k)
      counts[idx(k)] = layers_before(world_at(strand, between(from, to, (k + 1) / 4.)));
    std::sort(counts.begin(), counts.end());
    return counts[1];
  }

  static Place between(const Place& from, const Place& to, double share) {
    const double start = from.segment + from.fraction, end = to.segment + to.fraction;
    const double at = start + share * (end - start);
    const int segment = std::min(static_cast<int>(at), to.segment);
    return {segment, at - segment};
  }

  int layers_before(const Vec3& p) {
    const Vec3 towards = camera_.to_eye(p);
    const double blind =
        reaches.loose_blind * graph_.unit_px * camera_.pixel_size(p) / towards.norm();
    hits_.clear();
    bvh_.hits(p, towards, blind, camera_.ray_end(p), hits_);
    return static_cast<int>(hits_.size());
  }

  // --- The graph ---

  int new_joint(const Vec3& p) {
    graph_.nodes.push_back({NodeKind::joint, camera_.project(p).xy});
    return static_cast<int>(graph_.nodes.size()) - 1;
  }

  void push(const Vec3& p) {
    graph_.points.push({p, {}});
    graph_.image.push(camera_.project(p).xy);
  }

  void push_points(int strand, const Piece& piece) {
    push(world_at(strand, piece.start));
    for (int i = piece.start.segment + 1; i <= piece.end.segment; ++i) push(point(strand, i));
    push(world_at(strand, piece.end));
  }

  void finish(const Strand& strand, int start_node, int end_node, int label) {
    graph_.points.close_list();
    graph_.image.close_list();
    GraphArc arc{strand.kind, strand.object, none, start_node, end_node, label};
    graph_.arcs.push_back(arc);
  }

  const CurveNetwork curves_;
  const Bvh& bvh_;
  const Camera& camera_;
  LabelledGraph& graph_;
  const int first_node_;
  std::vector<std::vector<Place>> cuts_;  // (strands)
  std::vector<RayHit> hits_;
};

}  // namespace

LabelledGraph with_loose_curves(LabelledGraph graph, const CurveNetwork& curves,
                                const Surface& surface, const Bvh& bvh, const Camera& camera) {
  if (!curves.strands.empty()) LooseLabeller(curves, surface, bvh, camera, graph).run();
  return graph;
}

}  // namespace illustrate
