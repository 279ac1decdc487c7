// Undercuts are dark: hatches between those that run through them.
#pragma once

#include "core/progress.h"
#include "hatch/streamlines/hatch_groups.h"
#include "hatch/streamlines/streamline_set.h"

namespace illustrate {

class UndercutHatcher {
 public:
  // Refers to both.
  UndercutHatcher(const HatchScene& scene, const HatchOptions& options);

  // Nothing where nothing is undercut.
  SeedPlaces places(const CurvesOfObjects& curves) const;

  // Adds hatches of kind undercut to `hatches`, in undercuts only, evened out between the
  // streamlines of `set`, which they were made of: about undercut_spacing_px from each other and
  // from these, of both families. As elsewhere they are long and even; the shortest are `least` of
  // the source. `set` ends with them, its own streamlines as they were.
  void add(Hatches& hatches, StreamlineSet& set, const HatchGroup& group, int threads,
           const Progress& progress) const;

 private:
  const HatchScene& scene_;
  const bool is_needed_;
  const HatchView view_;
  std::vector<std::uint8_t> passable_;  // (t) passable_triangles.h
};

}  // namespace illustrate
