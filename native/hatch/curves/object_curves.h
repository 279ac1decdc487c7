// The curves that hatches start from, of all objects of a scene. Objects that are placed copies of
// one surface share its curves.
#pragma once

#include "hatch/curves/surface_curves.h"
#include "surface/instances.h"

namespace illustrate {

// The curves of an object; those that share a surface share them.
struct CurvesOfObject {
  const SurfaceCurves* shared = nullptr;  // null where none are wanted
  int first_triangle = 0;                 // of the object, less that of `shared`
  double scale = 1;                       // of the object, where that of `shared` is 1

  explicit operator bool() const { return shared != nullptr; }
  double area() const { return scale * scale * shared->area; }
  Ragged<SurfacePoint> curves() const;
  // A place of `shared` on the object.
  SurfacePoint placed(SurfacePoint on) const {
    on.triangle += first_triangle;
    return on;
  }
  // Whether a curve is among those down to this radius.
  bool is_needed(std::size_t curve, double radius) const {
    return radius / scale < shared->needed_below[curve];
  }
  std::vector<SurfacePoint> seeds() const;
};
using CurvesOfObjects = std::vector<CurvesOfObject>;

// The ranked curves of all objects.
class ObjectCurves {
 public:
  // Refers to surface and field; `areas` as above.
  ObjectCurves(const Surface& surface, const CrossField& field,
               const std::vector<double>& areas = {});

  // Of objects that have their surfaces in common, from those and their field. Of the areas, which
  // are those of the objects' triangles, the first object's of each surface count.
  ObjectCurves(const Surface& originals, const CrossField& field, const Instances& instances,
               const std::vector<double>& areas = {});

  // Of each object down to its own radius, as above; infinite: none of it. seeds_only: (objects) 1:
  // without curves; empty: all with. Several objects at a time (threads: 0 for all cores).
  CurvesOfObjects down_to(const std::vector<double>& radii,
                          const std::vector<std::uint8_t>& seeds_only = {}, int threads = 0,
                          const Progress& progress = {});

 private:
  // The original of an object, and what tells the object from it.
  struct Placed {
    std::size_t original;
    int first_triangle;
    double scale;
  };

  void rank(const Surface& surface, const CrossField& field, const std::vector<double>& areas);
  // (originals) down to these radii; infinite: none.
  void make(const std::vector<double>& finest, int threads, const Progress& progress);
  CurvesOfObject of_object(const Placed& object, double radius, bool has_curves);

  std::vector<std::unique_ptr<RankedCurves>> originals_;
  std::vector<Placed> objects_;
};

}  // namespace illustrate
