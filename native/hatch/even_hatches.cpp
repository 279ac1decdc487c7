#include "hatch/even_hatches.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "core/parallel.h"
#include "hatch/even_rules.h"
#include "hatch/streamlines/cut_streamlines.h"
#include "hatch/streamlines/edge_seeds.h"
#include "hatch/streamlines/even_planes.h"
#include "hatch/streamlines/finish_streamlines.h"
#include "hatch/streamlines/grow_streamlines.h"
#include "hatch/streamlines/hatch_groups.h"
#include "hatch/streamlines/merge_streamlines.h"
#include "hatch/streamlines/place_curves.h"
#include "hatch/streamlines/relax_streamlines.h"
#include "hatch/streamlines/surface_seeds.h"
#include "hatch/streamlines/thin_streamlines.h"
#include "hatch/undercut_hatches.h"
#include "hatch/view/broad_tone.h"
#include "hatch/view/hatch_area.h"
#include "hatch/view/passable_triangles.h"

namespace illustrate {
namespace {

// The curves of an object, on each part of it down to the radius that its spacing asks for.
Ragged<SurfacePoint> wanted_curves(const HatchView& view, const CurvesOfObject& object,
                                   double plain_spacing) {
  const Ragged<SurfacePoint> all = object.curves();
  Ragged<SurfacePoint> wanted;
  for (std::size_t c = 0; c < all.size(); ++c) {
    const double scale = view.scale_on(all[c][0].triangle);
    if (object.is_needed(c, even_rules.finest_radius * scale * plain_spacing)) wanted.add(all[c]);
  }
  return wanted;
}

// Of each object, one after another: none hinders another.
void place_surface_curves(StreamlineSet& set, const HatchView& view, const HatchGroup& group,
                          const Progress& progress) {
  const CurvesOfObjects& curves = group.curves;
  const auto count = static_cast<double>(curves.size());
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const auto done = static_cast<double>(i);
    if (!curves[i]) continue;
    place_curves(set, view, wanted_curves(view, curves[i], group.hatched.spacings[i]), {},
                 progress.part(done / count, (done + 1) / count));
  }
}

// A drawing that stands alone.
void place_anew(StreamlineSet& set, const HatchView& view, const HatchGroup& group,
                const std::vector<StreamlineNode>& seeds, int threads, const Progress& progress) {
  place_surface_curves(set, view, group, progress.part(0, 0.3));
  fill_streamlines(set, view, seeds, even_rules.wide_gaps(), progress.part(0.3, 0.4));
  merge_streamlines(set, view);
  relax_streamlines(set, view, even_rules.first_sweeps, threads, progress.part(0.4, 0.7));
  cut_streamlines(set, view, even_rules.cut_test, even_rules.first_least);
  progress.report(0.7);
  extend_streamlines(set, view, even_rules.extend_test);
  set.drop_shorter(even_rules.first_least);
  fill_streamlines(set, view, seeds, even_rules.gaps(), progress.part(0.75, 0.8));
  merge_streamlines(set, view);
  thin_streamlines(set, view, even_rules.first_thin);
  relax_streamlines(set, view, even_rules.last_sweeps, threads, progress.part(0.8, 1));
  even_planes(set, view);
  cut_streamlines(set, view, even_rules.cut_test, even_rules.last_least);
}

// A drawing that follows another: what was even moves little. Objects that have curves are new.
void place_after(StreamlineSet& set, const HatchView& view, const HatchGroup& group,
                 const std::vector<StreamlineNode>& seeds, int threads, const Progress& progress) {
  place_curves(set, view, group.first, even_rules.kept(), progress.part(0, 0.2));
  place_surface_curves(set, view, group, progress.part(0.2, 0.3));
  extend_streamlines(set, view, even_rules.extend_test);
  merge_streamlines(set, view);
  fill_streamlines(set, view, seeds, even_rules.new_gaps(), progress.part(0.3, 0.4));
  for (int round = 0; round < 2; ++round) {
    progress.report(0.4 + 0.3 * round);
    if (round > 0) merge_streamlines(set, view);
    relax_streamlines(set, view, 1, threads, {}, even_rules.least_move);
    // Once is enough to thin what is crowded; what is short stays as long as it does when placed.
    const double test = round == 0 ? even_rules.crowded_test : even_rules.cut_test;
    cut_streamlines(set, view, test, even_rules.kept_least);
  }
}

Ragged<SurfacePoint> places_of(const Streamlines& streamlines) {
  Ragged<SurfacePoint> places;
  for (const Streamline& streamline : streamlines) {
    for (const StreamlineNode& node : streamline.nodes) places.push(node.on);
    places.close_list();
  }
  return places;
}

Eigen::AlignedBox2d box_of(const std::vector<StreamlineNode>& nodes) {
  Eigen::AlignedBox2d box;
  for (const StreamlineNode& node : nodes) box.extend(node.image);
  return box;
}

// What the last drawing left free where nothing has changed stays free.
std::vector<StreamlineNode> without_resting(std::vector<StreamlineNode> seeds,
                                            const HatchView& view) {
  seeds.erase(std::remove_if(seeds.begin(), seeds.end(),
                             [&](const StreamlineNode& seed) { return view.rests(seed.image); }),
              seeds.end());
  return seeds;
}

// Right up to what ends the streamlines, and into what is left.
void finish_ends(StreamlineSet& set, const HatchView& view,
                 const std::vector<StreamlineNode>& seeds, const std::vector<SurfacePoint>& strips,
                 int threads, const Progress& progress) {
  progress.report(0);
  extend_tips(set, view, even_rules.tip_step_test, even_rules.tip_test);
  merge_streamlines(set, view, true);
  set.drop_shorter(even_rules.least_tip);
  fill_streamlines(set, view, seeds, even_rules.rests(), progress.part(0.3, 0.6));
  fill_streamlines(set, view, without_resting(edge_seeds(set, view, strips), view),
                   even_rules.strips(), progress.part(0.6, 0.9));
  merge_streamlines(set, view, true);
  thin_streamlines(set, view, even_rules.last_thin);
  extend_tips(set, view, even_rules.tip_step_test, even_rules.tip_test);
  merge_streamlines(set, view, true);
  straighten_joined(set, view, 2, threads);
}

// A view in which hatches are placed: where they are wanted, and some spacings around that.
struct PlacingView {
  PlacingView(const HatchScene& scene, const HatchOptions& options)
      : tone(broadened(scene.tone, even_rules.midtone_margin * options.spacing_px,
                       even_rules.shadow_margin * options.spacing_px)),
        view({scene.surface, scene.field, scene.families, scene.camera, scene.visible, tone,
              scene.graph, scene.curves, scene.spacing_scale, scene.unhatched, nullptr,
              scene.resting},
             options) {}

  const ToneMap tone;
  const HatchView view;
};

// Hatches groups of objects of one view, each as if it were alone.
class GroupHatcher {
 public:
  // follows: the view continues another drawing.
  GroupHatcher(const HatchScene& scene, const HatchOptions& options, bool follows)
      : scene_(scene),
        options_(options),
        follows_(follows),
        placing_(scene, options),
        passable_(passable_triangles(view_.scene(), Area::hatched)),
        undercuts_(scene, options) {}

  // What all objects have of the view.
  HatchGroup all(const CurvesOfObjects& curves, const Ragged<SurfacePoint>& first) const {
    return {curves, first, seed_places(scene_, view_, curves), undercuts_.places(curves)};
  }

  Hatches hatches(const HatchGroup& group, int threads, std::atomic<std::int64_t>& steps,
                  const Progress& progress) const {
    std::vector<StreamlineNode> seeds =
        surface_seeds(view_, group.curves, group.hatched, passable_);
    StreamlineSet set(view_, box_of(seeds));
    seeds = without_resting(std::move(seeds), view_);
    const Progress placing = progress.part(0.1, 0.7);
    if (follows_) {
      place_after(set, view_, group, seeds, threads, placing);
    } else {
      place_anew(set, view_, group, seeds, threads, placing);
    }
    finish_ends(set, view_, seeds, group.hatched.strips, threads, progress.part(0.7, 0.9));
    progress.report(0.9);
    Hatches hatches = finished(set.streamlines, HatchView(scene_, options_));
    hatches.placed = places_of(set.streamlines);
    undercuts_.add(hatches, set, group, threads, progress.part(0.9, 1));
    steps += set.steps;
    return hatches;
  }

 private:
  const HatchScene& scene_;
  const HatchOptions& options_;
  const bool follows_;
  const PlacingView placing_;
  const HatchView& view_ = placing_.view;
  const std::vector<std::uint8_t> passable_;
  const UndercutHatcher undercuts_;
};

// The hatches of all objects, of which make(group, threads, progress) makes those of a group. Adds
// "hatches" to `counts`.
template <class Make>
Hatches of_groups(const HatchScene& scene, HatchGroup all, int threads, Counts& counts,
                  const Progress& progress, const Make& make) {
  const std::vector<HatchGroup> groups = hatch_groups(scene, std::move(all));
  std::vector<Hatches> made(groups.size());
  parallel_parts(std::vector<std::size_t>(groups.size(), 1), {}, threads, progress,
                 [&](std::size_t g, int of_group, const Progress& part) {
                   made[g] = make(groups[g], of_group, part);
                 });
  Hatches hatches = joined(std::move(made));
  counts["hatches"] += static_cast<std::int64_t>(hatches.kinds.size());
  progress.report(1);
  return hatches;
}

}  // namespace

std::vector<double> wanted_radii(const HatchScene& scene, const HatchOptions& options) {
  std::vector<double> radii = object_spacings(scene, options.spacing_px).least;
  const std::vector<std::uint8_t> hatched =
      hatched_objects(scene.surface, scene.visible, scene.tone);
  for (std::size_t i = 0; i < radii.size(); ++i) {
    const bool is_wanted = radii[i] > 0 && hatched[i] != 0;
    radii[i] =
        is_wanted ? even_rules.finest_radius * radii[i] : std::numeric_limits<double>::infinity();
  }
  return radii;
}

Hatches even_hatches(const HatchScene& scene, const CurvesOfObjects& curves,
                     const Ragged<SurfacePoint>& first, const HatchOptions& options, int threads,
                     Counts& counts, const Progress& progress) {
  validate(options);
  validate(scene);
  progress.report(0);
  const GroupHatcher hatcher(scene, options, !first.empty());
  std::atomic<std::int64_t> steps{0};
  Hatches hatches = of_groups(scene, hatcher.all(curves, first), threads, counts, progress,
                              [&](const HatchGroup& group, int of_group, const Progress& part) {
                                return hatcher.hatches(group, of_group, steps, part);
                              });
  counts["hatch_steps"] += steps;
  return hatches;
}

Hatches draft_hatches(const HatchScene& scene, const CurvesOfObjects& curves,
                      const Ragged<SurfacePoint>& first, const HatchOptions& options, int threads,
                      Counts& counts, const Progress& progress) {
  validate(options);
  validate(scene);
  progress.report(0);
  const PlacingView placing(scene, options);
  const SeedPlaces places{object_spacings(scene, options.spacing_px).plain, {}, {}};
  const auto draft = [&](const HatchGroup& group, int, const Progress& part) {
    StreamlineSet set(placing.view);
    place_curves(set, placing.view, group.first, even_rules.kept(), part.part(0, 0.3));
    place_surface_curves(set, placing.view, group, part.part(0.3, 0.9));
    return finished(set.streamlines, HatchView(scene, options));
  };
  return of_groups(scene, {curves, first, places, {}}, threads, counts, progress, draft);
}

}  // namespace illustrate
