// From labels to the labelled graph: arcs with their points, nodes with their arcs.
#pragma once

#include "surface/surface.h"
#include "visibility/labelled_graph.h"
#include "visibility/labels/labelled_path.h"

namespace illustrate {

LabelledGraph build_graph(const Arrangement& arrangement, const std::vector<LabelledPath>& paths,
                          const Surface& surface);

}  // namespace illustrate
