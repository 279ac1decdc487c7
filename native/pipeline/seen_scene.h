// The part of a prepared scene that a drawing is made of: all objects but the ignored ones.
#pragma once

#include "pipeline/prepare.h"

namespace illustrate {

// The curves that hatches start from. They may be moved, not copied: some are `own`.
struct SeenCurves {
  SeenCurves() = default;
  SeenCurves(SeenCurves&&) = default;
  SeenCurves& operator=(SeenCurves&&) = default;

  CurvesOfObjects of_objects;
  std::vector<SurfaceCurves> own;  // (objects) with the numbers of a part of the scene
};

// Refers to `prepared` where nothing is ignored, else owns a copy without those triangles (vertices
// keep their numbers, so field and curvature still fit).
class SeenScene {
 public:
  SeenScene(const Prepared& prepared, const std::vector<ObjectStyle>& styles, int threads,
            const Progress& progress);

  const std::vector<MeshPointer>& meshes() const { return prepared_.meshes(); }
  const Surface& surface() const { return part_ ? part_->surface : prepared_.surface(); }
  const LimitSurface& limit_surface() const { return prepared_.limit_surface(); }
  const Bvh& bvh() const { return part_ ? part_->bvh : prepared_.bvh(); }
  const DualSurface& dual_surface(const Progress& progress) const {
    if (!part_) return prepared_.dual_surface();
    return part_->dual_surface.get([&] { return DualSurface(part_->surface, threads_, progress); });
  }
  const std::vector<FeatureEdge>& features() const {
    return part_ ? part_->features : prepared_.features();
  }
  const IntersectionCurves& intersections() const {
    return part_ ? part_->intersections : prepared_.intersections();
  }
  // Of vertices, which keep their numbers, like the two below.
  const CurvatureDerivative& curvature_derivative(const Progress& progress) const {
    return prepared_.curvature_derivative(progress);
  }

  const SurfaceParts& parts() const {
    if (!part_) return prepared_.parts();
    return part_->parts.get([&] { return surface_parts(part_->surface); });
  }

  const Families& families(const Progress& progress) const { return prepared_.families(progress); }
  const Families& diagonal_families(const Progress& progress) const {
    return prepared_.diagonal_families(progress);
  }

  // Curves on the whole surface, as far as their triangles are in this scene, with their numbers in
  // it.
  Ragged<SurfacePoint> seen_parts(const Ragged<SurfacePoint>& curves) const;
  // As those of the whole scene.
  SeenCurves hatch_curves(const std::vector<double>& radii,
                          const std::vector<std::uint8_t>& seeds_only,
                          const Progress& progress) const;

  // (t) what the triangles of this scene are in another one of the same, none: not there.
  std::vector<int> triangles_in(const SeenScene& other) const;

  // From triangles of this scene to those of `prepared`.
  void restore_triangles(std::vector<SurfacePoint>& points) const;

 private:
  struct Part {
    Surface surface;
    std::vector<int> sources;  // (t) triangle of the whole surface
    std::vector<int> numbers;  // (triangles of the whole surface) here, none for ignored ones
    Bvh bvh;
    Lazy<DualSurface> dual_surface;
    Lazy<SurfaceParts> parts;
    std::vector<FeatureEdge> features;
    IntersectionCurves intersections;
  };
  SurfaceCurves renumbered(const CurvesOfObject& whole) const;

  const Prepared& prepared_;
  int threads_;
  std::unique_ptr<Part> part_;
};

}  // namespace illustrate
