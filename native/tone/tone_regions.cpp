#include "tone/tone_regions.h"

#include <algorithm>
#include <cmath>

#include "core/errors.h"
#include "tone/bands.h"
#include "tone/exposure.h"
#include "tone/illumination.h"
#include "tone/levels.h"
#include "tone/patches.h"

namespace illustrate {
namespace {

void require(bool good, const char* message) {
  if (!good) throw InvalidInput(message);
}

bool is_share(const std::optional<double>& share) { return !share || (*share >= 0 && *share <= 1); }

Tone level_of(double light, const Thresholds& thresholds) {
  if (light > thresholds.highlight) return Tone::highlight;
  return light <= thresholds.shadow ? Tone::shadow : Tone::midtone;
}

std::uint8_t extra_level(double light, const Thresholds& thresholds) {
  const auto& extra = thresholds.extra;
  return static_cast<std::uint8_t>(
      std::count_if(extra.begin(), extra.end(), [&](double t) { return light <= t; }));
}

std::vector<double> light_at_cells(const ToneScene& scene, const ToneOptions& options,
                                   const Progress& progress) {
  if (options.image) {
    return light_of_image(*options.image, scene.visible, scene.camera, options.threads, progress);
  }
  const LitScene lit{scene.surface, options.cast_shadows ? scene.casters : nullptr, scene.lightness,
                     options.reflectance, scene.catchers};
  return light_of_cells(lit, scene.visible, scene.camera, scene.lights, options.threads, progress);
}

// The light of all visible cells whose objects count, in order.
std::vector<double> counted_light(const ToneScene& scene, const std::vector<double>& light) {
  std::vector<double> counted;
  for (std::size_t cell = 0; cell < light.size(); ++cell) {
    const int triangle = scene.visible.triangle[cell];
    if (triangle == none || scene.surface.is_of(scene.unhatched, triangle) ||
        scene.surface.is_of(scene.catchers, triangle)) {
      continue;
    }
    counted.push_back(light[cell]);
  }
  return counted;
}

// Multiplies the light; returns by how much.
double expose(const ToneScene& scene, const ToneOptions& options, std::vector<double>& light) {
  double factor = options.exposure;
  if (options.auto_exposure) factor *= suitable_exposure(options, counted_light(scene, light));
  if (factor == 1) return factor;
  for (double& value : light) value *= factor;
  return factor;
}

// Calls visit(cell) where objects of a mask are seen.
template <class Visit>
void for_cells_of(const std::vector<std::uint8_t>& mask, const ToneScene& scene,
                  const Visit& visit) {
  if (mask.empty()) return;
  for (std::size_t cell = 0; cell < scene.visible.triangle.size(); ++cell) {
    const int triangle = scene.visible.triangle[cell];
    if (triangle != none && scene.surface.is_of(mask, triangle)) visit(cell);
  }
}

ToneMap levels_of(const VisibleImage& visible, const std::vector<double>& light,
                  const Thresholds& thresholds, const ToneOptions& options) {
  const std::size_t cells = light.size();
  ToneMap tone;
  tone.width = visible.width;
  tone.height = visible.height;
  tone.cell_px = visible.cell_px;
  tone.highlight_threshold = std::min(thresholds.highlight, 1.0);
  tone.shadow_threshold = std::clamp(thresholds.shadow, 0.0, 1.0);
  tone.level.assign(cells, Tone::nothing);
  tone.band.assign(cells, Band::nothing);
  tone.brightness.assign(cells, 0);
  if (options.extra_levels > 0) tone.extra.assign(cells, 0);
  for (std::size_t cell = 0; cell < cells; ++cell) {
    if (visible.triangle[cell] == none) continue;
    tone.level[cell] = level_of(light[cell], thresholds);
    tone.brightness[cell] = static_cast<float>(std::min(1.0, light[cell]));
    if (tone.level[cell] == Tone::shadow && !tone.extra.empty()) {
      tone.extra[cell] = extra_level(light[cell], thresholds);
    }
  }
  return tone;
}

ToneMap levels_in(const ToneScene& scene, const ToneOptions& options, std::vector<double>& light) {
  const double exposure = expose(scene, options, light);
  // The share of light that reaches a catcher is no light that could be exposed.
  for_cells_of(scene.catchers, scene, [&](std::size_t cell) { light[cell] /= exposure; });
  const bool by_share = options.highlight_share || options.shadow_share;
  const Thresholds thresholds =
      find_thresholds(options, by_share ? counted_light(scene, light) : std::vector<double>{});
  ToneMap tone = levels_of(scene.visible, light, thresholds, options);
  tone.exposure = exposure;
  return tone;
}

}  // namespace

void validate(const ToneOptions& options) {
  require(std::isfinite(options.highlight_threshold), "highlight_threshold must be finite");
  require(std::isfinite(options.shadow_threshold), "shadow_threshold must be finite");
  require(is_share(options.highlight_share), "highlight_share must be in [0, 1], or none");
  require(is_share(options.shadow_share), "shadow_share must be in [0, 1], or none");
  require(options.highlight_share.value_or(0) + options.shadow_share.value_or(0) <= 1 + 1e-9,
          "highlight_share and shadow_share must be at most 1 together");
  require(options.reflectance >= 0 && options.reflectance <= 1, "reflectance must be in [0, 1]");
  require(options.exposure > 0 && std::isfinite(options.exposure), "exposure must be above 0");
  require(options.extra_levels >= 0 && options.extra_levels <= 3, "extra_levels must be in [0, 3]");
  require(options.mach_band_px >= 0 && options.mach_band_px <= 100,
          "mach_band_px must be in [0, 100]");
  require(options.undercut_px >= 0 && options.undercut_px <= 100,
          "undercut_px must be in [0, 100]");
  require(options.patch_px >= 0 && std::isfinite(options.patch_px), "patch_px must be at least 0");
  require(options.undercut_contact >= 0 && options.undercut_contact <= 1,
          "undercut_contact must be in [0, 1]");
}

int ToneMap::cell_of(const Vec2& image) const {
  const double column = std::floor(image.x() / cell_px), row = std::floor(image.y() / cell_px);
  if (!(column >= 0 && row >= 0 && column < width && row < height)) return none;
  return static_cast<int>(row) * width + static_cast<int>(column);
}

ToneMap tone_levels(const ToneScene& scene, const ToneOptions& options, const Progress& progress) {
  validate(options);
  for (std::size_t i = 0; i < scene.lights.size(); ++i) validate(scene.lights[i], i);
  require(scene.casters || !options.cast_shadows, "cast_shadows needs what casts them");
  progress.report(0);
  std::vector<double> light = light_at_cells(scene, options, progress.part(0, 0.9));
  progress.report(0.9);
  ToneMap tone = levels_in(scene, options, light);
  settle_patches(scene.surface, scene.visible, options.patch_px, tone);
  progress.report(1);
  return tone;
}

void add_bands(const ToneScene& scene, const LabelledGraph& graph, const ToneOptions& options,
               ToneMap& tone) {
  if (!options.mach_bands && !options.undercuts) return;
  mark_bands(scene, graph, options, tone.brightness, tone.band);
  for_cells_of(scene.catchers, scene, [&](std::size_t cell) { tone.band[cell] = Band::nothing; });
  drop_small_undercuts(scene.surface, scene.visible, options.patch_px, tone);
}

ToneMap extra_tones(const ToneMap& tone) {
  ToneMap extra = tone;
  extra.extra.clear();
  for (std::size_t cell = 0; cell < tone.level.size(); ++cell) {
    const int level = tone.extra.empty() ? 0 : tone.extra[cell];
    const bool is_hatched = level > 0 && tone.band[cell] != Band::mach_band;
    extra.band[cell] = is_hatched && level == 3 ? Band::undercut : Band::nothing;
    extra.level[cell] = !is_hatched ? Tone::nothing : level == 1 ? Tone::midtone : Tone::shadow;
  }
  return extra;
}

}  // namespace illustrate
