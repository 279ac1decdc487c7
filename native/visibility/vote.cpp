#include "visibility/vote.h"

#include <algorithm>
#include <map>

#include "visibility/build_graph.h"
#include "visibility/evidence/layer_rays.h"

namespace illustrate {
namespace {

struct EdgeOfTriangle {
  int triangle;
  int corner;
};

// The edges of the mesh between a front-facing and a back-facing triangle, and what they can see.
class SilhouetteEdges {
 public:
  SilhouetteEdges(const Surface& surface, const Bvh& bvh, const Camera& camera)
      : surface_(surface), bvh_(bvh), camera_(camera) {}

  // Adds the edges with an end at one of the triangle's corners, each by its lower triangle.
  void near(int triangle, std::vector<EdgeOfTriangle>& found) const {
    for (int corner = 0; corner < 3; ++corner) around(triangle, corner, found);
  }

  bool is_visible(const EdgeOfTriangle& edge) {
    const auto [known, is_new] = visible_.try_emplace({edge.triangle, edge.corner}, false);
    if (is_new) known->second = reaches_eye(edge);
    return known->second;
  }

  std::int64_t rays() const { return rays_; }

 private:
  // All edges at a corner, in the triangles that hang together there, however they are wound.
  void around(int triangle, int corner, std::vector<EdgeOfTriangle>& found) const {
    const int place = place_of(triangle, corner);
    std::vector<int> fan{triangle};
    for (std::size_t i = 0; i < fan.size(); ++i) {
      const int k = corner_at(fan[i], place);
      for (const int edge : {k, previous_corner(k)}) {
        offer({fan[i], edge}, found);
        const int next = surface_.neighbours[idx(fan[i])][idx(edge)];
        const bool is_new = next != none && corner_at(next, place) != none &&
                            std::find(fan.begin(), fan.end(), next) == fan.end();
        if (is_new) fan.push_back(next);
      }
    }
  }

  void offer(const EdgeOfTriangle& edge, std::vector<EdgeOfTriangle>& found) const {
    const int other = surface_.neighbours[idx(edge.triangle)][idx(edge.corner)];
    if (other <= edge.triangle) return;
    if (is_front(edge.triangle, edge.triangle) != is_front(other, edge.triangle))
      found.push_back(edge);
  }

  // Seen on the sheet of `as`, so that neighbours of opposite winding agree.
  bool is_front(int triangle, int as) const {
    const Triangle& t = surface_.triangles[idx(triangle)];
    const Vec3& a = surface_.positions[idx(t[0])];
    const Vec3 &b = surface_.positions[idx(t[1])], &c = surface_.positions[idx(t[2])];
    const bool front = (b - a).cross(c - a).dot(camera_.to_eye(a)) >= 0;
    return front != winds_against(triangle, as);
  }

  bool winds_against(int triangle, int other) const {
    if (triangle == other) return false;
    for (int k = 0; k < 3; ++k) {
      if (surface_.neighbours[idx(triangle)][idx(k)] != other) continue;
      const int at = corner_at(other, place_of(triangle, k));
      return at != none && place_of(other, next_corner(at)) == place_of(triangle, next_corner(k));
    }
    return false;
  }

  bool reaches_eye(const EdgeOfTriangle& edge) {
    const Triangle& t = surface_.triangles[idx(edge.triangle)];
    const Vec3 middle = (surface_.positions[idx(t[idx(edge.corner)])] +
                         surface_.positions[idx(t[idx(next_corner(edge.corner))])]) /
                        2;
    const int other = surface_.neighbours[idx(edge.triangle)][idx(edge.corner)];
    hits_.clear();
    bvh_.hits(middle, camera_.to_eye(middle), 0, camera_.ray_end(middle), hits_);
    ++rays_;
    return std::all_of(hits_.begin(), hits_.end(), [&](const RayHit& hit) {
      return hit.triangle == edge.triangle || hit.triangle == other;
    });
  }

  int place_of(int triangle, int corner) const {
    return surface_.places[idx(surface_.triangles[idx(triangle)][idx(corner)])];
  }
  int corner_at(int triangle, int place) const {
    for (int k = 0; k < 3; ++k) {
      if (place_of(triangle, k) == place) return k;
    }
    return none;
  }

  const Surface& surface_;
  const Bvh& bvh_;
  const Camera& camera_;
  std::map<std::pair<int, int>, bool> visible_;
  std::vector<RayHit> hits_;
  std::int64_t rays_ = 0;
};

class Voter {
 public:
  Voter(const Arrangement& arrangement, SilhouetteEdges& edges, LayerRays& rays)
      : arrangement_(arrangement), edges_(edges), rays_(rays) {}

  LabelledPath label(const Path& path) {
    LabelledPath result{path_arcs(arrangement_, path), {}};
    for (const PathArc& arc : result.arcs) result.layers.push_back(is_hidden(arc) ? 1 : 0);
    return result;
  }

 private:
  bool is_hidden(const PathArc& arc) {
    const Strand& strand = arrangement_.strand(arc.strand);
    const int votes = strand.kind == Kind::silhouette ? majority(arc) : 0;
    // As many for as against: nobody is right, and a ray is asked.
    return votes != 0 ? votes < 0 : rays_.count(arrangement_, arc.samples[1]).layers > 0;
  }

  // Visible edges near the arc less hidden ones, each once.
  int majority(const PathArc& arc) {
    std::vector<EdgeOfTriangle> near;
    const std::vector<CurvePoint>& points = arrangement_.network().points.values;
    const int count = arrangement_.point_count(arc.strand);
    const auto& visits = arrangement_.visits(arc.strand);
    const int first = arc.begin == none ? 0 : visits[idx(arc.begin)].place.segment;
    int last = arc.end == none ? count - 1 : visits[idx(arc.end)].place.segment;
    const bool closed = arrangement_.strand(arc.strand).closed();
    if (closed && arc.begin != none && arc.end <= arc.begin) last += count;
    int before = none;
    for (int i = first; i <= last; ++i) {
      const int triangle = points[arrangement_.point(arc.strand, i)].on.triangle;
      if (triangle != before) edges_.near(triangle, near);
      before = triangle;
    }
    return count_votes(near);
  }

  int count_votes(std::vector<EdgeOfTriangle>& near) {
    const auto key = [](const EdgeOfTriangle& e) { return std::make_pair(e.triangle, e.corner); };
    std::sort(near.begin(), near.end(),
              [&](const auto& a, const auto& b) { return key(a) < key(b); });
    const auto end = std::unique(near.begin(), near.end(),
                                 [&](const auto& a, const auto& b) { return key(a) == key(b); });
    int votes = 0;
    for (auto e = near.begin(); e != end; ++e) votes += edges_.is_visible(*e) ? 1 : -1;
    return votes;
  }

  const Arrangement& arrangement_;
  SilhouetteEdges& edges_;
  LayerRays& rays_;
};

}  // namespace

LabelledGraph vote_network(const CurveNetwork& network, const Surface& surface, const Bvh& bvh,
                           const Camera& camera, Counts& counts, const Progress& progress) {
  const Arrangement arrangement = arrange(network, camera);
  SilhouetteEdges edges(surface, bvh, camera);
  const Insets no_insets;
  LayerRays rays(surface, bvh, camera, no_insets);
  Voter voter(arrangement, edges, rays);
  std::vector<LabelledPath> labels;
  for (const Path& path : arrangement.paths()) {
    progress.report(static_cast<double>(labels.size()) /
                    static_cast<double>(arrangement.paths().size()));
    labels.push_back(voter.label(path));
  }
  counts["crossings"] += arrangement.live_crossings();
  counts["rays"] += rays.rays() + edges.rays();
  counts["loops"] += arrangement.loops();
  return build_graph(arrangement, labels, surface);
}

}  // namespace illustrate
