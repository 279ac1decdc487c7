#include "mesh/instance.h"

#include <algorithm>

#include "core/errors.h"

namespace illustrate {
namespace {

void check_affine(const Mat4& placement) {
  if (placement.allFinite() && placement.row(3) == Eigen::RowVector4d(0, 0, 0, 1)) return;
  throw InvalidInput("placement must be finite, its last row 0, 0, 0, 1");
}

// The first corner of a face stays its first.
template <class Values>
void turn_corners(const std::vector<int>& face_sizes, Values& of_corners) {
  if (of_corners.empty()) return;
  auto first = of_corners.begin();
  for (const int size : face_sizes) {
    if (size > 1) std::reverse(first + 1, first + size);
    first += size;
  }
}

// Normals go by the inverse transpose; of a flattened mesh nothing is known.
void move_normals(const Mat3& linear, Points& normals) {
  const Mat3 inverse_transpose = linear.inverse().transpose();
  for (Vec3& normal : normals) normal = inverse_transpose * normal;
}

}  // namespace

PolygonMesh instance(std::shared_ptr<const PolygonMesh> original, const Mat4& placement,
                     std::string name) {
  check_affine(placement);
  PolygonMesh mesh = *original;
  mesh.name = std::move(name);
  const std::optional<Similarity> similarity = as_similarity(placement);
  const Mat3 linear = placement.topLeftCorner<3, 3>();
  const Vec3 offset = placement.topRightCorner<3, 1>();
  for (Vec3& p : mesh.positions) p = similarity ? similarity->point(p) : Vec3(linear * p + offset);
  move_normals(similarity ? similarity->rotation : linear, mesh.corner_normals);
  mesh.original.reset();
  if (similarity) {
    mesh.placement = *similarity * original->placement;
    mesh.original = original->original ? original->original : std::move(original);
  } else if (linear.determinant() < 0) {
    turn_corners(mesh.face_sizes, mesh.corner_vertices);
    turn_corners(mesh.face_sizes, mesh.corner_normals);
    turn_corners(mesh.face_sizes, mesh.reflectance.corners);
    turn_corners(mesh.face_sizes, mesh.reflectance.uv);
  }
  return mesh;
}

}  // namespace illustrate
