#include "mesh/gaps.h"

#include <algorithm>
#include <limits>

#include "core/disjoint_sets.h"
#include "mesh/bvh.h"
#include "mesh/mesh_size.h"
#include "mesh/shading.h"
#include "mesh/source_corners.h"

namespace illustrate {
namespace {

// Of the mesh's diagonal: a tenth of a pixel where it fills a page, and as much as programs for
// mechanical design let faces be apart.
constexpr double widest_gap = 1e-4;

// Of an edge and of the height of its face over it: what is moved so far keeps its shape.
constexpr double most_of_length = 0.01, most_of_height = 0.5;

struct BorderEdge {
  int tail, head;
  Vec3 tail_normal, head_normal;  // unit, or zero where there is none
  double reach;                   // how far away its other side may be
  int nearest = none;             // open edge that may be its other side
  double distance = std::numeric_limits<double>::infinity();

  // Of several that are equally near, the first.
  void offer(int other, double other_distance) {
    if (!(other_distance < distance)) return;
    distance = other_distance;
    nearest = other;
  }
};

bool shaded_alike(const Vec3& normal, const Vec3& other) {
  return normal.dot(other) >= crease_normals_cosine;
}

class BorderEdges {
 public:
  BorderEdges(const PolygonMesh& mesh, const Faces& faces, const std::vector<int>& numbers)
      : mesh_(mesh), faces_(faces), corners_(mesh, numbers) {
    const double widest = widest_gap * diagonal(faces, mesh.positions);
    const Ragged<int> edges = half_edges_by_edge(faces, mesh.positions.size());
    for (std::size_t e = 0; e < edges.size(); ++e) {
      if (edges[e].size() == 1) edges_.push_back(read(edges[e][0], widest));
    }
  }

  // Two edges, ascending, for each gap.
  std::vector<Edge> find_gaps() {
    std::vector<Triangle> boxes;
    double margin = 0;
    for (const BorderEdge& edge : edges_) {
      boxes.push_back({edge.tail, edge.head, edge.head});
      margin = std::max(margin, edge.reach);
    }
    Bvh(mesh_.positions, boxes, 1).overlapping_pairs([&](int a, int b) { compare(a, b); }, margin);
    std::vector<Edge> gaps;
    for (int a = 0; a < static_cast<int>(edges_.size()); ++a) {
      const int b = edges_[idx(a)].nearest;
      if (b > a && edges_[idx(b)].nearest == a) gaps.push_back({a, b});
    }
    return gaps;
  }

  const BorderEdge& operator[](int edge) const { return edges_[idx(edge)]; }

 private:
  Vec3 normal(int half_edge) {
    const int source = faces_.sources[idx(faces_.corner_faces[idx(half_edge)])];
    return given_normal(mesh_, corners_.find(source, faces_.corners[idx(half_edge)]));
  }

  BorderEdge read(int half_edge, double widest) {
    const int tail = faces_.corners[idx(half_edge)], head = faces_.head(half_edge);
    const double length = (mesh_.positions[idx(head)] - mesh_.positions[idx(tail)]).stableNorm();
    const double reach =
        std::min({widest, most_of_length * length,
                  most_of_height * reach_of_face(faces_, mesh_.positions, half_edge)});
    return {tail, head, normal(half_edge), normal(faces_.next(half_edge)), reach};
  }

  void compare(int a, int b) {
    BorderEdge &edge = edges_[idx(a)], &other = edges_[idx(b)];
    const Points& positions = mesh_.positions;
    const double distance =
        std::max((positions[idx(edge.tail)] - positions[idx(other.head)]).stableNorm(),
                 (positions[idx(edge.head)] - positions[idx(other.tail)]).stableNorm());
    if (!(distance < std::min(edge.reach, other.reach))) return;
    if (!shaded_alike(edge.tail_normal, other.head_normal) ||
        !shaded_alike(edge.head_normal, other.tail_normal))
      return;
    edge.offer(b, distance);
    other.offer(a, distance);
  }

  const PolygonMesh& mesh_;
  const Faces& faces_;
  SourceCorners corners_;
  std::vector<BorderEdge> edges_;
};

}  // namespace

void close_gaps(const PolygonMesh& mesh, Faces& faces, std::vector<int>& numbers, Counts& report) {
  if (mesh.corner_normals.empty()) return;
  BorderEdges open(mesh, faces, numbers);
  const std::vector<Edge> gaps = open.find_gaps();
  if (gaps.empty()) return;
  report["closed_gaps"] += static_cast<std::int64_t>(gaps.size());
  DisjointSets sets(mesh.positions.size());
  for (const auto& [a, b] : gaps) {
    sets.join(open[a].tail, open[b].head);
    sets.join(open[a].head, open[b].tail);
  }
  weld(sets, mesh.positions, faces, numbers, report);
}

}  // namespace illustrate
