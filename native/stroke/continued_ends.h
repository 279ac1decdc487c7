// Ends of lines that are none to the eye: where another line goes on.
#pragma once

#include "stroke/stroke_path.h"

namespace illustrate {

// Ends are not free any more that lie on another of the paths which runs in the end's direction,
// and on for `reach_px`: where two lines of an outline pass each other at a swallowtail, or meet
// end to end, neither is to run thin. On: within its width, or `near_px`.
void keep_continued_ends(std::vector<StrokePath>& paths, double reach_px, double near_px);

}  // namespace illustrate
