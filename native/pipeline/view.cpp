#include "pipeline/view.h"

#include <algorithm>
#include <cmath>

#include "contour/network/network.h"
#include "core/aside.h"
#include "pipeline/casters.h"
#include "pipeline/see_through.h"
#include "pipeline/stopwatch.h"
#include "pipeline/style_masks.h"
#include "tone/light_contours.h"
#include "visibility/label_network.h"
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

// From images in units to pixels.
void to_pixels(LabelledGraph& graph, double unit) {
  for (GraphNode& node : graph.nodes) node.image *= unit;
  for (Vec2& image : graph.image.values) image *= unit;
  graph.repair_max_px *= unit;
  graph.unit_px = unit;
}

ContourScene contour_scene_of(const View& view, const SeenScene& scene, const Progress& progress) {
  return {scene.surface(), scene.limit_surface(), scene.features(), scene.intersections(),
          view.options.scan_silhouettes ? nullptr : &scene.dual_surface(progress)};
}

FreeLines lines_of_light(const View& view, const ContourScene& seen, const Progress& progress) {
  const auto lines = [&](const LightCasters& casters) {
    return light_contours(seen, casters, view.lights, view.camera, view.options.light_contours,
                          view.options.threads, progress);
  };
  if (!view.casters) return lines({seen, view.scene->bvh()});
  const ContourScene casting = contour_scene_of(view, *view.casters, progress);
  return lines({casting, view.casters->bvh(), view.casters->triangles_in(*view.scene)});
}

// In units of paper.
CurveNetwork network_of(View& view, const Camera& on_paper, const Progress& progress) {
  const DrawOptions& options = view.options;
  const StrokeOptions& stroke = options.stroke;
  const bool by_vote = options.visibility == VisibilityMethod::vote;
  // The vote is there for comparison: it gets all curves, also those that are hidden for certain.
  const NetworkOptions network_options{stroke.marks,
                                       stroke.materials,
                                       stroke.flat_outlines,
                                       options.curvature_curves,
                                       !stroke.hidden_lines && !by_vote,
                                       options.threads};
  const Progress search = progress.part(0, 0.3, "contour");
  ContourScene scene = contour_scene_of(view, *view.scene, search);
  if (options.curvature_curves.any()) {
    scene.derivative = &view.scene->curvature_derivative(progress.part(0.3, 0.5));
  }
  return timed(view.timings["contour"], [&] {
    FreeLines of_light;
    if (options.light_contours.any()) {
      of_light = lines_of_light(view, scene, search);
      scene.light_contours = &of_light;
    }
    return build_network(scene, on_paper, network_options, view.counts,
                         progress.part(0.5, 1, "contour"));
  });
}

void label_lines(View& view, const Progress& progress) {
  const double unit = line_unit(view.camera);
  const Camera on_paper = view.camera.in_units_of(unit);
  const CurveNetwork network = network_of(view, on_paper, progress.part(0, 0.6));
  const SeenScene& scene = *view.scene;
  view.graph = timed(view.timings["visibility"], [&] {
    const Progress visibility = progress.part(0.6, 1, "visibility");
    return view.options.visibility == VisibilityMethod::vote
               ? vote_network(network, scene.surface(), scene.bvh(), on_paper, view.counts,
                              visibility)
               : label_network(network, scene.surface(), scene.bvh(), on_paper, view.counts,
                               visibility, view.options.threads, scene.intersections().insets);
  });
  to_pixels(view.graph, unit);
}

ToneOptions tone_options_of(const DrawOptions& options) {
  ToneOptions tone = options.tone;
  tone.threads = options.threads;
  tone.patch_px = options.smallest_tone * options.hatch.spacing_px;
  return tone;
}

// What is known of the tones of a view before its lines are.
struct SeenTones {
  VisibleImage visible;
  ToneMap tone;  // without bands
};

ToneScene tone_scene_of(const View& view, const VisibleImage& visible,
                        const Lightness* lightness = nullptr) {
  const std::vector<ObjectStyle>& styles = view.options.styles;
  const SeenScene& scene = *view.scene;
  return {scene.surface(),
          visible,
          view.camera,
          view.lights,
          &view.casting().bvh(),
          unhatched_objects(styles),
          shadow_catchers(styles),
          lightness,
          &scene.parts()};
}

SeenTones seen_tones(const View& view, const Progress& progress) {
  progress.report(0);
  const DrawOptions& options = view.options;
  const Surface& surface = view.scene->surface();
  SeenTones seen;
  seen.visible =
      render_visible(surface, view.camera, cell_size(view.camera, options), {}, options.threads);
  const Lightness lightness(surface, view.scene->meshes());
  seen.tone = tone_levels(tone_scene_of(view, seen.visible, &lightness), tone_options_of(options),
                          progress.part(0.2, 1));
  return seen;
}

void add_tones(View& view, SeenTones seen) {
  const DrawOptions& options = view.options;
  view.small.emplace(view.scene->surface(), view.scene->parts(), view.camera);
  view.spacing_scale = view.small->finer(spacing_scales(options.styles), options.hatch);
  view.visible = std::move(seen.visible);
  view.tone = std::move(seen.tone);
  add_bands(tone_scene_of(view, view.visible), view.graph, tone_options_of(options), view.tone);
  blank_unhatched(view.visible, view.materials.unhatched, view.tone);
  blank_unhatched(view.visible, view.small->too_narrow(view.spacing_scale, options.hatch),
                  view.tone);
}

// casters: null: all that is drawn.
View view_of_seen(const Prepared& prepared, const Camera& camera, const DrawOptions& options,
                  const std::vector<Light>& lights, std::unique_ptr<const SeenScene> casters,
                  const Progress& progress) {
  View view{prepared, camera, options, lights};
  view.timings = {{"contour", 0}, {"visibility", 0}, {"tone", 0}, {"hatch", 0}, {"stroke", 0}};
  view.casters = std::move(casters);
  view.scene =
      std::make_unique<SeenScene>(prepared, options.styles, options.threads, progress.part(0, 0.1));
  view.materials = material_marks(view.scene->surface(), view.scene->meshes(), options.styles);
  if (!anything_is_hatched(options)) {
    label_lines(view, progress.part(0.3, 1));
    return view;
  }
  prepared.field(progress.part(0.1, 0.3));
  Aside<SeenTones> tones(options.threads,
                         [&](const Progress& part) { return seen_tones(view, part); });
  label_lines(view, progress.part(0.3, 0.7));
  const Stopwatch watch;
  add_tones(view, tones.take(progress.part(0.7, 1, "tone")));
  view.timings["tone"] += watch.seconds();
  return view;
}

// With what the styles leave out.
View view_of_opaque(const Prepared& prepared, const Camera& camera, const DrawOptions& options,
                    const std::vector<Light>& lights, const Progress& progress) {
  if (!any_is_shadow_only(options.styles)) {
    return view_of_seen(prepared, camera, options, lights, nullptr, progress);
  }
  auto casters = std::make_unique<const SeenScene>(prepared, options.styles, options.threads,
                                                   progress.part(0, 0.1));
  return view_of_seen(prepared, camera, without_unseen(options), lights, std::move(casters),
                      progress.part(0.1, 1));
}

}  // namespace

double line_unit(const Camera& camera) {
  return std::min(std::max(camera.width_px(), camera.height_px()) / units_across, most_pixels);
}

View view_of(const Prepared& prepared, const Camera& camera, const DrawOptions& options,
             const std::vector<Light>& lights, const Progress& progress) {
  validate(options, prepared.object_count());
  for (std::size_t i = 0; i < lights.size(); ++i) validate(lights[i], i);
  if (!any_is_seen_through(options.styles)) {
    return view_of_opaque(prepared, camera, options, lights, progress);
  }
  View view =
      view_of_opaque(prepared, camera, without_glass(options), lights, progress.part(0, 0.5));
  view.glass = std::make_unique<const View>(
      view_of_opaque(prepared, camera, glass_alone(options), lights, progress.part(0.5, 1)));
  return view;
}

}  // namespace illustrate
