// Walking along the cross field over the triangles of the surface.
#pragma once

#include "hatch/curves/field_walk.h"
#include "hatch/hatches.h"
#include "view/image_map.h"

namespace illustrate {

// A place on the surface, and where the walk goes: a unit tangent. `facing` is +1 where the normal
// of the sheet points to the eye.
struct Walk {
  SurfacePoint on;
  Vec3 tangent;
  double facing = 1;
};

enum class WalkEnd : std::uint8_t {
  whole,       // the whole length was walked
  edge,        // boundary, crease, or a triangle without area
  silhouette,  // the surface turns away from the eye here
};

// A FieldWalker whose lengths are those of the image, and which stops at silhouettes.
class Walker {
 public:
  Walker(const Surface& surface, const CrossField& field, const Camera& camera);

  // At a place, along the branch of the cross nearest to `towards`.
  Walk start(const SurfacePoint& on, const Vec3& towards) const;
  // The same the other way.
  static Walk turned(Walk walk);

  // Moves `walk` by `length_px` of the image, or up to where the walk ends.
  WalkEnd advance(Walk& walk, double length_px) const;

  HatchPoint point(const SurfacePoint& on) const;
  // How a world direction at p shows in the image, px per world unit.
  Vec2 image_direction(const Vec3& p, const Vec3& direction) const {
    const Vec3 mapped = apply(map_, p);
    return illustrate::image_direction(map_, mapped.head<2>() / mapped[2], mapped[2], direction);
  }
  const ImageMap& map() const { return map_; }
  const FieldWalker& on_surface() const { return walker_; }
  // Asks for what is known of the surface there, before it is needed.
  void fetch(const SurfacePoint& on) const;
  // The same of the place some places behind one, in a loop over all of them.
  template <class Places>
  void fetch_ahead(const Places& places, std::size_t place) const {
    constexpr std::size_t ahead = 6;
    if (place + ahead < places.size()) fetch(places[place + ahead]);
  }
  // Positive where the front of the triangle's sheet is seen, 0 on the silhouette.
  double facing_at(const SurfacePoint& on) const;

 private:
  double px_along(const SurfacePoint& on, const Vec3& direction) const;

  FieldWalker walker_;
  const Surface& surface_;
  const Camera& camera_;
  ImageMap map_;
  std::vector<double> front_;  // (n) normal . to_eye: positive where a vertex faces the eye
};

}  // namespace illustrate
