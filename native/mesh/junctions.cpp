#include "mesh/junctions.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/angles.h"
#include "mesh/bvh.h"
#include "mesh/polygons.h"

namespace illustrate {
namespace {

const double alike_cosine = std::cos(radians(30));

// A vertex on an open edge, `along` of the way from its tail to its head.
struct Junction {
  int half_edge;
  double along;
  int vertex;

  bool operator<(const Junction& other) const {
    return std::tie(half_edge, along, vertex) <
           std::tie(other.half_edge, other.along, other.vertex);
  }
  bool operator==(const Junction& other) const {
    return half_edge == other.half_edge && vertex == other.vertex;
  }
};

class JunctionFinder {
 public:
  JunctionFinder(const Points& positions, const Faces& faces, const BorderEdges& edges)
      : positions_(positions), faces_(faces), edges_(edges) {}

  // Ascending, each once.
  std::vector<Junction> run() {
    std::vector<Triangle> boxes;
    std::vector<std::pair<int, int>> ends;  // vertices, with the open edges that they are ends of
    for (int e = 0; e < edges_.size(); ++e) {
      boxes.push_back({edges_[e].tail, edges_[e].head, edges_[e].head});
      ends.insert(ends.end(), {{edges_[e].tail, e}, {edges_[e].head, e}});
    }
    const Bvh tree(positions_, boxes, 1);
    std::sort(ends.begin(), ends.end());
    for (auto first = ends.begin(), last = first; first != ends.end(); first = last) {
      while (last != ends.end() && last->first == first->first) ++last;
      tree.near_point(positions_[idx(first->first)], edges_.widest_reach(), [&](int edge) {
        if (is_corner(first->first, edges_[edge])) return;
        for (auto end = first; end != last; ++end)
          compare(edges_[edge], edges_[end->second], end->first);
      });
    }
    std::sort(junctions_.begin(), junctions_.end());
    junctions_.erase(std::unique(junctions_.begin(), junctions_.end()), junctions_.end());
    return std::move(junctions_);
  }

 private:
  Vec3 along(const BorderEdge& edge) const {
    return positions_[idx(edge.head)] - positions_[idx(edge.tail)];
  }

  bool are_opposite(const BorderEdge& a, const BorderEdge& b) const {
    const Vec3 of_a = along(a), of_b = along(b);
    return of_a.dot(of_b) < -alike_cosine * of_a.stableNorm() * of_b.stableNorm();
  }

  bool is_corner(int vertex, const BorderEdge& edge) const {
    const auto corners = faces_[faces_.corner_faces[idx(edge.half_edge)]];
    return std::find(corners.begin(), corners.end(), vertex) != corners.end();
  }

  // A vertex at which `other` ends.
  void compare(const BorderEdge& edge, const BorderEdge& other, int vertex) {
    if (!are_opposite(edge, other)) return;
    const Vec3 bar = along(edge), off = positions_[idx(vertex)] - positions_[idx(edge.tail)];
    const double length = bar.stableNorm(), share = off.dot(bar) / (length * length);
    const double margin = edge.reach / length;
    if (!(share > margin && share < 1 - margin)) return;
    if (!((off - share * bar).stableNorm() < std::min(edge.reach, other.reach))) return;
    const Vec3 normal = (1 - share) * edge.tail_normal + share * edge.head_normal;
    const Vec3& other_normal = vertex == other.tail ? other.tail_normal : other.head_normal;
    if (unit_or_zero(normal).dot(other_normal) > alike_cosine)
      junctions_.push_back({edge.half_edge, share, vertex});
  }

  const Points& positions_;
  const Faces& faces_;
  const BorderEdges& edges_;
  std::vector<Junction> junctions_;
};

// The faces with the vertices of junctions as corners, none twice: a tip that is narrower than the
// reach may have one on both of its sides. Counts the corners.
Faces divided(const Faces& faces, const std::vector<Junction>& junctions, std::int64_t& count) {
  Faces result;
  auto next = junctions.begin();
  for (int f = 0; f < faces.size(); ++f) {
    const auto first = next;
    for (int h = faces.offsets[idx(f)]; h < faces.offsets[idx(f) + 1]; ++h) {
      result.push_corner(faces.corners[idx(h)]);
      for (; next != junctions.end() && next->half_edge == h; ++next) {
        const auto is_same = [&](const Junction& j) { return j.vertex == next->vertex; };
        if (std::any_of(first, next, is_same)) continue;
        result.push_corner(next->vertex);
        ++count;
      }
    }
    result.close_face(faces.sources[idx(f)]);
  }
  return result;
}

}  // namespace

bool divide_at_junctions(const Points& positions, const BorderEdges& open, Faces& faces,
                         Counts& report) {
  const std::vector<Junction> junctions = JunctionFinder(positions, faces, open).run();
  if (junctions.empty()) return false;
  faces = divided(faces, junctions, report["junctions"]);
  return true;
}

}  // namespace illustrate
