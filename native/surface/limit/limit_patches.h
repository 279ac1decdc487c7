// The limit surface of one subdivided mesh, piece by piece (paper section 3): the patches of a face
// are made when it is first asked for, and kept, up to 160 MB. What faces of the same kind share is
// kept with them, and up to 128 MB more of it for faces to come.
//
// Regular faces without creases are one polynomial. Others are OpenSubdiv's adaptive patches (Bfr);
// those that are asked for become polynomials too. They go 7 levels deep: beyond, within 1/64 of an
// extraordinary vertex, second derivatives are those of a filling patch and have no meaning. Third
// derivatives jump between its patches. Faces with more than 100 corners, or with more than 100
// edges at one of them, have no patches here.
#pragma once

#include <memory>
#include <optional>

#include "surface/limit/limit_point.h"
#include "surface/subdivision/refined_mesh.h"

namespace illustrate {

class LimitPatches {
 public:
  // scheme: catmull_clark, or loop for a mesh of triangles. leaf_bytes: what polynomials of
  // irregular faces may take; more are made again each time, which takes six times as long.
  LimitPatches(const SoundMesh& mesh, Scheme scheme,
               std::size_t leaf_bytes = std::size_t{64} << 20);
  ~LimitPatches();

  // Outside of the face (the square, or the triangle u, v, 1 - u - v >= 0) the surface is continued
  // by its Taylor polynomial of the second degree. Nothing where the mesh has no such surface. Safe
  // between threads.
  std::optional<LimitPoint> evaluate(const BasePlace& place) const;

  // The same without keeping anything but the last face: for one pass over places face by face.
  class Pass {
   public:
    explicit Pass(const LimitPatches& patches) : patches_(patches) {}
    std::optional<LimitPoint> evaluate(const BasePlace& place);

   private:
    const LimitPatches& patches_;
    int face_ = none;
    std::shared_ptr<const void> made_;
  };

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace illustrate
