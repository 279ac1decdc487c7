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

// Seeds on the whole surface for each square of a spacing, seen face on, and the most of them.
constexpr double seeds_per_square = 4;
constexpr double most_seeds = 150'000;

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

std::vector<SurfacePoint> surface_seeds(const HatchScene& scene, double spacing_px) {
  const SurfaceSeeds all(scene.surface);
  const double spacing = mean_pixel(scene) * spacing_px;
  if (!(spacing > 0) || !(all.area() > 0)) return {};
  const double wanted = seeds_per_square * all.area() / (spacing * spacing);
  std::vector<SurfacePoint> seeds;
  for (std::size_t i = 0; i < static_cast<std::size_t>(std::min(wanted, most_seeds)); ++i) {
    seeds.push_back(all[i]);
  }
  return seeds;
}

// A drawing that stands alone.
void place_anew(StreamlineSet& set, const HatchView& view, const Ragged<SurfacePoint>& curves,
                const std::vector<SurfacePoint>& seeds, int threads, const Progress& progress) {
  place_curves(set, view, curves, {}, progress.part(0, 0.3));
  fill_streamlines(set, view, seeds, {0.9, 0.6, 1.5});
  merge_streamlines(set, view);
  progress.report(0.4);
  relax_streamlines(set, view, 5, threads);
  progress.report(0.7);
  cut_streamlines(set, view, 0.5, 1.5);
  extend_streamlines(set, view, 0.65);
  set.drop_shorter(view, 1.5);
  fill_streamlines(set, view, seeds, {0.75, 0.55, 1});
  merge_streamlines(set, view);
  relax_streamlines(set, view, 2, threads);
  cut_streamlines(set, view, 0.5, 1);
}

// A drawing that follows another.
void place_after(StreamlineSet& set, const HatchView& view, const Ragged<SurfacePoint>& first,
                 const std::vector<SurfacePoint>& seeds, int threads, const Progress& progress) {
  place_curves(set, view, first, {0.5, 0.5, 0.5}, progress.part(0, 0.3));
  extend_streamlines(set, view, 0.65);
  merge_streamlines(set, view);
  fill_streamlines(set, view, seeds, {0.75, 0.65, 1.5});
  progress.report(0.4);
  relax_streamlines(set, view, 4, threads);
  cut_streamlines(set, view, 0.5, 1);
}

// Right up to what ends the streamlines, and into what is left.
void finish_ends(StreamlineSet& set, const HatchView& view,
                 const std::vector<SurfacePoint>& seeds) {
  extend_tips(set, view, 0.7, 0.5);
  set.drop_shorter(view, 0.5);
  fill_streamlines(set, view, seeds, {0.75, 0.5, 0.75});
  extend_tips(set, view, 0.7, 0.5);
}

}  // namespace

Hatches even_hatches(const HatchScene& scene, const Ragged<SurfacePoint>& curves,
                     const Ragged<SurfacePoint>& first, const HatchOptions& options, int threads,
                     Counts& counts, const Progress& progress) {
  validate(options);
  validate_objects(scene.surface, scene.spacing_scale, scene.unhatched);
  progress.report(0);
  const HatchView view(scene.surface, scene.field, scene.camera, scene.visible, scene.tone,
                       scene.graph, scene.spacing_scale, scene.unhatched, options);
  const std::vector<SurfacePoint> seeds =
      seen_seeds(view, surface_seeds(scene, options.spacing_px));
  StreamlineSet set(view);
  if (first.empty()) {
    place_anew(set, view, curves, seeds, threads, progress.part(0.1, 0.7));
  } else {
    place_after(set, view, first, seeds, threads, progress.part(0.1, 0.7));
  }
  finish_ends(set, view, seeds);
  progress.report(0.9);
  Hatches hatches = finished(set.streamlines, view);
  fill_undercuts(hatches, scene.surface, scene.field, scene.camera, scene.visible, scene.tone,
                 scene.graph, scene.spacing_scale, scene.unhatched, options, counts,
                 progress.part(0.9, 1));
  counts["hatches"] += static_cast<std::int64_t>(hatches.kinds.size());
  progress.report(1);
  return hatches;
}

}  // namespace illustrate
