#include "control/choose_scheme.h"

#include <algorithm>

#include "mesh/polygons.h"

namespace illustrate {
namespace {

// Catmull-Clark divides such a face round its middle: where not all of its border is seen from
// there, parts of it lie outside, and a window cut into a wall is closed by the wall.
bool is_seen_from_its_middle(const Points& polygon) {
  const Vec3 normal = newell_normal({polygon.data(), polygon.size()});
  Vec3 middle = Vec3::Zero();
  for (const Vec3& p : polygon) middle += p / static_cast<double>(polygon.size());
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec3& next = polygon[(k + 1) % polygon.size()];
    if ((polygon[k] - middle).cross(next - middle).dot(normal) < 0) return false;
  }
  return true;
}

// Of more corners than four: quads are patches themselves.
bool has_hidden_borders(const SoundMesh& mesh) {
  Points polygon;
  std::size_t corner = 0;
  for (const int size : mesh.face_sizes) {
    polygon.clear();
    for (int k = 0; size > 4 && k < size; ++k) {
      polygon.push_back(mesh.positions[idx(mesh.corner_vertices[corner + idx(k)])]);
    }
    if (size > 4 && !is_seen_from_its_middle(polygon)) return true;
    corner += idx(size);
  }
  return false;
}

}  // namespace

Scheme choose_scheme(const SoundMesh& mesh, Scheme usual) {
  const Scheme scheme = mesh.scheme.value_or(usual);
  if (mesh.face_sizes.empty()) return Scheme::polygons;
  if (scheme != Scheme::automatic) return scheme;
  const auto quads = std::count(mesh.face_sizes.begin(), mesh.face_sizes.end(), 4);
  const bool are_most = 2 * static_cast<std::size_t>(quads) > mesh.face_sizes.size();
  if (!are_most || (!mesh.cage && has_hidden_borders(mesh))) return Scheme::loop;
  return Scheme::catmull_clark;
}

}  // namespace illustrate
