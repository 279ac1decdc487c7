// How much of the light that falls on a mesh it throws back: its own lightness, beside the scene's
// light.
#pragma once

#include <memory>

#include "core/types.h"

namespace illustrate {

// What is read outside of a texture: the texture again, mirrored or not; its border; black.
enum class Wrap : std::uint8_t { repeat, mirror, extend, clip };

// An image as luminance, linear in light, each texel at its centre, linear in between.
class Texture {
 public:
  // luminance: (height * width), rows upwards from v = 0; what is negative or not finite counts as
  // black. Throws InvalidInput where the sizes do not fit.
  Texture(int width, int height, std::vector<float> luminance, Wrap wrap);

  // The mean over a square of `texels` texels round a place in [0, 1] x [0, 1], roughly: from a
  // pyramid of images each half as large as the one before.
  double mean_at(const Vec2& uv, double texels) const;
  // Texels that a distance of 1 in uv has, in the geometric mean of both directions.
  double size() const;

 private:
  struct Level {
    int width, height;
    std::vector<float> values;
  };
  double at(const Level& level, const Vec2& uv) const;
  double texel(const Level& level, int column, int row) const;

  std::vector<Level> levels_;
  Wrap wrap_;
};

// The share of the light that comes back is the product of what is given, cut off at 0 and 1; all
// of it where nothing is given.
struct Reflectance {
  std::vector<double> faces;    // (f) or empty
  std::vector<double> corners;  // (corners) or empty; linear in between
  std::vector<Vec2> uv;         // (corners) or empty, as textures are
  std::vector<std::shared_ptr<const Texture>> textures;
  std::vector<int> face_textures;  // (f) which of the textures, none: none; or empty

  bool is_white() const { return faces.empty() && corners.empty() && face_textures.empty(); }
};

}  // namespace illustrate
