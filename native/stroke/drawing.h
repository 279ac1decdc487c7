// The finished drawing: strokes with width, in the image and in the world.
#pragma once

#include <memory>

#include "core/ragged.h"
#include "core/report.h"
#include "core/types.h"

namespace illustrate {

struct ImageTiles;
struct Surface;

// Strokes as they live through the frames of a sequence (stroke/tracks.h).
struct StrokeTracks {
  int frame = 0;               // of the sequence
  std::vector<int> ids;        // (s) what is one stroke in two frames has one number
  std::vector<int> births;     // (s) the first frame of each
  std::vector<double> starts;  // (s) px: how far along its stroke the first point counts as
  std::vector<int> deaths;     // ids of the last frame that are in this one no more, ascending
  int next_id = 0;             // greater than all so far
};

// Stroke i is points[offsets[i] .. offsets[i + 1]); closed strokes do not repeat their first point.
struct Drawing {
  Points points;                     // (p) world
  ImagePoints image;                 // (p) px
  std::vector<float> widths;         // (p) px
  std::vector<SurfacePoint> on;      // (p) where on the surface
  std::vector<int> offsets{0};       // (s + 1)
  std::vector<Kind> kinds;           // (s)
  std::vector<std::uint8_t> closed;  // (s)
  std::vector<int> objects;          // (s)
  std::vector<int> invisibility;     // (s) 0 = visible, else the number of layers in front
  std::vector<int> pens;             // (s) as the styles of objects and materials have it
  StrokeTracks tracks;

  // What the next frame starts from: the surface that `on` is of, the names of its objects, its
  // hatches before they were cut to their tones (Hatches::placed), and what they were placed on
  // (hatch/view/resting.h).
  std::shared_ptr<const Surface> surface;
  std::vector<std::string> object_names;
  Ragged<SurfacePoint> placed;
  std::shared_ptr<const ImageTiles> tiles;
};

}  // namespace illustrate
