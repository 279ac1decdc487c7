#include "control/straight_creases.h"

#include <algorithm>

#include "control/half_edges.h"
#include "core/tolerances.h"

namespace illustrate {
namespace {

constexpr double unlike = 1.1;  // of lengths, the longer by the shorter

class StraightCreases {
 public:
  explicit StraightCreases(const SoundMesh& mesh)
      : mesh_(mesh), edges_(mesh), sectors_(find_sectors(edges_, mesh.positions.size())) {}

  std::vector<std::uint8_t> find() const {
    const std::size_t count = mesh_.positions.size();
    std::vector<std::uint8_t> found(count, 0);
    for (std::size_t v = 0; v < count; ++v) found[v] = sectors_.sharp_edges[v] == 2;
    for (std::size_t s = 0; s < sectors_.corners.size(); ++s) {
      const Span<const int> sector = sectors_.corners[s];
      if (!is_flat(sector)) found[idx(edges_.faces.corners[idx(sector[0])])] = 0;
    }
    const std::vector<Edge> neighbours = crease_neighbours(edges_, count);
    for (std::size_t v = 0; v < count; ++v) found[v] = found[v] && runs_straight(v, neighbours[v]);
    return found;
  }

 private:
  bool is_flat(Span<const int> sector) const {
    const auto plane = [&](int c) {
      return mesh_.face_planes[idx(edges_.faces.corner_faces[idx(c)])];
    };
    return std::all_of(sector.begin(), sector.end(),
                       [&](int c) { return plane(c) != none && plane(c) == plane(sector[0]); });
  }

  bool runs_straight(std::size_t v, const Edge& neighbours) const {
    const Points& p = mesh_.positions;
    const Vec3 first = p[idx(neighbours[0])] - p[v], second = p[idx(neighbours[1])] - p[v];
    const double a = first.norm(), b = second.norm();
    const bool is_unlike = std::max(a, b) > unlike * std::min(a, b);
    return is_unlike && first.dot(second) < 0 &&
           first.cross(second).norm() <= tolerance::flat_rad * a * b;
  }

  const SoundMesh& mesh_;
  HalfEdges edges_;
  VertexSectors sectors_;
};

}  // namespace

void hold_straight_creases(SoundMesh& mesh) {
  if (mesh.face_planes.empty()) return;
  const std::vector<std::uint8_t> held = StraightCreases(mesh).find();
  mesh.vertex_sharpness.resize(held.size(), 0);
  for (std::size_t v = 0; v < held.size(); ++v)
    if (held[v]) mesh.vertex_sharpness[v] = infinitely_sharp;
}

}  // namespace illustrate
