#include "hatch/even_hatches.h"

#include <algorithm>
#include <cmath>
#include <numeric>

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

// Of the lattice of the image that helps where seeds on the surface are too few, in spacings.
constexpr double lattice_step = 0.5;

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

// What is seen under a lattice of the image, in an order that spreads: steps of the golden ratio.
std::vector<SurfacePoint> lattice_places(const HatchScene& scene, const HatchView& view,
                                         double step_px) {
  const auto columns = static_cast<std::int64_t>(scene.camera.width_px() / step_px);
  const std::int64_t count =
      columns * static_cast<std::int64_t>(scene.camera.height_px() / step_px);
  auto stride = static_cast<std::int64_t>(0.6180339887498949 * static_cast<double>(count)) | 1;
  while (count > 0 && std::gcd(stride, count) != 1) stride += 2;
  std::vector<SurfacePoint> places;
  for (std::int64_t i = 0, at = 0; i < count; ++i, at = (at + stride) % count) {
    const Vec2 cell(static_cast<double>(at % columns), static_cast<double>(at / columns));
    const SurfacePoint on = view.area.visible_point((cell + Vec2(0.5, 0.5)) * step_px);
    if (on.triangle != none) places.push_back(on);
  }
  return places;
}

// From places fixed on the surface; so near that they lie too far apart, from the image too.
std::vector<StreamlineNode> all_seeds(const HatchScene& scene, const HatchView& view,
                                      const SurfaceCurves& curves, double spacing_px) {
  const std::size_t count = seed_count(scene, curves.area, spacing_px);
  std::vector<StreamlineNode> seeds = seed_nodes(view, curves.seeds, count);
  if (count <= curves.seeds.size()) return seeds;
  const std::vector<SurfacePoint> more = lattice_places(scene, view, lattice_step * spacing_px);
  const std::vector<StreamlineNode> nodes = seed_nodes(view, more, more.size());
  seeds.insert(seeds.end(), nodes.begin(), nodes.end());
  return seeds;
}

// A drawing that stands alone.
void place_anew(StreamlineSet& set, const HatchView& view, const Ragged<SurfacePoint>& curves,
                const std::vector<StreamlineNode>& seeds, int threads, const Progress& progress) {
  place_curves(set, view, curves, {}, progress.part(0, 0.3));
  fill_streamlines(set, view, seeds, {0.9, 0.6, 1.5}, progress.part(0.3, 0.4));
  merge_streamlines(set, view);
  relax_streamlines(set, view, 4, threads, progress.part(0.4, 0.7));
  cut_streamlines(set, view, 0.5, 1.5);
  progress.report(0.7);
  extend_streamlines(set, view, 0.65);
  set.drop_shorter(view, 1.5);
  fill_streamlines(set, view, seeds, {0.75, 0.55, 1}, progress.part(0.75, 0.8));
  merge_streamlines(set, view);
  relax_streamlines(set, view, 2, threads, progress.part(0.8, 1));
  cut_streamlines(set, view, 0.5, 1);
}

// A drawing that follows another: what was even moves little.
void place_after(StreamlineSet& set, const HatchView& view, const Ragged<SurfacePoint>& first,
                 const std::vector<StreamlineNode>& seeds, int threads, const Progress& progress) {
  place_curves(set, view, first, {0.5, 0.5, 0.5, true}, progress.part(0, 0.3));
  extend_streamlines(set, view, 0.65);
  merge_streamlines(set, view);
  fill_streamlines(set, view, seeds, {0.75, 0.65, 1.5}, progress.part(0.3, 0.4));
  for (int round = 0; round < 2; ++round) {
    progress.report(0.4 + 0.3 * round);
    if (round > 0) merge_streamlines(set, view);
    relax_streamlines(set, view, 1, threads);
    cut_streamlines(set, view, 0.5, 1);
  }
}

// Right up to what ends the streamlines, and into what is left.
void finish_ends(StreamlineSet& set, const HatchView& view,
                 const std::vector<StreamlineNode>& seeds, const Progress& progress) {
  progress.report(0);
  extend_tips(set, view, 0.72, 0.6);
  set.drop_shorter(view, 0.5);
  fill_streamlines(set, view, seeds, {0.77, 0.55, 0.75}, progress.part(0.3, 0.7));
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
  const std::vector<StreamlineNode> seeds = all_seeds(scene, view, curves, options.spacing_px);
  StreamlineSet set(view);
  if (first.empty()) {
    place_anew(set, view, curves.curves, seeds, threads, progress.part(0.1, 0.7));
  } else {
    place_after(set, view, first, seeds, threads, progress.part(0.1, 0.7));
  }
  finish_ends(set, view, seeds, progress.part(0.7, 0.9));
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
