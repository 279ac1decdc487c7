#include "tone/tone_regions.h"

#include <cmath>

#include "core/errors.h"
#include "core/parallel.h"
#include "tone/bands.h"

namespace illustrate {
namespace {

void require(bool good, const char* message) {
  if (!good) throw InvalidInput(message);
}

Tone level_of(double light, const ToneOptions& options) {
  if (light > options.highlight_threshold) return Tone::highlight;
  return light <= options.shadow_threshold ? Tone::shadow : Tone::midtone;
}

}  // namespace

void validate(const ToneOptions& options) {
  require(std::isfinite(options.highlight_threshold), "highlight_threshold must be finite");
  require(std::isfinite(options.shadow_threshold), "shadow_threshold must be finite");
  require(options.mach_band_px >= 0 && options.mach_band_px <= 100,
          "mach_band_px must be in [0, 100]");
  require(options.undercut_px >= 0 && options.undercut_px <= 100,
          "undercut_px must be in [0, 100]");
}

int ToneMap::cell_of(const Vec2& image) const {
  const double column = std::floor(image.x() / cell_px), row = std::floor(image.y() / cell_px);
  if (!(column >= 0 && row >= 0 && column < width && row < height)) return none;
  return static_cast<int>(row) * width + static_cast<int>(column);
}

ToneMap tone_regions(const Surface& surface, const VisibleImage& visible,
                     const LabelledGraph& graph, const Camera& camera,
                     const std::vector<Light>& lights, const ToneOptions& options,
                     const Progress& progress) {
  validate(options);
  for (std::size_t i = 0; i < lights.size(); ++i) validate(lights[i], i);
  progress.report(0);
  const std::size_t cells = visible.triangle.size();
  ToneMap tone;
  tone.width = visible.width;
  tone.height = visible.height;
  tone.cell_px = visible.cell_px;
  tone.level.assign(cells, Tone::nothing);
  tone.band.assign(cells, Band::nothing);
  tone.brightness.assign(cells, 0);

  const ImageMap map = image_map(camera);
  parallel_for(cells, options.threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t cell = begin; cell < end; ++cell) {
      if (visible.triangle[cell] == none) continue;
      const auto row = cell / visible.width, column = cell % visible.width;
      const Vec2 centre = Vec2(double(column) + 0.5, double(row) + 0.5) * visible.cell_px;
      const SurfacePoint at = surface_point_under(surface, map, visible.triangle[cell], centre);
      const double light =
          brightness(lights, camera, position_at(surface, at), normal_at(surface, at));
      tone.level[cell] = level_of(light, options);
      tone.brightness[cell] = static_cast<float>(light);
    }
  });
  progress.report(0.7);
  if (options.mach_bands || options.undercuts) {
    mark_bands(surface, visible, graph, camera, options, tone.band);
  }
  progress.report(1);
  return tone;
}

}  // namespace illustrate
