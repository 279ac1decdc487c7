#include "tone/lightness.h"

#include <algorithm>
#include <cmath>

#include "mesh/polygons.h"

namespace illustrate {
namespace {

Vec2 pair_of(double value) { return {value, 0}; }
Vec2 pair_of(const Vec2& value) { return value; }

double twice_area(const std::vector<Vec2>& corners) {
  double sum = 0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    sum += cross(corners[k], corners[(k + 1) % corners.size()]);
  }
  return sum;
}

double in_unit(double value) { return value > 0 ? std::min(value, 1.0) : 0; }

}  // namespace

FaceLightness::FaceLightness(const PolygonMesh& mesh, std::size_t face, std::size_t first_corner) {
  const Reflectance& given = mesh.reflectance;
  if (!given.faces.empty()) whole_ = given.faces[face];
  const int number = given.face_textures.empty() ? none : given.face_textures[face];
  if (given.corners.empty() && number == none) return;
  flatten(mesh, first_corner, idx(mesh.face_sizes[face]));
  if (!given.corners.empty()) shades_ = border_with(given.corners, first_corner);
  if (number == none) return;
  texture_ = given.textures[idx(number)].get();
  uv_ = border_with(given.uv, first_corner);
  find_texels();
}

void FaceLightness::flatten(const PolygonMesh& mesh, std::size_t first, std::size_t size) {
  std::vector<Vec3> points;
  for (std::size_t k = 0; k < size; ++k) {
    points.push_back(mesh.positions[idx(mesh.corner_vertices[first + k])]);
  }
  const Vec3 normal = unit_or_zero(newell_normal({points.data(), points.size()}));
  if (normal.isZero() || !normal.allFinite()) return;
  origin_ = points[0];
  right_ = normal.unitOrthogonal();
  up_ = normal.cross(right_);
  for (const Vec3& p : points) {
    corners_.emplace_back(right_.dot(p - origin_), up_.dot(p - origin_));
  }
}

template <class Value>
std::vector<BorderPiece> FaceLightness::border_with(const std::vector<Value>& of_corners,
                                                    std::size_t first) const {
  std::vector<BorderPiece> border;
  for (std::size_t k = 0; k < corners_.size(); ++k) {
    const std::size_t next = (k + 1) % corners_.size();
    border.push_back({corners_[k], corners_[next], pair_of(of_corners[first + k]),
                      pair_of(of_corners[first + next])});
  }
  return border;
}

void FaceLightness::find_texels() {
  std::vector<Vec2> on_texture;
  for (const BorderPiece& piece : uv_) on_texture.push_back(piece.value_from);
  const double area = std::abs(twice_area(corners_)), covered = std::abs(twice_area(on_texture));
  if (area > 0) texels_per_length_ = texture_->size() * std::sqrt(covered / area);
}

double FaceLightness::at(const Vec3& position, double size) const {
  if (shades_.empty() && uv_.empty()) return in_unit(whole_);
  const Vec3 off = position - origin_;
  const Vec2 flat(right_.dot(off), up_.dot(off));
  double share = whole_;
  if (!shades_.empty()) share *= mean_value(shades_, flat).x();
  if (!uv_.empty()) share *= texture_->mean_at(mean_value(uv_, flat), size * texels_per_length_);
  return in_unit(share);
}

Lightness::Lightness(const Surface& surface,
                     const std::vector<std::shared_ptr<const PolygonMesh>>& meshes)
    : surface_(surface), meshes_(meshes), first_corners_(meshes.size()) {
  for (std::size_t o = 0; o < meshes_.size(); ++o) {
    if (meshes_[o]->reflectance.is_white()) continue;
    is_white_ = false;
    std::size_t first = 0;
    for (const int size : meshes_[o]->face_sizes) {
      first_corners_[o].push_back(first);
      first += idx(size);
    }
  }
}

std::optional<FaceLightness> Lightness::of_triangle(int triangle) const {
  const auto object = idx(surface_.object_of(triangle));
  const int face = surface_.triangle_faces[idx(triangle)];
  if (first_corners_[object].empty() || face == none) return {};
  return FaceLightness(*meshes_[object], idx(face), first_corners_[object][idx(face)]);
}

}  // namespace illustrate
