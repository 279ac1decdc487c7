#include "surface/planes/folded_normals.h"

#include "core/tolerances.h"
#include "surface/shading.h"

namespace illustrate {
namespace {

// Cosine from which a normal is the opposite of a control face's: 143 degrees. What folds in a
// plane has exactly opposite normals, at a plane's rounding those of the faces beside it are
// tilted; what bends has others between.
constexpr double opposite = -0.8;

// Zero for needles: rounding says which way they face.
Points normals_of_faces(const RefinedMesh& mesh) {
  const double least = tolerance::same_place * mean_edge(mesh);
  Points normals;
  for (int f = 0; f < static_cast<int>(mesh.face_count()); ++f) {
    const Vec3 area = mesh.twice_area(f);
    const bool is_needle = area.norm() <= least * mesh.longest_edge(f);
    normals.push_back(is_needle ? Vec3(Vec3::Zero()) : unit_or_zero(area));
  }
  return normals;
}

}  // namespace

void turn_folded_normals(const RefinedMesh& control, const RefinedMesh& mesh,
                         const std::vector<int>& corner_sectors, Points& normals) {
  const Points of_faces = normals_of_faces(control);
  std::vector<std::uint8_t> is_folded(normals.size(), 1);
  for (int c = 0; c < static_cast<int>(mesh.corner_count()); ++c) {
    const std::size_t s = idx(corner_sectors[idx(c)]);
    if (!is_folded[s]) continue;
    const Vec3& of_face = of_faces[idx(mesh.base_faces[idx(mesh.face(c))])];
    is_folded[s] = normals[s].dot(of_face) < opposite;
  }
  for (const int sector : corner_sectors) {
    const std::size_t s = idx(sector);
    if (!is_folded[s]) continue;
    normals[s] = -normals[s];
    is_folded[s] = 0;
  }
}

}  // namespace illustrate
