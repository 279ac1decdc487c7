// The first half of a drawing, in which no other drawing has a part: the lines of a view, labelled,
// and its tones. It may be made while the frame before is still being hatched.
#pragma once

#include "hatch/small_parts.h"
#include "pipeline/material_styles.h"
#include "pipeline/seen_scene.h"
#include "tone/light.h"
#include "view/camera.h"

namespace illustrate {

struct View {
  const Prepared& prepared;  // must outlive the view
  Camera camera;
  DrawOptions options;
  std::vector<Light> lights;
  std::unique_ptr<const SeenScene> scene{};    // what is drawn
  std::unique_ptr<const SeenScene> casters{};  // what keeps the light from it; null: itself
  MaterialMarks materials{};
  LabelledGraph graph{};
  // Where the options hatch nothing, these are of no size.
  VisibleImage visible{};
  std::optional<SmallParts> small{};
  std::vector<float> spacing_scale{};  // (t) as in HatchScene
  ToneMap tone{};
  Counts counts{};
  Timings timings{};  // as in DrawResult
  // The view of what others are seen through, whose lines are drawn over these; null: nothing is.
  std::unique_ptr<const View> glass{};

  const SeenScene& casting() const { return casters ? *casters : *scene; }
};

// As `draw` (pipeline/draw.h), which makes a drawing of it.
View view_of(const Prepared& prepared, const Camera& camera, const DrawOptions& options,
             const std::vector<Light>& lights = {}, const Progress& progress = {});

// Pixels of the unit in which lines are decided.
double line_unit(const Camera& camera);

}  // namespace illustrate
