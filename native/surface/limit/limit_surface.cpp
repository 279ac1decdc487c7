#include "surface/limit/limit_surface.h"

#include <algorithm>
#include <unordered_map>

namespace illustrate {

namespace {

// The derivatives turn and grow with the surface.
LimitPoint moved(const LimitPoint& p, const Similarity& placement) {
  LimitPoint result;
  result.position = placement.point(p.position);
  result.du = placement.length(p.du);
  result.dv = placement.length(p.dv);
  result.duu = placement.length(p.duu);
  result.duv = placement.length(p.duv);
  result.dvv = placement.length(p.dvv);
  return result;
}

}  // namespace

LimitSurface::LimitSurface(const Surface& surface) {
  std::unordered_map<const ControlMesh*, std::shared_ptr<const LimitPatches>> of_meshes;
  for (const PlacedControl& control : surface.controls) {
    const ControlMesh& mesh = *control.mesh;
    if (mesh.scheme == Scheme::polygons || mesh.ptex_faces == 0) continue;
    std::shared_ptr<const LimitPatches>& patches = of_meshes[&mesh];
    if (!patches) patches = std::make_shared<const LimitPatches>(mesh.mesh, mesh.scheme);
    objects_.push_back({control, patches});
  }
}

int LimitSurface::ptex_faces() const {
  if (objects_.empty()) return 0;
  const PlacedControl& last = objects_.back().control;
  return last.first_ptex_face + last.mesh->ptex_faces;
}

const LimitSurface::Object* LimitSurface::object_of(int ptex_face) const {
  if (ptex_face < 0 || ptex_face >= ptex_faces()) return nullptr;
  const auto after = std::upper_bound(
      objects_.begin(), objects_.end(), ptex_face,
      [](int face, const Object& object) { return face < object.control.first_ptex_face; });
  return &*(after - 1);
}

bool LimitSurface::is_triangle(int ptex_face) const {
  const Object* object = object_of(ptex_face);
  return object && object->control.mesh->scheme == Scheme::loop;
}

std::optional<LimitPoint> LimitSurface::evaluate(const BasePlace& place) const {
  const Object* object = object_of(place.ptex_face);
  if (!object) return {};
  const PlacedControl& control = object->control;
  const int face = place.ptex_face - control.first_ptex_face;
  const std::vector<std::uint8_t>& off = control.mesh->off_limit;
  if (!off.empty() && off[idx(face)]) return {};
  const auto p = object->patches->evaluate({face, place.uv});
  if (!p || control.placement == Similarity()) return p;
  return moved(*p, control.placement);
}

}  // namespace illustrate
