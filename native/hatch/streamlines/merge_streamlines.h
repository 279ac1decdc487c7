// Streamlines whose ends face each other become one.
#pragma once

#include "hatch/streamlines/streamline_set.h"

namespace illustrate {

// Ends join whose tangents are opposite within 41 degrees, with at most 3 spacings between them
// along and .5 across, where the bridge stays on the surface, is seen and wanted, crosses no
// critical curve and is .45 spacings clear of other streamlines; the nearest pairs first. Both give
// up nodes until the bridge is not crooked. ruled: on flat faces, where a bridge would show that
// relaxing does not straighten, .2 spacings across are the most; of what is farther across a short
// one goes, so that the long one can go on, and two short ones are joined as elsewhere.
// Streamlines that were joined get evenly spaced nodes.
void merge_streamlines(StreamlineSet& set, const HatchView& view, bool ruled = false);

// Nodes `node_step` apart along the same streamline; the ends stay.
void resample(Streamline& streamline, const HatchView& view);

}  // namespace illustrate
