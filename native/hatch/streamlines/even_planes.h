// Streamlines on flat faces are ruled: evenly spaced from edge to edge of the face.
#pragma once

#include "hatch/streamlines/streamline_set.h"

namespace illustrate {

// Relaxing (relax_streamlines.h) evens out what is a few streamlines apart; over a face of fifty
// the density still drifts, and on nothing else the eye is as sure of that. Here those that lie on
// flat faces (surface/planes/plane_faces.h) with all of their nodes move as they are, all at once:
// of all gaps between neighbours the squares of what they are off a spacing are least, half a
// spacing before critical curves. So gaps between two edges become equal. All others stay, and are
// neighbours. Nodes that would leave the face or go behind a critical curve are dropped from the
// ends; where one between would, the streamline stays as it is.
void even_planes(StreamlineSet& set, const HatchView& view);

}  // namespace illustrate
