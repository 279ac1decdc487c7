// Where hatches are placed, to be cut down later to where they are wanted.
#pragma once

#include "tone/tone_regions.h"

namespace illustrate {

// Tones that reach farther, darker over lighter, along rows and columns: shadow also where a shadow
// or undercut is within `shadow_px`, midtone where anything hatched is within `midtone_px`, over
// highlights and Mach bands too. No bands. Hatches placed there know little of the edges of tone,
// which move with the light and the eye.
ToneMap broadened(const ToneMap& tone, double midtone_px, double shadow_px);

}  // namespace illustrate
