// Where a drawing shows what the one before it showed, to the bit. There hatches stay as they were:
// nothing moves beside what moves, and a view that does not change is drawn the same again, though
// every drawing goes on evening out the last one.
#pragma once

#include <cstdint>

#include "core/types.h"

namespace illustrate {

struct HatchScene;
struct HatchOptions;

// What a view shows in each square tile of the image, two spacings wide, as a number that is
// another one where anything differs that hatches depend on: the camera, what was asked for, the
// triangles that are seen with the directions on them, tones, critical curves.
struct ImageTiles {
  double tile_px = 0;
  int columns = 0, rows = 0;
  std::vector<std::uint64_t> contents;
};

ImageTiles image_tiles(const HatchScene& scene, const HatchOptions& options, int threads);

class RestingPlaces {
 public:
  RestingPlaces(const ImageTiles& last, const ImageTiles& now);

  // Whether nothing has changed in the tile of an image point and the eight around it.
  bool rests(const Vec2& image) const;

 private:
  double tile_px_;
  int columns_, rows_;
  std::vector<std::uint8_t> rests_;  // (tiles) empty: nowhere
};

}  // namespace illustrate
