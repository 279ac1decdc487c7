// What a caller may choose: the options of all stages, and what is said of single objects.
#pragma once

#include <vector>

#include "contour/intersection/intersections.h"
#include "contour/shape/curvature_curves.h"
#include "field/cross_field.h"
#include "hatch/greedy/place_hatches.h"
#include "stroke/make_strokes.h"
#include "surface/jets/curvature.h"
#include "surface/refine.h"
#include "tone/light_contours.h"
#include "tone/tone_regions.h"

namespace illustrate {

// `threads` counts for every stage, in place of the stages' own.
struct PrepareOptions {
  SurfaceOptions surface;
  JetOptions jet;  // curvature for hatching
  FieldOptions cross_field;
  bool field = true;  // false: hatching curvature and field wait until first needed
  // Pairs of triangles that cross, beyond which objects have no curves where they pass through each
  // other, or through themselves (contour/intersection/intersections.h).
  std::int64_t most_intersections = most_crossing_triangles;
  int threads = 0;  // 0: all cores
};
void validate(const PrepareOptions& options);  // throws InvalidInput naming the field

// What is drawn of the faces of one material, within what their object's style allows.
struct MaterialStyle {
  bool lines = true;
  bool hatching = true;
  double spacing_scale = 1;  // of the hatches
  double width_scale = 1;    // of all strokes
  int pen = 0;               // of all strokes, which end where it changes; 0: the object's
};

// What is drawn of one mesh.
struct ObjectStyle {
  bool ignore = false;        // left out entirely: neither drawn nor in front of anything
  bool occlude_only = false;  // hides what is behind it, but is not drawn
  bool see_through = false;   // hides nothing and is not hatched, as glass (pipeline/see_through.h)
  bool shadow_only = false;   // as ignored, but keeps the light from others
  bool shadow_catcher = false;  // without lines, and hatched only where others keep the light away
  bool lines = true;
  bool hatching = true;
  bool loose_edges = false;              // drawn too, whatever the options say
  double spacing_scale = 1;              // of the hatches
  double width_scale = 1;                // of all its strokes
  int pen = 0;                           // of all its strokes (Drawing::pens)
  std::vector<MaterialStyle> materials;  // by PolygonMesh::face_materials; beyond: as the object
};

// How curves are told visible: labels that cannot contradict each other (visibility/
// label_network.h), or the paper's vote, for comparison (visibility/vote.h).
enum class VisibilityMethod : std::uint8_t { labels, vote };

struct DrawOptions {
  bool hatching = true;  // false: lines only, no tone
  ToneOptions tone;
  HatchOptions hatch;
  StrokeOptions stroke;  // its marks, materials and flat outlines are also those of the network
  CurvatureCurveOptions curvature_curves;
  LightContourOptions light_contours;
  bool loose_edges = false;  // draw PolygonMesh::loose_edges
  // Patches of one tone smaller than a square of so many spacings of hatches join their neighbour,
  // [0, 20]; 0: none do.
  double smallest_tone = 2.5;
  // The largest cells of the tone map, [0.25, 64]: they are an eighth of the hatches' spacing and
  // at most a sixth of a band's width, but larger where the image has over 16 million of them.
  double cell_px = 64;
  bool scan_silhouettes = false;  // look at all triangles instead of searching the dual surface
  VisibilityMethod visibility = VisibilityMethod::labels;
  std::vector<ObjectStyle> styles;  // one per mesh, or empty
  int threads = 0;                  // 0: all cores
};
// Throws InvalidInput naming the field; `object_count` is what styles must have.
void validate(const DrawOptions& options, std::size_t object_count);

}  // namespace illustrate
