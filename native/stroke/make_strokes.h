// Stage `stroke`: arcs and hatches to strokes (paper section 4.4, "segments"; section 6.1 for width
// by light).
//
// Arcs of one kind, one object and one number of layers are chained through nodes where the
// direction goes on, front with front and back with back at a crossing. Specks shorter than
// `speck_px` are dropped unless they close a gap between two strokes. Points are simplified within
// `simplify_px`, ends of open strokes taper, everything is clipped at the frame.
#pragma once

#include <optional>

#include "hatch/hatches.h"
#include "stroke/drawing.h"
#include "stroke/line_weights.h"
#include "tone/tone_regions.h"
#include "view/camera.h"
#include "visibility/labelled_graph.h"

namespace illustrate {

struct StrokeOptions {
  double line_width_px = 2.0;     // silhouettes, boundaries
  double feature_width_px = 1.4;  // all other lines
  double hatch_width_px = 1.0;    // at the border of shadow and midtone
  double hatch_width_by_light =
      0.5;  // share by which hatches swell towards the dark and thin towards highlights
  LineWeightOptions line_weight;  // what makes lines wider here and thinner there
  double width_by_crowding = 1;   // how far crowded lines thin out (crowded_lines.h), [0, 1]
  double hidden_width_scale = 0.5;
  double taper_px =
      6;  // length over which open ends thin out, for hatches and lines that end freely
  double speck_px = 3;
  double simplify_px = 0.1;
  bool marks = false;          // draw Kind::mark
  bool materials = false;      // draw Kind::material
  bool flat_outlines = false;  // draw Kind::flat_outline
  std::optional<std::array<int, 2>>
      hidden_lines;  // also arcs with so many layers in front, inclusive
};
void validate(const StrokeOptions& options);  // throws InvalidInput naming the field

// What strokes are drawn with from place to place. Factors of widths, empty: 1; pens, where strokes
// end if they change, empty: 0.
struct StrokeStyles {
  Ragged<double> line_widths;  // at the points of the graph (line_weights.h); 0: not drawn there
  std::vector<double> hatch_widths;  // (t) of the surface's triangles
  std::vector<int> pens;             // (t)
};

// `width_scale`: one factor per object, empty: 1; `undrawn`: objects whose lines are not drawn,
// empty: none.
Drawing make_strokes(const LabelledGraph& graph, const Hatches& hatches, const ToneMap& tone,
                     const Camera& camera, const std::vector<double>& width_scale,
                     const std::vector<std::uint8_t>& undrawn, const StrokeOptions& options,
                     const StrokeStyles& places = {});

}  // namespace illustrate
