#include "contour/silhouettes.h"

#include <utility>

#include "core/index_map.h"
#include "core/prefetch.h"
#include "surface/edge_kinds.h"
#include "surface/locate.h"

namespace illustrate {
namespace {

// By the corners that are front, a bit for each: the edge from a front corner to a back one, and
// that from a back corner to a front one.
constexpr std::array<int, 8> edge_in{none, 0, 1, 1, 2, 0, 2, none};
constexpr std::array<int, 8> edge_out{none, 2, 0, 2, 1, 1, 0, none};

// One triangle's segment: in over the edge that turns from front to back, out over the other.
struct Segment {
  int in = none;
  int out = none;
  int next = none;            // segment beyond `out`
  bool has_previous = false;  // a segment beyond `in`
};

// C at a vertex, on its own sheet.
struct CuspFunction {
  int vertex = none;
  double value = 0;
};

// Follows the segments of triangles from one to the next.
class Tracer {
 public:
  Tracer(const Surface& surface, const ContourFunctions& functions, const SilhouetteSearch& found,
         LinearSilhouettes& result)
      : surface_(surface),
        functions_(functions),
        triangles_(found.triangles),
        g_(found.g),
        fronts_(found.fronts),
        traced_(triangles_.size(), 0),
        result_(result) {}

  void run() {
    segments_.reserve(triangles_.size());
    result_.chains.values.reserve(triangles_.size() + triangles_.size() / 16);
    const int count = static_cast<int>(triangles_.size());
    for (const std::uint8_t f : fronts_) segments_.push_back({edge_in[f], edge_out[f]});
    link();
    for (int i = 0; i < count; ++i) {
      if (!traced_[idx(i)] && !segments_[idx(i)].has_previous) trace(i);
    }
    for (int i = 0; i < count; ++i) {
      if (!traced_[idx(i)]) trace(i);
    }
  }

 private:
  void link() {
    const int count = static_cast<int>(triangles_.size());
    IndexMap index(triangles_.size());
    for (int i = 0; i < count; ++i) index.at(triangles_[idx(i)]) = i;
    for (int i = 0; i < count; ++i) {
      const int next = segments_[idx(i)].next = segment_behind(i, index);
      if (next != none) segments_[idx(next)].has_previous = true;
    }
  }

  // The segment that goes on where segment i ends.
  int segment_behind(int i, const IndexMap& index) const {
    const std::size_t triangle = idx(triangles_[idx(i)]), out = idx(segments_[idx(i)].out);
    if (parts_surface(surface_.edge_kinds[triangle][out])) return none;
    const int other = surface_.neighbours[triangle][out];
    return other == none ? none : index[other];
  }

  void trace(int first) {
    int i = first, last = first;
    for (; i != none && !traced_[idx(i)]; i = segments_[idx(i)].next) {
      traced_[idx(i)] = 1;
      push_segment(i);
      last = i;
    }
    const bool closed = i == first;
    if (!closed) {
      result_.chains.push(edge_point(last, segments_[idx(last)].out, cusp_functions(last)));
    }
    result_.chains.close_list();
    result_.closed.push_back(closed);
  }

  // C at the corners of segment i's triangle, which has two of them with the last one in common:
  // those of the edge between them, which runs the other way there.
  std::array<double, 3> cusp_functions(int i) {
    const int triangle = triangles_[idx(i)];
    const Triangle& corners = surface_.triangles[idx(triangle)];
    const int in = segments_[idx(i)].in, out = segments_[idx(i)].out;
    std::array<double, 3> values;
    values[idx(in)] = cusp_function(corners[idx(in)], passed_[1]);
    values[idx(next_corner(in))] = cusp_function(corners[idx(next_corner(in))], passed_[0]);
    values[idx(previous_corner(in))] = functions_.cusp_function(corners[idx(previous_corner(in))]);
    passed_[0] = {corners[idx(out)], values[idx(out)]};
    passed_[1] = {corners[idx(next_corner(out))], values[idx(next_corner(out))]};
    if (surface_.flips[idx(triangle)] != 0) {
      for (int k = 0; k < 3; ++k) values[idx(k)] *= surface_.corner_sign(triangle, k);
    }
    return values;
  }

  double cusp_function(int vertex, const CuspFunction& known) const {
    return vertex == known.vertex ? known.value : functions_.cusp_function(vertex);
  }

  void push_segment(int i) {
    const std::array<double, 3> values = cusp_functions(i);
    const Segment& segment = segments_[idx(i)];
    EdgePoint p = edge_point(i, segment.in, values);
    p.out = segment.out;
    const int positive = (values[0] >= 0) + (values[1] >= 0) + (values[2] >= 0);
    p.has_both_signs = positive == 1 || positive == 2;
    result_.chains.push(p);
  }

  // Where the segment i crosses an edge; values: C at the corners.
  EdgePoint edge_point(int i, int corner, const std::array<double, 3>& values) const {
    const int triangle = triangles_[idx(i)];
    const std::array<double, 3>& g = g_[idx(i)];
    const Triangle& corners = surface_.triangles[idx(triangle)];
    const int next = next_corner(corner);
    // Both triangles of an edge go from its lower vertex to its higher one.
    const bool ascending = corners[idx(corner)] < corners[idx(next)];
    const int low = ascending ? corner : next, high = ascending ? next : corner;
    const double zero = zero_between(g[idx(low)], g[idx(high)]), rest = 1 - zero;
    const Vec3& a = surface_.positions[idx(corners[idx(low)])];
    const Vec3& b = surface_.positions[idx(corners[idx(high)])];
    EdgePoint p;
    p.fraction = ascending ? zero : rest;
    p.position = a + (ascending ? zero : 1 - rest) * (b - a);
    p.on = on_edge(triangle, corner, p.fraction);
    p.edge = corner;
    p.cusp_function = (1 - p.fraction) * values[idx(corner)] + p.fraction * values[idx(next)];
    return p;
  }

  const Surface& surface_;
  const ContourFunctions& functions_;
  const std::vector<int>& triangles_;
  const std::vector<std::array<double, 3>>& g_;  // at their corners
  const std::vector<std::uint8_t>& fronts_;
  std::vector<Segment> segments_;  // in them
  std::vector<std::uint8_t> traced_;
  std::array<CuspFunction, 2> passed_;  // at the ends of the edge that was left last
  LinearSilhouettes& result_;
};

// What following the segment of a triangle looks at later.
void prefetch_segment(const Surface& surface, int triangle) {
  prefetch(&surface.neighbours[idx(triangle)]);
  prefetch(&surface.edge_kinds[idx(triangle)]);
  for (const int v : surface.triangles[idx(triangle)]) prefetch(&surface.curvature[idx(v)]);
}

// What `search` looks at later.
void prefetch_corners(const Surface& surface, const std::vector<int>& triangles, std::size_t i) {
  constexpr std::size_t soon = 8, later = 16;
  if (i + later >= triangles.size()) return;
  prefetch(&surface.triangles[idx(triangles[i + later])]);
  for (const int v : surface.triangles[idx(triangles[i + soon])]) {
    prefetch(&surface.positions[idx(v)]);
    prefetch(&surface.normals[idx(v)]);
  }
}

SilhouetteSearch search(const Surface& surface, const ContourFunctions& functions,
                        const DualSurface& dual) {
  SilhouetteSearch result;
  const std::vector<int> visited = dual.triangles(functions.camera());
  result.visited = static_cast<std::int64_t>(visited.size());
  result.triangles.reserve(visited.size());
  result.g.reserve(visited.size());
  result.fronts.reserve(visited.size());
  for (std::size_t i = 0; i < visited.size(); ++i) {
    prefetch_corners(surface, visited, i);
    const int t = visited[i];
    const Triangle& v = surface.triangles[idx(t)];
    const std::array<double, 3> g{functions.g(v[0]), functions.g(v[1]), functions.g(v[2])};
    int fronts = surface.flips[idx(t)] & 7;  // a bit for each corner
    for (int k = 0; k < 3; ++k) fronts ^= (g[idx(k)] >= 0) << k;
    if (fronts == 0 || fronts == 7) continue;
    prefetch_segment(surface, t);
    result.triangles.push_back(t);
    result.g.push_back(g);
    result.fronts.push_back(static_cast<std::uint8_t>(fronts));
  }
  return result;
}

SilhouetteSearch scan(const Surface& surface, const ContourFunctions& functions) {
  std::vector<std::uint8_t> front(surface.positions.size());
  for (int v = 0; v < static_cast<int>(front.size()); ++v) front[idx(v)] = functions.g(v) >= 0;
  SilhouetteSearch result;
  for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t) {
    if (!surface.is_smooth_at(t)) continue;
    ++result.visited;
    const Triangle& v = surface.triangles[idx(t)];
    int fronts = surface.flips[idx(t)] & 7;  // a bit for each corner
    for (int k = 0; k < 3; ++k) fronts ^= front[idx(v[idx(k)])] << k;
    if (fronts == 0 || fronts == 7) continue;
    result.triangles.push_back(t);
    result.g.push_back({functions.g(v[0]), functions.g(v[1]), functions.g(v[2])});
    result.fronts.push_back(static_cast<std::uint8_t>(fronts));
  }
  return result;
}

}  // namespace

SilhouetteSearch find_silhouette_triangles(const Surface& surface,
                                           const ContourFunctions& functions,
                                           const DualSurface* dual) {
  return dual ? search(surface, functions, *dual) : scan(surface, functions);
}

LinearSilhouettes linear_silhouettes(const Surface& surface, const ContourFunctions& functions,
                                     const DualSurface* dual) {
  SilhouetteSearch found = find_silhouette_triangles(surface, functions, dual);
  LinearSilhouettes result;
  Tracer(surface, functions, found, result).run();
  result.triangles = std::move(found.triangles);
  result.triangles_visited = found.visited;
  return result;
}

}  // namespace illustrate
