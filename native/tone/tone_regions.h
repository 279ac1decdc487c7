// Stage `tone`: highlights, midtones, shadows; Mach bands and undercuts (paper sections 6.1, 6.3).
//
// A visible silhouette, boundary or self-intersection separates a fold from what lies beyond it.
// Where that is another surface, a narrow band on the fold's near side is a Mach band (not hatched)
// and a wider one beyond it an undercut (densely cross-hatched, also in a highlight).
#pragma once

#include <memory>
#include <optional>

#include "core/progress.h"
#include "mesh/bvh.h"
#include "occlusion/visible_image.h"
#include "surface/parts.h"
#include "tone/light.h"
#include "tone/lightness.h"
#include "visibility/labelled_graph.h"

namespace illustrate {

struct ToneOptions {
  double highlight_threshold = 0.85;  // brightness above: highlight, no hatching
  double shadow_threshold = 0.45;     // at or below: shadow, two directions; else midtone, one
  // In place of a threshold: the share of the visible area that is to be highlight, or shadow; in
  // [0, 1], together at most 1.
  std::optional<double> highlight_share, shadow_share;
  int extra_levels = 0;        // into which shadows are divided further, [0, 3]
  double reflectance = 1;      // how much the meshes' own counts, [0, 1]; 0: all are white
  double exposure = 1;         // the light is multiplied by it, above 0
  bool auto_exposure = false;  // multiplied also by what suits the view (tone/exposure.h)
  bool cast_shadows = false;   // whether surfaces keep the light from others
  // The light that comes back, in place of all that lights and reflectance say: an image that fills
  // the view, linear, 1 as bright as white paper. Null: none.
  std::shared_ptr<const Texture> image;
  bool mach_bands = true;
  bool undercuts = true;
  double mach_band_px = 6;  // in [0, 100]
  double undercut_px = 14;  // in [0, 100]
  // How near a fold must be to what lies beyond it for an undercut: 0: anywhere (the paper), 1:
  // they touch; in [0, 1] (tone/bands.h).
  double undercut_contact = 0.5;
  // Patches of one tone smaller than a square of this side join their neighbour, and edges of tone
  // are evened out over a quarter of it (tone/patches.h); 0: nothing is.
  double patch_px = 0;
  int threads = 0;
};
void validate(const ToneOptions& options);  // throws InvalidInput naming the field

enum class Tone : std::uint8_t { highlight = 0, midtone = 1, shadow = 2, nothing = 255 };
enum class Band : std::uint8_t { nothing = 0, mach_band = 1, undercut = 2 };

struct ToneMap {
  int width = 0;
  int height = 0;
  double cell_px = 1;
  std::vector<Tone> level;  // (height * width)
  std::vector<Band> band;
  std::vector<float> brightness;    // 0 where nothing is seen
  std::vector<std::uint8_t> extra;  // 1 to extra_levels in the deeper shadows; empty without them
  // What divides the levels, as used.
  double highlight_threshold = 0.85;
  double shadow_threshold = 0.45;
  double exposure = 1;  // what the light was multiplied by

  // Cell of an image point, none outside the frame.
  int cell_of(const Vec2& image) const;
};

// What a tone map is of: a surface, what is seen of it, and what lights it.
struct ToneScene {
  const Surface& surface;
  const VisibleImage& visible;
  const Camera& camera;
  const std::vector<Light>& lights;  // none: a headlight
  // What casts shadows; needed where the options ask for them.
  const Bvh* casters = nullptr;
  // (objects) 1: its area does not count towards the shares and the exposure; empty: all count.
  std::vector<std::uint8_t> unhatched{};
  // (objects) 1: does not count either, is as light as the share of the light that others let
  // through to it, and has no bands; empty: none.
  std::vector<std::uint8_t> catchers{};
  const Lightness* lightness = nullptr;  // of the surface; null: white
  const SurfaceParts* parts = nullptr;   // of the surface; null: they are looked for
};

// Levels and brightness, which no line has a part in. No bands.
ToneMap tone_levels(const ToneScene& scene, const ToneOptions& options,
                    const Progress& progress = {});

// Adds the bands along the visible lines of a graph to such a map.
void add_bands(const ToneScene& scene, const LabelledGraph& graph, const ToneOptions& options,
               ToneMap& tone);

// The extra levels of a map as levels of their own: the first as midtone, the second as shadow, the
// third as undercut, and nothing elsewhere.
ToneMap extra_tones(const ToneMap& tone);

}  // namespace illustrate
