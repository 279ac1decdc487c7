// Vertices within straight creases between flat faces, held where they are.
//
// A crease is a cubic B-spline: where its edges are of unlike lengths its vertices slide along it
// to the longer ones. Where it runs straight on between flat faces that is to no avail, and what
// lies beside slides with it: at a corner of more than 180 degrees next to it a flat face folds
// over. A vertex that is held as a corner does not slide, and the line is the same.
#pragma once

#include "mesh/sanitize.h"

namespace illustrate {

// Makes those vertices sharp at which two sharp or open edges meet in one line, one more than a
// tenth longer than the other, and all faces between them are of one flat face (face_planes) on
// either side.
void hold_straight_creases(SoundMesh& mesh);

}  // namespace illustrate
