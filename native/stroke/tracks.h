// Strokes that live through frames: which stroke of a drawing is which of the frame before, and
// where along it textures and dashes begin.
//
// Strokes of the last frame are taken to where their surface is now and seen by the new camera. A
// stroke is the one of the last frame that it lies on for the greatest length, of those of one
// object and kind that run the same way; hatches and cross-hatches are of one kind. Where several
// lie on one stroke the longest is its heir; the others are new, but count on where it did. Along
// silhouettes, which slide over the surface, points are matched by where they are seen and how
// deep.
#pragma once

#include "stroke/drawing.h"
#include "surface/surface.h"
#include "view/camera.h"

namespace illustrate {

// A drawing that begins a sequence: every stroke is born.
StrokeTracks first_tracks(const Drawing& drawing);

// Fills `drawing.tracks` after those of `last`, on whatever surface. Hatches come to run the way
// that they ran before, and closed strokes to begin where they began; nothing else is changed.
// unit_px: pixels of a unit of paper, in which it is decided what is near. `surface`: of
// drawing.on.
void follow_strokes(Drawing& drawing, const Drawing& last, const Surface& surface,
                    const Camera& camera, double unit_px);

}  // namespace illustrate
