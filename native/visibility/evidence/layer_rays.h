// Layers of surface in front of a curve, counted by a ray to the eye.
#pragma once

#include <map>

#include "contour/intersection/intersections.h"
#include "mesh/bvh.h"
#include "surface/surface.h"
#include "visibility/arrangement/arrangement.h"

namespace illustrate {

struct LayerCount {
  int layers;
  int unsure;           // more that are too near to be told from the curve's own surface
  int behind;           // all other hits of the line of sight
  bool beside_nothing;  // the line of sight meets no surface at all

  int before() const { return layers + unsure; }
};

class LayerRays {
 public:
  // insets: IntersectionCurves', or none.
  LayerRays(const Surface& surface, const Bvh& bvh, const Camera& camera, const Insets& insets)
      : surface_(surface), bvh_(bvh), camera_(camera), insets_(insets) {}

  // At an inner place of a strand. The ray starts a little to the side where the strand's own
  // surface is not, and takes no notice of what is nearer than the mesh can resolve: the contour
  // of a smooth object lies on the smooth surface, not on its triangles. What the curve touches
  // there, the floor below a wall, is in front or not as it is once both are moved (Insets); and so
  // is a sheet whose border lies along the strand, which the ray passes.
  LayerCount count(const Arrangement& arrangement, const StrandPlace& place);

  std::int64_t rays() const { return rays_; }
  // A copy asks on its own, and starts to count anew.
  LayerRays(const LayerRays& other)
      : LayerRays(other.surface_, other.bvh_, other.camera_, other.insets_) {}
  void add_count(const LayerRays& other) { rays_ += other.rays_; }

 private:
  // A place of a curve, and where it is once all is moved inward.
  struct Touching {
    Vec3 position, decided;
    bool is_of_two;   // an intersection, which lies on both its sheets wherever they are moved
    bool is_on_mesh;  // not interpolated
    int triangle;     // that it lies on
  };
  // Where a face is, seen from a curve, once all is moved: apart if it does not touch it at all,
  // open if that cannot be told, beside if the line of sight passes its rim.
  enum class Side { apart, open, before, behind, beside };
  // Of each part of the surface its hit that is nearest to where a ray starts.
  using SheetHits = std::map<int, RayHit>;

  bool is_interpolated(const Strand& strand, int triangle) const;
  int part(int triangle) const;
  void cast(const Vec3& origin);
  SheetHits near_sheets(const Vec3& origin, double blind) const;
  void add_adjoining_sheets(const SheetHits& outside, const SheetHits& inside,
                            const Touching& curve, LayerCount& count) const;
  LayerCount count_from(const Vec3& origin, double blind, const Touching& curve);
  bool lies_apart(int triangle, const Touching& curve) const;
  Side side_of_touch(int triangle, const Touching& curve) const;
  using Corners = std::array<Vec3, 3>;
  Corners moved_corners(int triangle) const;
  bool is_beyond_rim(int triangle, const Vec3& normal, const Vec3& p) const;
  Vec3 beside(const Vec3& p, const Vec2& along_px, double aside_px) const;
  double blind_distance(const Strand& strand, int triangle, const Vec3& p) const;

  const Surface& surface_;
  const Bvh& bvh_;
  const Camera& camera_;
  const Insets& insets_;
  std::vector<RayHit> hits_;
  std::int64_t rays_ = 0;
};

}  // namespace illustrate
