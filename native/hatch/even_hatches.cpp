#include "hatch/even_hatches.h"

#include <algorithm>
#include <cmath>

#include "hatch/cut_streamlines.h"
#include "hatch/finish_streamlines.h"
#include "hatch/grow_streamlines.h"
#include "hatch/merge_streamlines.h"
#include "hatch/place_curves.h"
#include "hatch/relax_streamlines.h"

namespace illustrate {
namespace {

// Seeds on the whole surface for each square of a spacing, seen face on.
constexpr double seeds_per_square = 3;

// World length of a pixel, on average over what is seen; 0 where nothing is.
double mean_pixel(const HatchScene& scene) {
  double sum = 0, count = 0;
  int last = none;
  for (const int triangle : scene.visible.triangle) {
    if (triangle == none || triangle == last) continue;
    last = triangle;
    const Vec3& p = scene.surface.positions[idx(scene.surface.triangles[idx(triangle)][0])];
    sum += scene.camera.pixel_size(p);
    count += 1;
  }
  return count > 0 ? sum / count : 0;
}

std::size_t seed_count(const HatchScene& scene, double area, double spacing_px) {
  const double spacing = mean_pixel(scene) * spacing_px;
  const double count = spacing > 0 ? seeds_per_square * area / (spacing * spacing) : 0;
  return static_cast<std::size_t>(std::min(count, 1e9));
}

// A drawing that stands alone.
void place_anew(StreamlineSet& set, const HatchView& view, const Ragged<SurfacePoint>& curves,
                const std::vector<StreamlineNode>& seeds, int threads, const Progress& progress) {
  place_curves(set, view, curves, {}, progress.part(0, 0.3));
  fill_streamlines(set, view, seeds, {0.9, 0.6, 1.5});
  merge_streamlines(set, view);
  progress.report(0.4);
  relax_streamlines(set, view, 4, threads);
  progress.report(0.7);
  cut_streamlines(set, view, 0.5, 1.5);
  extend_streamlines(set, view, 0.65);
  set.drop_shorter(view, 1.5);
  fill_streamlines(set, view, seeds, {0.75, 0.55, 1});
  merge_streamlines(set, view);
  relax_streamlines(set, view, 2, threads);
  cut_streamlines(set, view, 0.5, 1);
}

// A drawing that follows another: what was even moves little.
void place_after(StreamlineSet& set, const HatchView& view, const Ragged<SurfacePoint>& first,
                 const std::vector<StreamlineNode>& seeds, int threads, const Progress& progress) {
  place_curves(set, view, first, {0.5, 0.5, 0.5, true}, progress.part(0, 0.3));
  extend_streamlines(set, view, 0.65);
  merge_streamlines(set, view);
  fill_streamlines(set, view, seeds, {0.75, 0.65, 1.5});
  progress.report(0.4);
  for (int round = 0; round < 2; ++round) {
    if (round > 0) merge_streamlines(set, view);
    relax_streamlines(set, view, 1, threads);
    cut_streamlines(set, view, 0.5, 1);
  }
}

// Right up to what ends the streamlines, and into what is left.
void finish_ends(StreamlineSet& set, const HatchView& view,
                 const std::vector<StreamlineNode>& seeds) {
  extend_tips(set, view, 0.72, 0.6);
  set.drop_shorter(view, 0.5);
  fill_streamlines(set, view, seeds, {0.77, 0.55, 0.75});
  extend_tips(set, view, 0.72, 0.6);
}

}  // namespace

Hatches even_hatches(const HatchScene& scene, const SurfaceCurves& curves,
                     const Ragged<SurfacePoint>& first, const HatchOptions& options, int threads,
                     Counts& counts, const Progress& progress) {
  validate(options);
  validate_objects(scene.surface, scene.spacing_scale, scene.unhatched);
  progress.report(0);
  const HatchView view(scene.surface, scene.field, scene.camera, scene.visible, scene.tone,
                       scene.graph, scene.spacing_scale, scene.unhatched, options);
  const std::vector<StreamlineNode> seeds =
      seed_nodes(view, curves.seeds, seed_count(scene, curves.area, options.spacing_px));
  StreamlineSet set(view);
  if (first.empty()) {
    place_anew(set, view, curves.curves, seeds, threads, progress.part(0.1, 0.7));
  } else {
    place_after(set, view, first, seeds, threads, progress.part(0.1, 0.7));
  }
  finish_ends(set, view, seeds);
  progress.report(0.9);
  Hatches hatches = finished(set.streamlines, view);
  fill_undercuts(hatches, scene.surface, scene.field, scene.camera, scene.visible, scene.tone,
                 scene.graph, scene.spacing_scale, scene.unhatched, options, counts,
                 progress.part(0.9, 1));
  counts["hatch_steps"] += set.steps;
  counts["hatches"] += static_cast<std::int64_t>(hatches.kinds.size());
  progress.report(1);
  return hatches;
}

}  // namespace illustrate
