#include "pipeline/draw.h"

#include <algorithm>

#include "contour/shape/loose_curves.h"
#include "contour/silhouettes.h"
#include "core/errors.h"
#include "hatch/crumbs.h"
#include "hatch/even_hatches.h"
#include "hatch/reduce_hatches.h"
#include "hatch/view/hatch_runs.h"
#include "pipeline/hatch_passes.h"
#include "pipeline/last_drawing.h"
#include "pipeline/see_through.h"
#include "pipeline/stopwatch.h"
#include "pipeline/style_masks.h"
#include "stroke/tracks.h"
#include "visibility/loose_labels.h"

namespace illustrate {
namespace {

// The stages that finish one view, each with its time.
class Finisher {
 public:
  Finisher(const View& view, Detail detail)
      : view_(view),
        scene_(*view.scene),
        camera_(view.camera),
        options_(view.options),
        detail_(detail) {
    result_.counts = view.counts;
    result_.timings = view.timings;
  }

  void follow(const Drawing& previous, const Surface& whole) {
    if (!previous.surface) return;
    const SameObjects same(*previous.surface, whole,
                           objects_by_name(previous.object_names, names_of(scene_.meshes())));
    if (!same.any()) return;
    previous_ = scene_.seen_parts(moved_lines(placed_of(previous), same));
    last_drawn_ = drawn_hatches(previous, same);
    last_tiles_ = previous.tiles;
    follows_.assign(scene_.meshes().size(), 0);
    for (const SurfacePoint& on : previous_.values) {
      follows_[idx(scene_.surface().object_of(on.triangle))] = 1;
    }
  }

  void hatch(const Progress& progress) {
    if (!is_hatched_anywhere(view_.tone)) return;
    const CrossField& field = view_.prepared.field(progress.part(0, 0.1));
    const Families& families = scene_.families(progress.part(0.1, 0.2, "field"));
    const CriticalCurves curves = timed(result_.timings["hatch"], [&] {
      return CriticalCurves(view_.graph, camera_.width_px(), camera_.height_px());
    });
    const Mask unhatched = unhatched_objects(options_.styles);
    HatchScene whole{scene_.surface(),    field,      families,    camera_,
                     view_.visible,       view_.tone, view_.graph, curves,
                     view_.spacing_scale, unhatched};
    // Which pass a streamline is of nobody remembers: those of passes are evened out anew.
    if (view_.materials.groups.empty() && detail_ == Detail::whole) {
      tiles_ = timed(result_.timings["hatch"], [&] {
        return std::make_shared<const ImageTiles>(
            image_tiles(whole, options_.hatch, options_.threads));
      });
    }
    std::optional<RestingPlaces> resting;
    if (last_tiles_ && tiles_) whole.resting = &resting.emplace(*last_tiles_, *tiles_);
    std::optional<LastHatches> last;
    if (last_drawn_) {
      whole.last = &last.emplace(*last_drawn_, camera_, options_.hatch.spacing_px, whole.resting);
    }
    hatch_in_passes(whole, progress.part(0.2, 1));
  }

  DrawResult strokes(const Progress& progress) && {
    progress.report(0);
    result_.tone = view_.tone;
    result_.graph = with_loose_edges();
    const LineWeightOptions& weight = options_.stroke.line_weight;
    result_.drawing = timed(result_.timings["stroke"], [&] {
      StrokeStyles places{{},
                          view_.materials.hatch_widths,
                          pens_of(scene_.surface(), scene_.meshes(), options_.styles)};
      if (weight.any()) {
        places.line_widths = line_weights(result_.graph, scene_.surface(), scene_.bvh(), camera_,
                                          view_.lights, weight);
      }
      weigh_by_material(result_.graph, view_.materials, places.line_widths);
      return make_strokes(result_.graph, hatches_, result_.tone, camera_,
                          width_scales(options_.styles), undrawn_objects(options_.styles),
                          options_.stroke, places);
    });
    result_.counts["strokes"] = static_cast<std::int64_t>(result_.drawing.kinds.size());
    scene_.restore_triangles(result_.drawing.on);
    result_.drawing.placed = std::move(placed_);
    scene_.restore_triangles(result_.drawing.placed.values);
    result_.drawing.tiles = std::move(tiles_);
    progress.report(1);
    return std::move(result_);
  }

 private:
  // Edges of no face hide nothing, and no tone depends on them.
  LabelledGraph with_loose_edges() {
    return timed(result_.timings["visibility"], [&] {
      const Mask wanted = loose_objects(options_, scene_.meshes().size());
      return with_loose_curves(view_.graph, loose_curves(scene_.meshes(), wanted), scene_.surface(),
                               scene_.bvh(), camera_);
    });
  }

  // Once, or for each group of faces that is hatched by itself.
  void hatch_in_passes(const HatchScene& whole, const Progress& progress) {
    const std::vector<HatchPass> passes =
        hatch_passes(whole, view_.materials, [&](double group_scale) {
          std::vector<double> scales = spacing_scales(options_.styles);
          for (double& scale : scales) scale *= group_scale;
          return view_.small->finer(scales, options_.hatch);
        });
    std::vector<HatchScene> scenes;
    for (const HatchPass& pass : passes) scenes.push_back(scene_of(pass, whole));
    if (passes.empty()) scenes.push_back(whole);
    if (options_.hatch.seeding == HatchSeeding::surface_curves) {
      curves_ = scene_.hatch_curves(finest_radii(scenes, options_.hatch), follows_,
                                    progress.part(0, 0.15));
    }
    const Progress hatching = progress.part(0.15, 1, "hatch");
    const auto count = static_cast<double>(scenes.size());
    hatches_ = timed(result_.timings["hatch"], [&] {
      Hatches all;
      for (std::size_t i = 0; i < scenes.size(); ++i) {
        const auto done = static_cast<double>(i);
        all.add(hatched(scenes[i], passes.empty() ? previous_ : lines_of_pass(previous_, passes[i]),
                        hatching.part(done / count, (done + 1) / count)));
      }
      return all;
    });
  }

  Hatches hatched(const HatchScene& scene, const Ragged<SurfacePoint>& previous,
                  const Progress& progress) {
    const bool has_extra = options_.tone.extra_levels > 0;
    Hatches made = reduced(place(scene, previous, progress.part(0, has_extra ? 0.6 : 1)), scene);
    if (has_extra) add_extra(made, scene, progress.part(0.6, 1));
    return made;
  }

  // Hatches of the cross.
  Hatches place(const HatchScene& scene, const Ragged<SurfacePoint>& previous,
                const Progress& progress) {
    if (options_.hatch.seeding == HatchSeeding::critical_curves) {
      return place_hatches(scene, options_.hatch, result_.counts, progress);
    }
    const auto placing = detail_ == Detail::draft ? draft_hatches : even_hatches;
    const Hatches hatches = placing(scene, curves_.of_objects, previous, options_.hatch,
                                    options_.threads, result_.counts, progress);
    for (std::size_t c = 0; c < hatches.placed.size(); ++c) placed_.add(hatches.placed[c]);
    return hatches;
  }

  Hatches reduced(const Hatches& placed, const HatchScene& scene) {
    Hatches hatches = reduce_hatches(placed, scene, options_.hatch, result_.counts);
    if (options_.hatch.seeding == HatchSeeding::critical_curves) return hatches;
    mark_undercuts(hatches, scene.tone);
    return without_crumbs(hatches, scene, options_.hatch);
  }

  // The deeper levels of shadow are hatched once more, along the diagonals of the cross; by the
  // paper's own seeding, which needs no curves of the field's.
  void add_extra(Hatches& made, const HatchScene& scene, const Progress& progress) {
    const CrossField turned = diagonals(scene.surface, scene.field);
    const ToneMap tone = extra_tones(scene.tone);
    const Families& families = scene_.diagonal_families(progress.part(0, 0.2, "field"));
    const HatchScene deep{scene.surface,       turned,         families,    scene.camera,
                          scene.visible,       tone,           scene.graph, scene.curves,
                          scene.spacing_scale, scene.unhatched};
    Hatches extra =
        reduced(place_hatches(deep, options_.hatch, result_.counts, progress.part(0.2, 1)), deep);
    std::fill(extra.kinds.begin(), extra.kinds.end(), Kind::cross_hatch);
    made.add(extra);
  }

  const View& view_;
  const SeenScene& scene_;
  const Camera& camera_;
  const DrawOptions& options_;
  const Detail detail_;
  Ragged<SurfacePoint> previous_, placed_;
  std::optional<Ragged<Vec3>> last_drawn_;  // hatches
  std::vector<std::uint8_t> follows_;       // (objects) 1: has hatches of the last drawing
  std::shared_ptr<const ImageTiles> last_tiles_, tiles_;
  SeenCurves curves_;
  Hatches hatches_;
  DrawResult result_;
};

DrawResult finished(const View& view, const Progress& progress, const Drawing* previous,
                    Detail detail) {
  Finisher finisher(view, detail);
  if (detail != Detail::lines && anything_is_hatched(view.options)) {
    if (previous) finisher.follow(*previous, view.prepared.surface());
    finisher.hatch(progress.part(0, 0.9));
  }
  DrawResult result = std::move(finisher).strokes(progress.part(0.9, 1, "stroke"));
  if (view.glass) add_glass(result, finished(*view.glass, {}, nullptr, detail));
  return result;
}

}  // namespace

DrawResult draw(const View& view, const Progress& progress, const Drawing* previous,
                Detail detail) {
  DrawResult result = finished(view, progress, previous, detail);
  Drawing& drawing = result.drawing;
  drawing.surface = view.prepared.shared_surface();
  drawing.object_names = names_of(view.prepared.meshes());
  if (previous) {
    const Stopwatch watch;
    follow_strokes(drawing, *previous, *drawing.surface, view.camera, line_unit(view.camera));
    result.timings["stroke"] += watch.seconds();
  } else {
    drawing.tracks = first_tracks(drawing);
  }
  return result;
}

DrawResult draw(const Prepared& prepared, const Camera& camera, const DrawOptions& options,
                const std::vector<Light>& lights, const Progress& progress,
                const Drawing* previous) {
  return draw(view_of(prepared, camera, options, lights, progress.part(0, 0.6)),
              progress.part(0.6, 1), previous);
}

std::vector<int> silhouette_triangles(const Prepared& prepared, const Camera& camera,
                                      bool brute_force) {
  const Surface& surface = prepared.surface();
  const ContourFunctions functions(surface, camera);
  const DualSurface* dual = brute_force ? nullptr : &prepared.dual_surface();
  return find_silhouette_triangles(surface, functions, dual).triangles;
}

}  // namespace illustrate
