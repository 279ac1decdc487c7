#include "pipeline/draw.h"

#include <algorithm>
#include <cmath>

#include "contour/network/network.h"
#include "contour/shape/loose_curves.h"
#include "contour/silhouettes.h"
#include "core/errors.h"
#include "hatch/crumbs.h"
#include "hatch/even_hatches.h"
#include "hatch/reduce_hatches.h"
#include "hatch/small_parts.h"
#include "hatch/view/hatch_runs.h"
#include "occlusion/visible_image.h"
#include "pipeline/casters.h"
#include "pipeline/hatch_passes.h"
#include "pipeline/last_drawing.h"
#include "pipeline/material_styles.h"
#include "pipeline/see_through.h"
#include "pipeline/seen_scene.h"
#include "pipeline/stopwatch.h"
#include "pipeline/style_masks.h"
#include "stroke/tracks.h"
#include "tone/light_contours.h"
#include "visibility/label_network.h"
#include "visibility/loose_labels.h"
#include "visibility/vote.h"

namespace illustrate {
namespace {

// What is decided in the image (how near to cusps points are exact, what is a twist, how far beside
// a curve rays start) is so in units of paper, of which the larger side of the image has so many:
// lines, and the hatches that end at them, are then the same at any number of pixels. In images of
// over 4096 px it has more: what a unit leaves out is to stay near the size of a pixel.
constexpr double units_across = 1024;
constexpr double most_pixels = 4;  // of a unit

// Of the tone map. So many cells take some 300 MB, depths and tones together.
constexpr double most_cells = 16e6;
constexpr double least_cell_px = 0.25;
constexpr double cells_in_spacing = 8;
constexpr double cells_in_band = 6;

// In proportion to hatches and bands: tones then look the same at any number of pixels.
double cell_size(const Camera& camera, const DrawOptions& options) {
  const ToneOptions& tone = options.tone;
  double cell = std::min(options.cell_px, options.hatch.spacing_px / cells_in_spacing);
  if (tone.mach_bands && tone.mach_band_px > 0) {
    cell = std::min(cell, tone.mach_band_px / cells_in_band);
  }
  if (tone.undercuts && tone.undercut_px > 0) {
    cell = std::min(cell, tone.undercut_px / cells_in_band);
  }
  const double area = static_cast<double>(camera.width_px()) * camera.height_px();
  return std::max({cell, least_cell_px, std::sqrt(area / most_cells)});
}

// Pixels of the unit in which lines are decided.
double line_unit(const Camera& camera) {
  return std::min(std::max(camera.width_px(), camera.height_px()) / units_across, most_pixels);
}

// From images in units to pixels.
void to_pixels(LabelledGraph& graph, double unit) {
  for (GraphNode& node : graph.nodes) node.image *= unit;
  for (Vec2& image : graph.image.values) image *= unit;
  graph.repair_max_px *= unit;
  graph.unit_px = unit;
}

// The stages of one view, each with its time.
class View {
 public:
  // casters: what keeps the light from the scene.
  View(const SeenScene& scene, const SeenScene& casters, const Camera& camera,
       const DrawOptions& options)
      : scene_(scene),
        casters_(casters),
        camera_(camera),
        options_(options),
        materials_(material_marks(scene.surface(), scene.meshes(), options.styles)) {
    result_.timings = {{"contour", 0}, {"visibility", 0}, {"tone", 0}, {"hatch", 0}, {"stroke", 0}};
  }

  void label_curves(const std::vector<Light>& lights, const Progress& progress) {
    const StrokeOptions& stroke = options_.stroke;
    const bool by_vote = options_.visibility == VisibilityMethod::vote;
    // The vote is there for comparison: it gets all curves, also those that are hidden for certain.
    const NetworkOptions network_options{stroke.marks,
                                         stroke.materials,
                                         stroke.flat_outlines,
                                         options_.curvature_curves,
                                         !stroke.hidden_lines && !by_vote,
                                         options_.threads};
    const double unit = line_unit(camera_);
    const Camera on_paper = camera_.in_units_of(unit);
    const Progress search = progress.part(0, 0.2, "contour");
    ContourScene contour_scene = contour_scene_of(scene_, search);
    if (options_.curvature_curves.any()) {
      contour_scene.derivative = &scene_.curvature_derivative(progress.part(0.2, 0.3));
    }
    const CurveNetwork network = timed(result_.timings["contour"], [&] {
      FreeLines of_light;
      if (options_.light_contours.any()) {
        of_light = lines_of_light(contour_scene, lights, search);
        contour_scene.light_contours = &of_light;
      }
      return build_network(contour_scene, on_paper, network_options, result_.counts,
                           progress.part(0.3, 0.6, "contour"));
    });
    result_.graph = timed(result_.timings["visibility"], [&] {
      const Progress visibility = progress.part(0.6, 1, "visibility");
      return by_vote
                 ? vote_network(network, scene_.surface(), scene_.bvh(), on_paper, result_.counts,
                                visibility)
                 : label_network(network, scene_.surface(), scene_.bvh(), on_paper, result_.counts,
                                 visibility, options_.threads, scene_.intersections().insets);
    });
    to_pixels(result_.graph, unit);
  }

  // Edges of no face hide nothing, and no tone depends on them.
  void add_loose_edges() {
    result_.graph = timed(result_.timings["visibility"], [&] {
      const Mask wanted = loose_objects(options_, scene_.meshes().size());
      return with_loose_curves(std::move(result_.graph), loose_curves(scene_.meshes(), wanted),
                               scene_.surface(), scene_.bvh(), camera_);
    });
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

  void hatch(const CrossField& field, const std::vector<Light>& lights, const Progress& progress) {
    const Surface& surface = scene_.surface();
    const Progress tone_progress = progress.part(0, 0.2, "tone");
    tone_progress.report(0);
    const VisibleImage visible = timed(result_.timings["tone"], [&] {
      return render_visible(surface, camera_, cell_size(camera_, options_), {}, options_.threads);
    });
    ToneOptions tone_options = options_.tone;
    tone_options.threads = options_.threads;
    tone_options.patch_px = options_.smallest_tone * options_.hatch.spacing_px;
    const Mask unhatched = unhatched_objects(options_.styles);
    const SmallParts small(surface, scene_.parts(), camera_);
    const std::vector<float> spacing_scale =
        small.finer(spacing_scales(options_.styles), options_.hatch);
    const Lightness lightness(surface, scene_.meshes());
    result_.tone = timed(result_.timings["tone"], [&] {
      ToneMap tone =
          tone_regions({surface, visible, result_.graph, camera_, lights, &casters_.bvh(),
                        unhatched, shadow_catchers(options_.styles), &lightness, &scene_.parts()},
                       tone_options, tone_progress);
      blank_unhatched(visible, materials_.unhatched, tone);
      blank_unhatched(visible, small.too_narrow(spacing_scale, options_.hatch), tone);
      return tone;
    });
    if (!is_hatched_anywhere(result_.tone)) return;
    const Families& families = scene_.families(progress.part(0.2, 0.3, "field"));
    const CriticalCurves curves = timed(result_.timings["hatch"], [&] {
      return CriticalCurves(result_.graph, camera_.width_px(), camera_.height_px());
    });
    HatchScene whole{surface,      field,         families, camera_,       visible,
                     result_.tone, result_.graph, curves,   spacing_scale, unhatched};
    // Which pass a streamline is of nobody remembers: those of passes are evened out anew.
    if (materials_.groups.empty()) {
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
    hatch_in_passes(whole, small, progress.part(0.3, 1));
  }

  DrawResult strokes(const std::vector<Light>& lights, const Progress& progress) && {
    progress.report(0);
    const LineWeightOptions& weight = options_.stroke.line_weight;
    result_.drawing = timed(result_.timings["stroke"], [&] {
      StrokeStyles places{
          {}, materials_.hatch_widths, pens_of(scene_.surface(), scene_.meshes(), options_.styles)};
      if (weight.any()) {
        places.line_widths =
            line_weights(result_.graph, scene_.surface(), scene_.bvh(), camera_, lights, weight);
      }
      weigh_by_material(result_.graph, materials_, places.line_widths);
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
  ContourScene contour_scene_of(const SeenScene& scene, const Progress& progress) const {
    return {scene.surface(), scene.limit_surface(), scene.features(), scene.intersections(),
            options_.scan_silhouettes ? nullptr : &scene.dual_surface(progress)};
  }

  FreeLines lines_of_light(const ContourScene& seen, const std::vector<Light>& lights,
                           const Progress& progress) const {
    const auto lines = [&](const LightCasters& casters) {
      return light_contours(seen, casters, lights, camera_, options_.light_contours,
                            options_.threads, progress);
    };
    if (&casters_ == &scene_) return lines({seen, scene_.bvh()});
    const ContourScene casting = contour_scene_of(casters_, progress);
    return lines({casting, casters_.bvh(), casters_.triangles_in(scene_)});
  }

  // Once, or for each group of faces that is hatched by itself.
  void hatch_in_passes(const HatchScene& whole, const SmallParts& small, const Progress& progress) {
    const std::vector<HatchPass> passes = hatch_passes(whole, materials_, [&](double group_scale) {
      std::vector<double> scales = spacing_scales(options_.styles);
      for (double& scale : scales) scale *= group_scale;
      return small.finer(scales, options_.hatch);
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
    const Hatches hatches = even_hatches(scene, curves_, previous, options_.hatch, options_.threads,
                                         result_.counts, progress);
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

  const SeenScene& scene_;
  const SeenScene& casters_;
  const Camera& camera_;
  const DrawOptions& options_;
  const MaterialMarks materials_;
  Ragged<SurfacePoint> previous_, placed_;
  std::optional<Ragged<Vec3>> last_drawn_;  // hatches
  std::vector<std::uint8_t> follows_;       // (objects) 1: has hatches of the last drawing
  std::shared_ptr<const ImageTiles> last_tiles_, tiles_;
  CurvesOfObjects curves_;
  Hatches hatches_;
  DrawResult result_;
};

// `casters`: null: all that is seen.
DrawResult draw_seen(const Prepared& prepared, const Camera& camera, const DrawOptions& options,
                     const std::vector<Light>& lights, const SeenScene* casters,
                     const Progress& progress, const Drawing* previous) {
  const bool hatching = anything_is_hatched(options);
  const SeenScene scene(prepared, options.styles, options.threads, progress.part(0, 0.1));
  const CrossField* field = hatching ? &prepared.field(progress.part(0.1, 0.3)) : nullptr;
  View view(scene, casters ? *casters : scene, camera, options);
  if (hatching && previous) view.follow(*previous, prepared.surface());
  view.label_curves(lights, progress.part(0.3, hatching ? 0.5 : 0.95));
  if (hatching) view.hatch(*field, lights, progress.part(0.5, 0.95));
  // After the tones, which know nothing of them.
  view.add_loose_edges();
  return std::move(view).strokes(lights, progress.part(0.95, 1, "stroke"));
}

// With what the styles leave out, and through what they let see.
DrawResult draw_styled(const Prepared& prepared, const Camera& camera, const DrawOptions& options,
                       const std::vector<Light>& lights, const Progress& progress,
                       const Drawing* previous) {
  if (any_is_seen_through(options.styles)) {
    return draw_seen_through(prepared, camera, options, lights, progress, previous);
  }
  if (!any_is_shadow_only(options.styles)) {
    return draw_seen(prepared, camera, options, lights, nullptr, progress, previous);
  }
  const SeenScene casters(prepared, options.styles, options.threads, progress.part(0, 0.1));
  return draw_seen(prepared, camera, without_unseen(options), lights, &casters,
                   progress.part(0.1, 1), previous);
}

}  // namespace

DrawResult draw(const Prepared& prepared, const Camera& camera, const DrawOptions& options,
                const std::vector<Light>& lights, const Progress& progress,
                const Drawing* previous) {
  validate(options, prepared.object_count());
  for (std::size_t i = 0; i < lights.size(); ++i) validate(lights[i], i);
  DrawResult result = draw_styled(prepared, camera, options, lights, progress, previous);
  Drawing& drawing = result.drawing;
  drawing.surface = prepared.shared_surface();
  drawing.object_names = names_of(prepared.meshes());
  if (previous) {
    const Stopwatch watch;
    follow_strokes(drawing, *previous, *drawing.surface, camera, line_unit(camera));
    result.timings["stroke"] += watch.seconds();
  } else {
    drawing.tracks = first_tracks(drawing);
  }
  return result;
}

std::vector<int> silhouette_triangles(const Prepared& prepared, const Camera& camera,
                                      bool brute_force) {
  const Surface& surface = prepared.surface();
  const ContourFunctions functions(surface, camera);
  const DualSurface* dual = brute_force ? nullptr : &prepared.dual_surface();
  return find_silhouette_triangles(surface, functions, dual).triangles;
}

}  // namespace illustrate
