#include "mesh/border_edges.h"

#include <algorithm>
#include <cmath>

#include "mesh/edge_turns.h"
#include "mesh/mesh_size.h"
#include "mesh/shading.h"
#include "mesh/source_corners.h"

namespace illustrate {
namespace {

// Of the mesh's diagonal: a tenth of a pixel where it fills a page, and as much as programs for
// mechanical design let faces be apart.
constexpr double widest_gap = 1e-4;

constexpr double most_of_height = 0.5;

class BorderReader {
 public:
  BorderReader(const PolygonMesh& mesh, const Faces& faces, const std::vector<int>& numbers)
      : mesh_(mesh),
        faces_(faces),
        corners_(mesh, numbers),
        normals_(unit_normals(faces, mesh.positions)),
        widest_(widest_gap * diagonal(faces, mesh.positions)) {}

  BorderEdge read(int half_edge) {
    const int next = faces_.next(half_edge);
    const Vec3& of_face = normals_[idx(faces_.corner_faces[idx(half_edge)])];
    const Vec3 tail = normal(half_edge, of_face), head = normal(next, of_face);
    return {half_edge,
            faces_.corners[idx(half_edge)],
            faces_.corners[idx(next)],
            tail,
            head,
            tail.dot(of_face) >= flat_shading_cosine && head.dot(of_face) >= flat_shading_cosine,
            std::min(widest_, most_of_height * reach_of_face(faces_, mesh_.positions, half_edge))};
  }

 private:
  Vec3 normal(int corner, const Vec3& of_face) {
    const int source = faces_.sources[idx(faces_.corner_faces[idx(corner)])];
    const Vec3 given = given_normal(mesh_, corners_.find(source, faces_.corners[idx(corner)]));
    return given.isZero() ? of_face : given;
  }

  const PolygonMesh& mesh_;
  const Faces& faces_;
  SourceCorners corners_;
  const Points normals_;
  double widest_;
};

}  // namespace

BorderEdges::BorderEdges(const PolygonMesh& mesh, const Faces& faces,
                         const std::vector<int>& numbers)
    : crease_cosine_(std::cos(radians(std::min(mesh.crease_angle_deg, steep_deg)))) {
  const Ragged<int> edges = half_edges_by_edge(faces, mesh.positions.size());
  std::vector<int> open;
  for (std::size_t e = 0; e < edges.size(); ++e)
    if (edges[e].size() == 1) open.push_back(edges[e][0]);
  if (open.empty()) return;
  BorderReader reader(mesh, faces, numbers);
  for (const int half_edge : open) {
    edges_.push_back(reader.read(half_edge));
    widest_ = std::max(widest_, edges_.back().reach);
  }
}

bool BorderEdges::shaded_alike(const BorderEdge& a, const Vec3& normal_of_a, const BorderEdge& b,
                               const Vec3& normal_of_b) const {
  const double cosine = normal_of_a.dot(normal_of_b);
  return cosine >= (a.is_flat && b.is_flat ? crease_cosine_ : crease_normals_cosine);
}

}  // namespace illustrate
