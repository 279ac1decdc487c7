#include "hatch/undercut_hatches.h"

#include <algorithm>

#include "hatch/streamlines/cut_streamlines.h"
#include "hatch/streamlines/edge_seeds.h"
#include "hatch/streamlines/finish_streamlines.h"
#include "hatch/streamlines/grow_streamlines.h"
#include "hatch/streamlines/relax_streamlines.h"
#include "hatch/streamlines/surface_seeds.h"

namespace illustrate {
namespace {

// Shorter hatches are not worth a stroke, in spacings of undercuts.
constexpr double least = 2;

bool has_undercuts(const ToneMap& tone) {
  return std::find(tone.band.begin(), tone.band.end(), Band::undercut) != tone.band.end();
}

}  // namespace

UndercutHatcher::UndercutHatcher(const HatchScene& scene, const HatchOptions& options)
    : scene_(scene), is_needed_(has_undercuts(scene.tone)), view_(scene, options, Area::undercut) {}

std::vector<SurfacePoint> UndercutHatcher::strips() const {
  return is_needed_ ? edge_places(view_) : std::vector<SurfacePoint>();
}

void UndercutHatcher::add(Hatches& hatches, StreamlineSet& set, const HatchGroup& group,
                          int threads, const Progress& progress) const {
  if (!is_needed_) return;
  for (Streamline& streamline : set.streamlines) streamline.is_fixed = true;
  const std::vector<StreamlineNode> seeds = surface_seeds(scene_, view_, group.curves);
  fill_streamlines(set, view_, seeds, {0.7, 0.55, least}, progress.part(0, 0.3));
  relax_streamlines(set, view_, 4, threads, progress.part(0.3, 0.6));
  const std::vector<StreamlineNode> strips = edge_seeds(set, view_, group.strips.undercut);
  fill_streamlines(set, view_, strips, {0.75, 0.5, least}, progress.part(0.6, 0.8));
  extend_tips(set, view_, 0.6, 0.5);
  relax_streamlines(set, view_, 2, threads, progress.part(0.8, 1));
  cut_streamlines(set, view_, 0.6, least);
  hatches.add(finished(set.streamlines, view_));
}

}  // namespace illustrate
