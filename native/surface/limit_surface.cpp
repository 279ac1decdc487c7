#include "surface/limit_surface.h"

#include <algorithm>

namespace illustrate {

LimitSurface::LimitSurface(const Surface& surface) {
  for (const std::shared_ptr<const ControlMesh>& control : surface.controls) {
    if (control->scheme == Scheme::polygons || control->ptex_faces == 0) continue;
    objects_.push_back(
        {control, std::make_unique<const LimitPatches>(control->mesh, control->scheme)});
  }
}

int LimitSurface::ptex_faces() const {
  if (objects_.empty()) return 0;
  const ControlMesh& last = *objects_.back().control;
  return last.first_ptex_face + last.ptex_faces;
}

const LimitSurface::Object* LimitSurface::object_of(int ptex_face) const {
  if (ptex_face < 0 || ptex_face >= ptex_faces()) return nullptr;
  const auto after = std::upper_bound(
      objects_.begin(), objects_.end(), ptex_face,
      [](int face, const Object& object) { return face < object.control->first_ptex_face; });
  return &*(after - 1);
}

bool LimitSurface::is_triangle(int ptex_face) const {
  const Object* object = object_of(ptex_face);
  return object && object->control->scheme == Scheme::loop;
}

std::optional<LimitPoint> LimitSurface::evaluate(const BasePlace& place) const {
  const Object* object = object_of(place.ptex_face);
  if (!object) return {};
  return object->patches->evaluate({place.ptex_face - object->control->first_ptex_face, place.uv});
}

}  // namespace illustrate
