// All points of placed hatches: whose they are, what tone they lie in, how far from an end.
#pragma once

#include "hatch/view/hatch_runs.h"
#include "hatch/view/hatch_scene.h"

namespace illustrate {

// Refers to the hatches and the scene. Points have their index in Hatches::curves.values.
class HatchPoints {
 public:
  HatchPoints(const Hatches& hatches, const HatchScene& scene, double spacing_px);

  int count() const { return static_cast<int>(owner_.size()); }
  int hatches() const { return static_cast<int>(hatches_.kinds.size()); }
  const HatchPoint& operator[](int point) const { return hatches_.curves.values[idx(point)]; }

  // Of a hatch.
  Run whole(int hatch) const {
    return {hatches_.curves.offsets[idx(hatch)], hatches_.curves.offsets[idx(hatch) + 1]};
  }
  bool is_undercut(int hatch) const { return hatches_.kinds[idx(hatch)] == Kind::undercut; }
  int object(int hatch) const { return hatches_.objects[idx(hatch)]; }
  double spacing(int hatch) const {  // px
    return scene_.spacing_on((*this)[whole(hatch).from].on.triangle, spacing_px_);
  }

  // Of a point: its hatch; its region, as points beyond all go with the one before, and a shadow
  // too short to cross anything in is the single region that the hatch goes on in; how far it is
  // from the nearer end of its hatch, in spacings, 0 in undercuts; which way its hatch runs there.
  int owner(int point) const { return owner_[idx(point)]; }
  Region region(int point) const { return region_[idx(point)]; }
  double to_end(int point) const { return to_end_[idx(point)]; }
  Vec3 tangent(int point) const;

  // Of a part of a hatch.
  Span<const HatchPoint> part(const Run& run) const {
    return {&hatches_.curves.values[idx(run.from)], idx(run.to - run.from)};
  }
  double length(const Run& run) const { return length_px(part(run)); }  // px
  bool any_in(const Run& run, Region region) const;
  bool all_in(const Run& run, Region region) const;

 private:
  void find_regions(int hatch);
  void pass_slight_shadows(int hatch);
  void measure_ends(int hatch);

  const Hatches& hatches_;
  const HatchScene& scene_;
  const double spacing_px_;
  std::vector<int> owner_;
  std::vector<Region> region_;
  std::vector<double> to_end_;
};

}  // namespace illustrate
