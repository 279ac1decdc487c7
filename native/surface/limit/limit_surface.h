// The limit surface of all objects, asked anywhere: (ptex face, u, v) to position and derivatives
// (paper section 3).
#pragma once

#include "surface/limit/limit_patches.h"
#include "surface/surface.h"

namespace illustrate {

class LimitSurface {
 public:
  // Keeps the control meshes of `surface` alive. Objects of one control mesh share its patches,
  // moved. Those of another frame are not handed on, though it may have the same control meshes:
  // what is kept of them would grow with every view that asks for others.
  explicit LimitSurface(const Surface& surface);

  // One past the last ptex face; 0 where no object is subdivided.
  int ptex_faces() const;

  // `place` counts the ptex faces of all objects, one after another. Outside of the face (the
  // square or, in meshes of Loop's scheme, the triangle u, v, 1 - u - v >= 0) the surface is
  // continued by its Taylor polynomial of the second degree. Nothing where there is no such face,
  // nor where the surface is not the limit (ControlMesh::off_limit). Safe between threads.
  std::optional<LimitPoint> evaluate(const BasePlace& place) const;

  // Whether the ptex face is a triangle. Throws nothing: false where there is no such face.
  bool is_triangle(int ptex_face) const;

 private:
  struct Object {
    PlacedControl control;
    std::shared_ptr<const LimitPatches>
        patches;  // shared with all objects of the same control mesh
  };

  const Object* object_of(int ptex_face) const;

  std::vector<Object> objects_;  // those that are subdivided, by ptex face
};

}  // namespace illustrate
