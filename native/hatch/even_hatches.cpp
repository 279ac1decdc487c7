#include "hatch/even_hatches.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hatch/cut_streamlines.h"
#include "hatch/edge_seeds.h"
#include "hatch/finish_streamlines.h"
#include "hatch/grow_streamlines.h"
#include "hatch/image_lattice.h"
#include "hatch/merge_streamlines.h"
#include "hatch/place_curves.h"
#include "hatch/relax_streamlines.h"
#include "hatch/thin_streamlines.h"

namespace illustrate {
namespace {

// Seeds on the whole surface for each square of a spacing, seen face on.
constexpr double seeds_per_square = 3;

// Of the curves that a view starts from; finer ones would find no room. In spacings.
constexpr double finest_radius = 0.8;

// Of the lattice of the image that helps where seeds on the surface are too few, in spacings.
constexpr double lattice_step = 0.5;

// World length of a spacing, on average over what is seen and hatched; 0 where nothing is.
double mean_spacing(const HatchScene& scene, double spacing_px) {
  const VisibleImage& visible = scene.visible;
  const int step = std::max(1, static_cast<int>(spacing_px / visible.cell_px));
  double sum = 0, count = 0;
  for (int row = step / 2; row < visible.height; row += step) {
    for (int column = step / 2; column < visible.width; column += step) {
      const int triangle = visible.triangle[idx(visible.index(column, row))];
      if (triangle == none) continue;
      const int object = scene.surface.triangle_objects[idx(triangle)];
      if (!scene.is_hatched(object)) continue;
      const Vec3& p = scene.surface.positions[idx(scene.surface.triangles[idx(triangle)][0])];
      sum += scene.camera.pixel_size(p) * scene.spacing_on(object, spacing_px);
      count += 1;
    }
  }
  return count > 0 ? sum / count : 0;
}

std::size_t seed_count(const HatchScene& scene, double area, double spacing_px) {
  const double spacing = mean_spacing(scene, spacing_px);
  const double count = spacing > 0 ? seeds_per_square * area / (spacing * spacing) : 0;
  return static_cast<std::size_t>(std::min(count, 1e9));
}

// What is seen under a lattice of the image.
std::vector<SurfacePoint> lattice_places(const HatchScene& scene, const HatchView& view,
                                         double step_px) {
  std::vector<SurfacePoint> places;
  visit_lattice(scene.camera.width_px(), scene.camera.height_px(), step_px,
                [&](std::int64_t, const Vec2& image) {
                  const SurfacePoint on = view.area.visible_point(image);
                  if (on.triangle != none) places.push_back(on);
                });
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
  relax_streamlines(set, view, 5, threads, progress.part(0.4, 0.7));
  cut_streamlines(set, view, 0.5, 1.5);
  progress.report(0.7);
  extend_streamlines(set, view, 0.65);
  set.drop_shorter(1.5);
  fill_streamlines(set, view, seeds, {0.75, 0.55, 1}, progress.part(0.75, 0.8));
  merge_streamlines(set, view);
  thin_streamlines(set, view, 1.1);
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
                 const std::vector<StreamlineNode>& seeds, int threads, const Progress& progress) {
  progress.report(0);
  extend_tips(set, view, 0.7, 0.59);
  merge_streamlines(set, view);
  set.drop_shorter(0.5);
  fill_streamlines(set, view, seeds, {0.77, 0.55, 0.75}, progress.part(0.3, 0.6));
  fill_streamlines(set, view, edge_seeds(set, view), {0.75, 0.5, 0.4}, progress.part(0.6, 0.9));
  merge_streamlines(set, view);
  thin_streamlines(set, view, 1);
  extend_tips(set, view, 0.7, 0.59);
  merge_streamlines(set, view);
  straighten_joined(set, view, 2, threads);
}

}  // namespace

double wanted_radius(const HatchScene& scene, const HatchOptions& options) {
  const double spacing = mean_spacing(scene, options.spacing_px);
  return spacing > 0 ? finest_radius * spacing : std::numeric_limits<double>::infinity();
}

Hatches even_hatches(const HatchScene& scene, const SurfaceCurves& curves,
                     const Ragged<SurfacePoint>& first, const HatchOptions& options, int threads,
                     Counts& counts, const Progress& progress) {
  validate(options);
  validate(scene);
  progress.report(0);
  const HatchView view(scene, options);
  const std::vector<StreamlineNode> seeds = all_seeds(scene, view, curves, options.spacing_px);
  StreamlineSet set(view);
  if (first.empty()) {
    place_anew(set, view, curves.curves, seeds, threads, progress.part(0.1, 0.7));
  } else {
    place_after(set, view, first, seeds, threads, progress.part(0.1, 0.7));
  }
  finish_ends(set, view, seeds, threads, progress.part(0.7, 0.9));
  progress.report(0.9);
  Hatches hatches = finished(set.streamlines, view);
  fill_undercuts(hatches, scene, options, counts, progress.part(0.9, 1));
  counts["hatch_steps"] += set.steps;
  counts["hatches"] += static_cast<std::int64_t>(hatches.kinds.size());
  progress.report(1);
  return hatches;
}

}  // namespace illustrate
