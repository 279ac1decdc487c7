// Strokes as pixels, for pictures that any program opens.
//
// A stroke is what a round pen covers whose width changes linearly from point to point. A pixel is
// covered by the exact area that it shares with a straight strip of the stroke's width, so that a
// line has the same ink in every direction, and one thinner than a pixel grows paler as it should;
// at ends and corners the strip is the one across the way to the nearest point. Where pieces of one
// stroke meet or cross, the larger cover counts: no beads.
#pragma once

#include <array>

#include "core/progress.h"
#include "core/types.h"

namespace illustrate {

using Colour = std::array<std::uint8_t, 4>;  // red, green, blue, alpha; encoded as in sRGB

// Stroke i is image[offsets[i] .. offsets[i + 1]); closed strokes do not repeat their first point.
struct RoundStrokes {
  const ImagePoints& image;                 // (p) px
  const std::vector<float>& widths;         // (p) px
  const std::vector<int>& offsets;          // (s + 1)
  const std::vector<std::uint8_t>& closed;  // (s)
  const std::vector<Colour>& colours;       // (s) of the ink; its alpha is that of the whole stroke
};

// (height * width) strokes in this order on paper, painted over each other as they are encoded.
// Paper may be transparent. Parts outside of the picture, and points that are not finite, leave
// nothing. threads: 0 = all cores; the same bytes at any number. Throws Cancelled.
std::vector<Colour> rasterise(const RoundStrokes& strokes, int width, int height,
                              const Colour& paper, int threads, const Progress& progress = {});

}  // namespace illustrate
