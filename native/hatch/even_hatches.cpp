#include "hatch/even_hatches.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hatch/broad_tone.h"
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

// How far beyond where they are wanted hatches are placed, in spacings: of the family that stays,
// and of the other one.
constexpr double midtone_margin = 8;
constexpr double shadow_margin = 3;

// (objects) world length of a spacing, on average over what is seen; 0 where nothing is seen and
// hatched.
std::vector<double> mean_spacings(const HatchScene& scene, double spacing_px) {
  const std::size_t objects = scene.surface.object_is_smooth.size();
  std::vector<double> sums(objects, 0), counts(objects, 0);
  int last = none;
  double spacing = 0;
  for (const int triangle : scene.visible.triangle) {
    if (triangle == none) continue;
    const int object = scene.surface.triangle_objects[idx(triangle)];
    if (!scene.is_hatched(object)) continue;
    if (triangle != last) {
      const Vec3& p = scene.surface.positions[idx(scene.surface.triangles[idx(triangle)][0])];
      spacing = scene.camera.pixel_size(p) * scene.spacing_on(object, spacing_px);
      last = triangle;
    }
    sums[idx(object)] += spacing;
    counts[idx(object)] += 1;
  }
  for (std::size_t i = 0; i < objects; ++i) sums[i] /= std::max(1.0, counts[i]);
  return sums;
}

std::size_t seed_count(double area, double spacing) {
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

void append(std::vector<StreamlineNode>& seeds, const std::vector<StreamlineNode>& more) {
  seeds.insert(seeds.end(), more.begin(), more.end());
}

// From places fixed on the surface; on objects so near that they lie too far apart, from the image
// too.
std::vector<StreamlineNode> all_seeds(const HatchScene& scene, const HatchView& view,
                                      const CurvesOfObjects& curves, double spacing_px) {
  const std::vector<double> spacings = mean_spacings(scene, spacing_px);
  std::vector<StreamlineNode> seeds;
  std::vector<std::uint8_t> is_near(curves.size(), 0);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (!curves[i]) continue;
    const std::size_t count = seed_count(curves[i]->area, spacings[i]);
    append(seeds, seed_nodes(view, curves[i]->seeds, count));
    is_near[i] = count > curves[i]->seeds.size();
  }
  if (std::find(is_near.begin(), is_near.end(), 1) == is_near.end()) return seeds;
  std::vector<SurfacePoint> places = lattice_places(scene, view, lattice_step * spacing_px);
  const auto is_far = [&](const SurfacePoint& on) {
    return !is_near[idx(scene.surface.triangle_objects[idx(on.triangle)])];
  };
  places.erase(std::remove_if(places.begin(), places.end(), is_far), places.end());
  append(seeds, seed_nodes(view, places, places.size()));
  return seeds;
}

// Of each object, one after another: none hinders another.
void place_surface_curves(StreamlineSet& set, const HatchView& view, const CurvesOfObjects& curves,
                          const Progress& progress) {
  const auto count = static_cast<double>(curves.size());
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const auto done = static_cast<double>(i);
    if (!curves[i]) continue;
    place_curves(set, view, curves[i]->curves, {}, progress.part(done / count, (done + 1) / count));
  }
}

// A drawing that stands alone.
void place_anew(StreamlineSet& set, const HatchView& view, const CurvesOfObjects& curves,
                const std::vector<StreamlineNode>& seeds, int threads, const Progress& progress) {
  place_surface_curves(set, view, curves, progress.part(0, 0.3));
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

std::vector<double> wanted_radii(const HatchScene& scene, const HatchOptions& options) {
  std::vector<double> radii = mean_spacings(scene, options.spacing_px);
  for (double& radius : radii) {
    radius = radius > 0 ? finest_radius * radius : std::numeric_limits<double>::infinity();
  }
  return radii;
}

Hatches even_hatches(const HatchScene& scene, const CurvesOfObjects& curves,
                     const Ragged<SurfacePoint>& first, const HatchOptions& options, int threads,
                     Counts& counts, const Progress& progress) {
  validate(options);
  validate(scene);
  progress.report(0);
  const ToneMap tone = broadened(scene.tone, midtone_margin * options.spacing_px,
                                 shadow_margin * options.spacing_px);
  const HatchView view({scene.surface, scene.field, scene.families, scene.camera, scene.visible,
                        tone, scene.graph, scene.curves, scene.spacing_scale, scene.unhatched},
                       options);
  const std::vector<StreamlineNode> seeds = all_seeds(scene, view, curves, options.spacing_px);
  StreamlineSet set(view);
  if (first.empty()) {
    place_anew(set, view, curves, seeds, threads, progress.part(0.1, 0.7));
  } else {
    place_after(set, view, first, seeds, threads, progress.part(0.1, 0.7));
  }
  finish_ends(set, view, seeds, threads, progress.part(0.7, 0.9));
  progress.report(0.9);
  Hatches hatches = finished(set.streamlines, HatchView(scene, options));
  fill_undercuts(hatches, scene, options, counts, progress.part(0.9, 1));
  counts["hatch_steps"] += set.steps;
  counts["hatches"] += static_cast<std::int64_t>(hatches.kinds.size());
  progress.report(1);
  return hatches;
}

}  // namespace illustrate
