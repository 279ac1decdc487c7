#include "hatch/undercut_hatches.h"

#include <algorithm>

#include "hatch/cut_streamlines.h"
#include "hatch/edge_seeds.h"
#include "hatch/finish_streamlines.h"
#include "hatch/grow_streamlines.h"
#include "hatch/relax_streamlines.h"
#include "hatch/surface_seeds.h"

namespace illustrate {
namespace {

// Shorter hatches are not worth a stroke, in spacings of undercuts.
constexpr double least = 2;

bool has_undercuts(const ToneMap& tone) {
  return std::find(tone.band.begin(), tone.band.end(), Band::undercut) != tone.band.end();
}

}  // namespace

void add_undercuts(Hatches& hatches, StreamlineSet& set, const HatchScene& scene,
                   const CurvesOfObjects& curves, const HatchOptions& options, int threads,
                   const Progress& progress) {
  if (!has_undercuts(scene.tone)) return;
  const HatchView view(scene, options, Area::undercut);
  for (Streamline& streamline : set.streamlines) streamline.is_fixed = true;
  const std::vector<StreamlineNode> seeds = surface_seeds(scene, view, curves);
  fill_streamlines(set, view, seeds, {0.7, 0.55, least}, progress.part(0, 0.3));
  relax_streamlines(set, view, 4, threads, progress.part(0.3, 0.6));
  fill_streamlines(set, view, edge_seeds(set, view), {0.75, 0.5, least}, progress.part(0.6, 0.8));
  extend_tips(set, view, 0.6, 0.5);
  relax_streamlines(set, view, 2, threads, progress.part(0.8, 1));
  cut_streamlines(set, view, 0.6, least);
  const Hatches found = finished(set.streamlines, view);
  for (std::size_t h = 0; h < found.kinds.size(); ++h) {
    hatches.add(found.curves[h], found.kinds[h], found.objects[h]);
  }
}

}  // namespace illustrate
