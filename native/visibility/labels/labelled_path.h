// A path with its labels.
#pragma once

#include "visibility/labels/path_arcs.h"

namespace illustrate {

struct LabelledPath {
  std::vector<PathArc> arcs;  // in order along the path
  std::vector<int> layers;    // (arcs) of surface in front
};

}  // namespace illustrate
