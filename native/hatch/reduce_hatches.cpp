#include "hatch/reduce_hatches.h"

#include "hatch/reduction/reduced_strokes.h"
#include "hatch/reduction/seams.h"

namespace illustrate {

Hatches reduce_hatches(const Hatches& hatches, const HatchScene& scene, const HatchOptions& options,
                       Counts& counts) {
  validate(options);
  const HatchPoints points(hatches, scene, options.spacing_px);
  const std::vector<std::uint8_t> is_kept = kept_at_seams(points, scene, options.spacing_px);
  Hatches result = reduced_strokes(points, is_kept, scene, options.spacing_px);
  counts["hatches_after_reduction"] += static_cast<std::int64_t>(result.kinds.size());
  return result;
}

}  // namespace illustrate
