// Everything that does not depend on the view, made once and kept between frames.
#pragma once

#include <memory>
#include <optional>

#include "contour/dual/dual_surface.h"
#include "contour/intersection/intersections.h"
#include "contour/shape/feature_edges.h"
#include "core/lazy.h"
#include "field/families/families.h"
#include "hatch/curves/object_curves.h"
#include "mesh/bvh.h"
#include "pipeline/options.h"
#include "pipeline/originals.h"
#include "surface/jets/curvature_derivative.h"
#include "surface/limit/limit_surface.h"
#include "surface/parts.h"

namespace illustrate {

// What was found and mended in one mesh.
struct MeshReport {
  std::string name;
  Counts counts;
};

// Immutable as seen from outside: what not every drawing needs is made when it is first asked for,
// once.
class Prepared {
 public:
  Prepared(const std::vector<MeshPointer>& meshes, const PrepareOptions& options,
           const Prepared* previous, const Progress& progress);

  // Of the objects, as they were given last: those that this was made from may differ in what
  // shapes nothing, such as their reflectance.
  const std::vector<MeshPointer>& meshes() const { return meshes_; }
  std::size_t object_count() const { return geometry_->originals.objects.size(); }
  const Surface& surface() const { return *geometry_->surface; }
  std::shared_ptr<const Surface> shared_surface() const { return geometry_->surface; }
  const LimitSurface& limit_surface() const { return *geometry_->limit_surface; }
  const Bvh& bvh() const { return search().bvh; }
  const DualSurface& dual_surface() const { return search().dual_surface; }
  const std::vector<FeatureEdge>& features() const { return geometry_->features; }
  const IntersectionCurves& intersections(const Progress& progress = {}) const {
    return search(progress).intersections;
  }
  const Curvature& hatch_curvature(const Progress& progress = {}) const;
  const CrossField& field(const Progress& progress = {}) const;
  // Of the field, or of its diagonals: the family that stays where there is room for one. Found
  // when first asked for.
  const Families& families(const Progress& progress = {}) const;
  const Families& diagonal_families(const Progress& progress = {}) const;
  // Of each object, down to its radius, or the seeds alone (hatch/curves/object_curves.h). They
  // stay where they are.
  CurvesOfObjects hatch_curves(const std::vector<double>& radii,
                               const std::vector<std::uint8_t>& seeds_only = {},
                               const Progress& progress = {}) const;
  const CurvatureDerivative& curvature_derivative(const Progress& progress = {}) const;
  const SurfaceParts& parts() const {
    return geometry_->parts.get([&] { return surface_parts(surface()); });
  }

  const std::vector<MeshReport>& mesh_reports() const { return geometry_->mesh_reports; }
  Counts report() const;    // summed over all meshes
  Timings timings() const;  // seconds; only of what was made here, not of what was taken over

 private:
  // What every drawing asks for and the surface alone does not.
  struct Search {
    Bvh bvh;
    DualSurface dual_surface;
    IntersectionCurves intersections;
    Counts counts;
  };

  // Shared by all that were prepared from the same meshes with the same options; the trees point
  // into the surface.
  struct Geometry {
    Originals originals;
    std::vector<MeshReport> mesh_reports;
    Counts counts;
    // Of all objects; that of the originals where none is shared.
    std::shared_ptr<const Surface> surface;
    std::optional<const LimitSurface> limit_surface;
    std::vector<FeatureEdge> features;
    Lazy<Search> search;
    Lazy<SurfaceParts> parts;
  };

  void make_geometry(const std::vector<MeshPointer>& meshes, const Originals* last,
                     const Progress& progress);
  static void place_originals(Geometry& geometry);
  const Curvature& curvature_of_originals(const Progress& progress) const;
  bool shares_field() const;
  const Search& search(const Progress& progress = {}) const;
  bool has_surface_of(const std::vector<MeshPointer>& meshes, const PrepareOptions& options) const;
  void keep_first_areas(const Prepared& previous);
  void take_over(const Prepared& previous);
  CrossField solve_field(const Progress& progress) const;
  // What the field was solved on: of the originals where they share it.
  const std::shared_ptr<const Surface>& solved_surface() const {
    return shares_field() ? geometry_->originals.surface : geometry_->surface;
  }
  const Surface& originals() const { return *geometry_->originals.surface; }
  Families label_families(bool of_diagonals, const Progress& progress) const;
  Families label_on(const Surface& surface, const Curvature& curvature, const CrossField& field,
                    bool of_diagonals, const LastFamilies& last, const Progress& progress) const;
  const Families& placed_families(Lazy<Families>& solved, Lazy<Families>& placed_ones,
                                  bool of_diagonals, const Progress& progress) const;
  template <class Make>
  auto timed(const char* stage, Make&& make) const;

  void follow(const Prepared& previous);
  EarlierObjects earlier_of(const Prepared& previous, const LastFrame* before) const;
  CrossField solve_on(const Surface& surface, const Curvature& curvature, FieldAids aids,
                      const Progress& progress) const;

  PrepareOptions options_;
  std::vector<MeshPointer> meshes_;
  std::shared_ptr<Geometry> geometry_;
  // Of the originals (a guided field: of all objects), and where objects share them, of all.
  std::shared_ptr<Lazy<Curvature>> curvature_, placed_curvature_;
  std::shared_ptr<Lazy<CrossField>> field_, placed_field_;
  // The same of the families, and of those of the diagonals.
  std::shared_ptr<Lazy<Families>> families_, placed_families_;
  std::shared_ptr<Lazy<Families>> diagonal_families_, placed_diagonal_families_;
  // Each until that is made here.
  mutable HeldFrame last_curvature_, last_field_, last_families_, last_diagonal_families_;
  std::vector<double> first_areas_;  // (t) in the first frame of a mesh that deforms
  std::shared_ptr<Lazy<std::unique_ptr<ObjectCurves>>> hatch_curves_;
  std::shared_ptr<Lazy<CurvatureDerivative>> derivative_;
  mutable std::mutex timings_mutex_;
  mutable Timings timings_;
};

// Meshes to a surface, search trees and intersections (without options.field not above 500,000
// triangles), with options.field also hatching curvature and cross field. A mesh without faces
// contributes nothing but stays an object. `previous`: what was made from the same bytes with the
// same options is taken over, and of originals that rest or have moved as rigid bodies what was
// made of them (pipeline/originals.h); on objects that are the same (surface/same_objects.h) the
// search for the field starts from the last one, and families and seeds of hatches stay. Throws
// InvalidInput for arrays that do not fit together and for wrong options.
std::shared_ptr<const Prepared> prepare(const std::vector<MeshPointer>& meshes,
                                        const PrepareOptions& options,
                                        const Prepared* previous = nullptr,
                                        const Progress& progress = {});

}  // namespace illustrate
