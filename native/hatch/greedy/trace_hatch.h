// One hatch: a walk both ways from its seed, until a rule ends it (paper section 6.4).
#pragma once

#include "hatch/greedy/neighbour_grid.h"
#include "hatch/greedy/place_hatches.h"
#include "hatch/view/critical_curves.h"
#include "hatch/view/hatch_area.h"
#include "hatch/view/walk.h"

namespace illustrate {

struct HatchSample {
  HatchPoint point;
  Vec3 tangent;  // unit, world, along the hatch
};
using HatchLine = std::vector<HatchSample>;

// What a hatch keeps to.
struct HatchRules {
  Area area = Area::hatched;
  double test_px = 0;  // least distance to parallel hatches
  double step_px = 1;
  double max_length_px = 1;
};

class Tracer {
 public:
  Tracer(const Surface& surface, const Walker& walker, const HatchArea& area,
         const CriticalCurves& curves, const NeighbourGrid& grid, const HatchOptions& options)
      : surface_(surface),
        walker_(walker),
        area_(area),
        curves_(curves),
        grid_(grid),
        options_(options) {}

  // From the seed along the branch of the cross nearest to `towards`, forwards and then backwards.
  HatchLine trace(const SurfacePoint& seed, const Vec3& towards, const HatchRules& rules) const;

  // Whether a parallel hatch passes a point nearer than `radius`, no critical curve between.
  bool is_near_parallel(const HatchSample& sample, double radius) const;

  std::int64_t steps() const { return steps_; }

 private:
  void extend(HatchLine& line, Walk walk, const HatchRules& rules, double& rest_px) const;
  bool closes_in(const HatchLine& line, const HatchSample& sample, const HatchRules& rules) const;

  const Surface& surface_;
  const Walker& walker_;
  const HatchArea& area_;
  const CriticalCurves& curves_;
  const NeighbourGrid& grid_;
  const HatchOptions& options_;
  mutable std::int64_t steps_ = 0;
};

}  // namespace illustrate
