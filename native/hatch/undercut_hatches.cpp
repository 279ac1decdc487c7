#include "hatch/undercut_hatches.h"

#include <algorithm>
#include <tuple>

#include "hatch/streamlines/cut_streamlines.h"
#include "hatch/streamlines/edge_seeds.h"
#include "hatch/streamlines/finish_streamlines.h"
#include "hatch/streamlines/grow_streamlines.h"
#include "hatch/streamlines/relax_streamlines.h"
#include "hatch/view/passable_triangles.h"

namespace illustrate {
namespace {

// In spacings of undercuts; what each step asks for is as in even_rules.h. Nothing is cut or
// thinned between the steps: in the dark, and between streamlines that stay, what is uneven shows
// less.
constexpr double least_length = 2;  // shorter ones are not worth a stroke
constexpr GrowRules gaps{0.7, 0.55, least_length};
constexpr GrowRules strips_left{0.75, 0.5, least_length};  // beside critical curves
constexpr double tip_step_test = 0.6, tip_test = 0.5;
constexpr double cut_test = 0.6;
constexpr int first_sweeps = 4, last_sweeps = 2;

bool has_undercuts(const ToneMap& tone) {
  return std::find(tone.band.begin(), tone.band.end(), Band::undercut) != tone.band.end();
}

// In an order that tells nothing of how they were placed: undercuts between streamlines that have
// stayed are then the same.
void fix_all(StreamlineSet& set) {
  const auto start = [](const Streamline& streamline) {
    const SurfacePoint& on = streamline.nodes.front().on;
    return std::make_tuple(on.triangle, on.b1, on.b2);
  };
  std::sort(set.streamlines.begin(), set.streamlines.end(),
            [&](const Streamline& a, const Streamline& b) { return start(a) < start(b); });
  for (Streamline& streamline : set.streamlines) streamline.is_fixed = true;
  set.rebuild();
}

}  // namespace

UndercutHatcher::UndercutHatcher(const HatchScene& scene, const HatchOptions& options)
    : scene_(scene), is_needed_(has_undercuts(scene.tone)), view_(scene, options, Area::undercut) {
  if (is_needed_) passable_ = passable_triangles(scene, Area::undercut);
}

SeedPlaces UndercutHatcher::places(const CurvesOfObjects& curves) const {
  return is_needed_ ? seed_places(scene_, view_, curves) : SeedPlaces();
}

void UndercutHatcher::add(Hatches& hatches, StreamlineSet& set, const HatchGroup& group,
                          int threads, const Progress& progress) const {
  if (!is_needed_) return;
  fix_all(set);
  const std::vector<StreamlineNode> seeds =
      surface_seeds(view_, group.curves, group.undercuts, passable_);
  fill_streamlines(set, view_, seeds, gaps, progress.part(0, 0.3));
  relax_streamlines(set, view_, first_sweeps, threads, progress.part(0.3, 0.6));
  const std::vector<StreamlineNode> strips = edge_seeds(set, view_, group.undercuts.strips);
  fill_streamlines(set, view_, strips, strips_left, progress.part(0.6, 0.8));
  extend_tips(set, view_, tip_step_test, tip_test);
  relax_streamlines(set, view_, last_sweeps, threads, progress.part(0.8, 1));
  cut_streamlines(set, view_, cut_test, least_length);
  hatches.add(finished(set.streamlines, view_));
}

}  // namespace illustrate
