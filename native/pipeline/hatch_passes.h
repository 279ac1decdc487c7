// Faces of one mesh may be hatched at a spacing, or with a pen, of their own: such a view is
// hatched in passes, each of which sees nothing but the tones of its own group of faces.
#pragma once

#include <functional>
#include <vector>

#include "hatch/even_hatches.h"
#include "pipeline/material_styles.h"
#include "pipeline/style_masks.h"

namespace illustrate {

// What differs between the passes.
struct HatchPass {
  ToneMap tone;
  std::vector<float> spacing_scale;  // (t)
  Mask unhatched;                    // (objects)
  std::vector<std::uint8_t> own;     // (t) 1: of its group
};

// One for each group that is seen; none where all is hatched alike. spacing_scale: (t) those of a
// group whose faces scale the spacing by a factor.
std::vector<HatchPass> hatch_passes(
    const HatchScene& whole, const MaterialMarks& marks,
    const std::function<std::vector<float>(double factor)>& spacing_scale);

// `whole` with what the pass has of its own; refers to both.
HatchScene scene_of(const HatchPass& pass, const HatchScene& whole);

// (objects) those that the most demanding pass asks for (wanted_radii).
std::vector<double> finest_radii(const std::vector<HatchScene>& scenes,
                                 const HatchOptions& options);

// The lines that lie on a pass's own triangles with more than half of their points.
Ragged<SurfacePoint> lines_of_pass(const Ragged<SurfacePoint>& lines, const HatchPass& pass);

}  // namespace illustrate
