// Where hatches are wanted, and what is seen there.
#pragma once

#include <optional>

#include "hatch/view/hatch_runs.h"
#include "hatch/view/hatch_scene.h"

namespace illustrate {

// In which cells hatches may run.
enum class Area : std::uint8_t {
  hatched,   // midtones, shadows and undercuts, no Mach bands
  undercut,  // undercuts only
};

// The region that lies so far beyond the last of two points; nothing where a critical curve runs
// between.
std::optional<Region> region_beyond(const HatchScene& scene, const Vec2& before, const Vec2& last,
                                    double reach_px);

// (objects) 1: of which a cell is seen that hatches are wanted in.
std::vector<std::uint8_t> hatched_objects(const Surface& surface, const VisibleImage& visible,
                                          const ToneMap& tone);

class HatchArea {
 public:
  explicit HatchArea(const HatchScene& scene)
      : surface_(scene.surface),
        field_(scene.field),
        families_(scene.families),
        camera_(scene.camera),
        visible_(scene.visible),
        tone_(scene.tone),
        map_(image_map(scene.camera)),
        pixel_per_w_(scene.camera.pixel_per_w()) {}

  bool wanted(int cell, Area area) const {
    if (area == Area::hatched) return is_hatched(tone_, idx(cell));
    return region_of(tone_.level[idx(cell)], tone_.band[idx(cell)]) == Region::undercut;
  }

  // Whether a hatch may pass a point of the surface: in the frame, in a wanted cell, and not deeper
  // than everything that is seen around it. A point at the outline whose own cell is empty goes
  // with the cells around.
  bool may_pass(const HatchPoint& point, Area area) const;
  // The two halves of it: in the frame and not deeper than what is seen around; wanted there.
  bool is_seen(const HatchPoint& point) const;
  bool is_wanted(const HatchPoint& point, Area area) const;

  // Whether a hatch along a tangent may run where hatches are wanted: in shadows and undercuts both
  // families may, in midtones the one that stays; and so in undercuts where the two cross at less
  // than 50 degrees in the image: in a narrow band that is a scribble.
  bool suits(const HatchPoint& point, const Vec3& tangent) const {
    return (is_crossed(point.image) && !is_scribble(point, tangent)) ||
           kept_share(surface_, field_, families_, point.on, tangent) > 0;
  }

  // Before the near plane and inside the image.
  bool is_in_frame(const HatchPoint& point) const { return cell_in_frame(point) != none; }

  // World length of a pixel where the map takes a point to `mapped`.
  double pixel_size(const Vec3& mapped) const { return std::abs(mapped[2]) * pixel_per_w_; }

  // The triangle that is seen at an image point, `none` where hatches are not wanted.
  int wanted_triangle(const Vec2& image, Area area) const {
    const int cell = visible_.cell_of(image);
    return cell == none || !wanted(cell, area) ? none : visible_.triangle[idx(cell)];
  }

  // The visible point of the surface under an image point, `none` where nothing is seen.
  SurfacePoint visible_point(const Vec2& image) const;

 private:
  double cell_size(const Vec3& p) const { return visible_.cell_px * pixel_size(apply(map_, p)); }
  int cell_in_frame(const HatchPoint& point) const {
    return camera_.near_distance(point.position) > 0 ? visible_.cell_of(point.image) : none;
  }
  bool is_seen_at(int centre, const HatchPoint& point) const;
  // Whether a triangle seen there, or around it one of another object, is in front of a point.
  bool is_covered_at(int centre, const HatchPoint& point) const;
  bool passes_before(int triangle, const HatchPoint& point) const;
  bool is_crossed(const Vec2& image) const;
  bool is_scribble(const HatchPoint& point, const Vec3& tangent) const;
  bool is_wanted_at(int centre, const Vec2& image, Area area) const;
  template <class Test>
  bool any_around(const Vec2& image, const Test& test) const;

  const Surface& surface_;
  const CrossField& field_;
  const Families& families_;
  const Camera& camera_;
  const VisibleImage& visible_;
  const ToneMap& tone_;
  ImageMap map_;
  double pixel_per_w_;  // world length of a pixel, by the depth that the map gives
};

}  // namespace illustrate
