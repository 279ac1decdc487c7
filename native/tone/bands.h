// Mach bands and undercuts: the two sides of a fold (paper section 6.3).
#pragma once

#include "tone/tone_regions.h"

namespace illustrate {

// Where a visible curve of the graph hides one side of itself from the other (`left_layers` !=
// `right_layers`) and another surface is seen beyond it, cells of the fold within mach_band_px
// become Mach band, cells of the other surface within undercut_px undercut. A cell near several
// folds goes with the nearest.
//
// The farther the surface beyond is behind, the narrower its undercut, until there is none: light
// gets in between. How far is measured against the part that folds: at undercut_contact c there are
// none from a gap of (1 - c) / c quarters of its diagonal on, and whole ones up to a fifth of that;
// up to twice as far on the side away from the light (light_side in tone/light.h), and less far on
// the side that it comes from. Towards the end of its fold an undercut tapers, and round a small
// loop it is narrow (tone/fold_extents.h). At c = 0, as in the paper, all are whole.
//
// An undercut does not reach over a crease: what is nearer to one that is seen, and beside it, than
// to the fold is another face, as a board's top beside the groove before it.
//
// A visible self-intersection hides nothing: two sheets meet there. Over the whole arc the sheet
// that is turned farther from the viewer takes the undercut, the other one the Mach band.
//
// Narrow parts that are darker than what lies beyond have no Mach band (tone/fold_sides.h).
//
// brightness: (height * width), as in ToneMap. band: (height * width), set to Band::nothing by the
// caller.
void mark_bands(const ToneScene& scene, const LabelledGraph& graph, const ToneOptions& options,
                const std::vector<float>& brightness, std::vector<Band>& band);

}  // namespace illustrate
