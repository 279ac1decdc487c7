// Objects that are the same in two frames.
#pragma once

#include "surface/surface.h"

namespace illustrate {

// (objects) of the last frame's the one of the same name, those of one name by their order; of a
// new name, the one of the same number if nothing else has its name. No two the same; or none.
std::vector<int> objects_by_name(const std::vector<std::string>& last,
                                 const std::vector<std::string>& now);

// Finds the objects of one surface again in another. An object is the same where it has the same
// control mesh, or as many vertices, each at the same place of its control mesh, and faces of the
// same outlines. Triangles may differ: quads are split along their shorter diagonals, which change
// while a mesh deforms. Refers to both surfaces.
class SameObjects {
 public:
  // last_objects: (objects) the object of the last surface that each may be, no two the same one,
  // or none. Empty: by their numbers, where there are as many.
  SameObjects(const Surface& last, const Surface& now, const std::vector<int>& last_objects = {});

  bool any() const;
  const Surface& last() const { return last_; }
  // The vertex of the last surface that a vertex of this one was; none where its object is another.
  int last_vertex(std::size_t vertex) const { return shifted(now_.objects[vertex], vertex, 0); }
  int last_triangle(std::size_t triangle) const {
    return shifted(now_.triangle_objects[triangle], triangle, 1);
  }

  // Where a point of the last surface has come to: whether it is still there, its position, and
  // the triangle there.
  bool has(const SurfacePoint& last) const {
    return now_objects_[idx(last_.object_of(last.triangle))] != none;
  }
  Vec3 position(const SurfacePoint& last) const;
  SurfacePoint point(const SurfacePoint& last) const;

 private:
  int shifted(int object, std::size_t number, std::size_t kind) const {
    return is_same_[idx(object)] ? static_cast<int>(number) - shifts_[idx(object)][kind] : none;
  }
  const std::array<int, 2>& shifts_of(const SurfacePoint& last) const {
    return shifts_[idx(now_objects_[idx(last_.object_of(last.triangle))])];
  }

  const Surface& last_;
  const Surface& now_;
  std::vector<std::uint8_t> is_same_;       // (objects) of this surface
  std::vector<int> now_objects_;            // (objects) of the last surface: here, or none
  std::vector<std::array<int, 2>> shifts_;  // (objects) of vertices and triangles, now less last
};

}  // namespace illustrate
