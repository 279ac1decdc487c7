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
    const std::vector<std::array<Vec3, 2>> ways = ways_along(found);
    for (std::size_t v = 0; v < count; ++v) found[v] = found[v] && runs_straight(ways[v]);
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

  // (n) to both neighbours on the crease, of the vertices asked for.
  std::vector<std::array<Vec3, 2>> ways_along(const std::vector<std::uint8_t>& asked) const {
    std::vector<std::array<Vec3, 2>> ways(asked.size(), {Vec3::Zero(), Vec3::Zero()});
    for (const int h : edges_.first) {
      if (!edges_.is_sharp(h)) continue;
      const int a = edges_.faces.corners[idx(h)], b = edges_.faces.head(h);
      for (const auto& [here, other] : {Edge{a, b}, Edge{b, a}}) {
        if (!asked[idx(here)]) continue;
        auto& [first, second] = ways[idx(here)];
        (first.isZero(0) ? first : second) =
            mesh_.positions[idx(other)] - mesh_.positions[idx(here)];
      }
    }
    return ways;
  }

  static bool runs_straight(const std::array<Vec3, 2>& ways) {
    const double a = ways[0].norm(), b = ways[1].norm();
    const bool is_unlike = std::max(a, b) > unlike * std::min(a, b);
    return is_unlike && ways[0].dot(ways[1]) < 0 &&
           ways[0].cross(ways[1]).norm() <= tolerance::flat_rad * a * b;
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
