// An image in place of lights.
#include <gtest/gtest.h>

#include "tests/cpp/cameras.h"
#include "tests/cpp/shapes.h"
#include "tone/tone_regions.h"

namespace illustrate {
namespace {

constexpr int size_px = 64;

// A ball in the middle of the picture, lit by an image.
ToneMap lit_by(const std::shared_ptr<const Texture>& image, ToneOptions options = {}) {
  const Surface ball = shapes::sphere_surface(1, 3);
  const Camera camera = cameras::orthographic(Vec3(0.1, -1, 0.2), 1.2, size_px);
  options.image = image;
  options.mach_bands = options.undercuts = false;
  return tone_levels({ball, render_visible(ball, camera, 1, {}, 1), camera, {}}, options);
}

std::shared_ptr<const Texture> picture(int width, int height, std::vector<float> luminance) {
  return std::make_shared<const Texture>(width, height, std::move(luminance), Wrap::extend);
}

TEST(ToneImage, IsTheLightWhereSomethingIsSeen) {
  std::vector<float> rows;
  for (int i = 0; i < size_px * size_px; ++i)
    rows.push_back(static_cast<float>(i % size_px) / size_px);
  const ToneMap tone = lit_by(picture(size_px, size_px, rows));
  int seen = 0;
  for (int cell = 0; cell < size_px * size_px; ++cell) {
    const float there = tone.brightness[idx(cell)];
    if (tone.level[idx(cell)] == Tone::nothing) {
      EXPECT_EQ(there, 0);
      continue;
    }
    ++seen;
    EXPECT_NEAR(static_cast<double>(there), static_cast<double>(cell % size_px) / size_px, 1e-6);
  }
  EXPECT_GT(seen, 1500);
}

TEST(ToneImage, OfAnotherSizeFillsTheView) {
  const ToneMap tone = lit_by(picture(1, 2, {0.1F, 0.9F}));  // rows upwards
  EXPECT_GT(tone.brightness[idx(12 * size_px + 32)], 0.85F);
  EXPECT_LT(tone.brightness[idx(52 * size_px + 32)], 0.15F);
  std::vector<float> checks;
  for (int i = 0; i < 1024 * 1024; ++i) checks.push_back((i / 1024 + i) % 2 == 0 ? 1.0F : 0.0F);
  const ToneMap fine = lit_by(picture(1024, 1024, checks));
  EXPECT_NEAR(static_cast<double>(fine.brightness[idx(32 * size_px + 32)]), 0.5, 1e-6);
}

TEST(ToneImage, IsExposedAsLightsAre) {
  ToneOptions options;
  options.exposure = 2;
  const ToneMap tone = lit_by(picture(1, 1, {0.3F}), options);
  EXPECT_NEAR(static_cast<double>(tone.brightness[idx(32 * size_px + 32)]), 0.6, 1e-6);
}

}  // namespace
}  // namespace illustrate
