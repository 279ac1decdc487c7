// Tones that a draughtsman would draw: no patch too small for a few strokes, no ragged edge.
#pragma once

#include "tone/tone_regions.h"

namespace illustrate {

// Evens the levels out, object by object. First each cell takes the median tone of the cells of its
// object in a square of a quarter of `patch_px` round it: thinner than half of that is nothing, and
// edges are as smooth. Then connected cells of one tone that cover less than a square of `patch_px`
// take the tone of larger ones that they share most of their border with, highlights if they cover
// less than a third of that. What no other tone of the object borders on stays.
// So does all of an object of which less is seen than two such squares, and ever less of one up to
// six: joined, most small objects would be as dark as their darkest part, which is the largest.
// Extra levels go where shadow does. 0: all stays.
void settle_patches(const Surface& surface, const VisibleImage& visible, double patch_px,
                    ToneMap& tone);

// Undercuts of less than a third of the area of such a square, on an object that has more than
// them, are none.
void drop_small_undercuts(const Surface& surface, const VisibleImage& visible, double patch_px,
                          ToneMap& tone);

}  // namespace illustrate
