// How light or dark the places of a surface are by themselves: the reflectance of the meshes it was
// made from.
#pragma once

#include <memory>
#include <optional>

#include "mesh/polygon_mesh.h"
#include "surface/planes/mean_value.h"
#include "surface/surface.h"

namespace illustrate {

// One face of a mesh, flattened: where its corners lie, and what they carry.
class FaceLightness {
 public:
  // Points of the mesh's own space.
  FaceLightness(const PolygonMesh& mesh, std::size_t face, std::size_t first_corner);

  // The share of the light that comes back from a place on the face or near it, in [0, 1]; a
  // texture's mean over a square of the side `size`.
  double at(const Vec3& position, double size) const;

 private:
  void flatten(const PolygonMesh& mesh, std::size_t first, std::size_t size);
  template <class Value>
  std::vector<BorderPiece> border_with(const std::vector<Value>& of_corners,
                                       std::size_t first) const;
  void find_texels();

  double whole_ = 1;  // what is the same all over the face
  Vec3 origin_ = Vec3::Zero(), right_ = Vec3::UnitX(), up_ = Vec3::UnitY();
  std::vector<Vec2> corners_;
  std::vector<BorderPiece> shades_, uv_;  // empty: none
  const Texture* texture_ = nullptr;
  double texels_per_length_ = 0;
};

// The lightness of all objects. Refers to the surface and the list of meshes.
class Lightness {
 public:
  // meshes: of the objects, in order.
  Lightness(const Surface& surface, const std::vector<std::shared_ptr<const PolygonMesh>>& meshes);

  bool is_white() const { return is_white_; }
  // Of the face that a triangle is a piece of; none: white.
  std::optional<FaceLightness> of_triangle(int triangle) const;

 private:
  const Surface& surface_;
  const std::vector<std::shared_ptr<const PolygonMesh>>& meshes_;
  std::vector<std::vector<std::size_t>> first_corners_;  // (objects)(faces) empty: white
  bool is_white_ = true;
};

}  // namespace illustrate
