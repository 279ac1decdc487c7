#include <gtest/gtest.h>

#include <limits>

#include "core/errors.h"
#include "tests/cpp/cameras.h"
#include "tests/cpp/shapes.h"
#include "tone/step_along.h"
#include "tone/tone_regions.h"

namespace illustrate {
namespace {

// --- light

TEST(Light, HeadlightIsTheCosineToTheEye) {
  const Camera camera = cameras::orthographic(Vec3::UnitZ(), 2);
  const Vec3 normal = Vec3(std::sin(0.5), 0, std::cos(0.5));
  EXPECT_NEAR(brightness({}, camera, Vec3::Zero(), normal), std::cos(0.5), 1e-12);
  EXPECT_NEAR(brightness({Light{}}, camera, Vec3::Zero(), normal), std::cos(0.5), 1e-12);
  EXPECT_NEAR(brightness({}, camera, Vec3::Zero(), -normal), std::cos(0.5), 1e-12)
      << "the normal is turned to the eye";
}

TEST(Light, SunsAddUpToWhite) {
  const Camera camera = cameras::orthographic(Vec3::UnitZ(), 2);
  Light sun;
  sun.kind = LightKind::sun;
  sun.vector = Vec3(0, 3, 4);
  sun.strength = 0.5;
  EXPECT_NEAR(brightness({sun}, camera, Vec3::Zero(), Vec3::UnitZ()), 0.4, 1e-12);
  EXPECT_NEAR(brightness({sun, sun}, camera, Vec3::Zero(), Vec3::UnitZ()), 0.8, 1e-12);
  EXPECT_EQ(brightness({sun, sun, sun}, camera, Vec3::Zero(), Vec3::UnitZ()), 1);
  sun.vector = -Vec3::UnitZ();
  EXPECT_EQ(brightness({sun}, camera, Vec3::Zero(), Vec3::UnitZ()), 0);
}

TEST(Light, LampsHaveLobesAndNoFallOff) {
  const Camera camera = cameras::orthographic(Vec3::UnitZ(), 2);
  Light lamp;
  lamp.kind = LightKind::point;
  lamp.vector = Vec3(1, 0, 1);
  EXPECT_NEAR(brightness({lamp}, camera, Vec3::Zero(), Vec3::UnitZ()), std::sqrt(0.5), 1e-12);
  lamp.vector *= 100;
  EXPECT_NEAR(brightness({lamp}, camera, Vec3::Zero(), Vec3::UnitZ()), std::sqrt(0.5), 1e-12);
  lamp.kind = LightKind::area;  // shines down: its own cosine comes on top
  EXPECT_NEAR(brightness({lamp}, camera, Vec3::Zero(), Vec3::UnitZ()), 0.5, 1e-12);
  lamp.kind = LightKind::spot;
  lamp.angle_rad = pi / 3;
  EXPECT_NEAR(brightness({lamp}, camera, Vec3::Zero(), Vec3::UnitZ()), 0.5, 1e-12);
  lamp.angle_rad = pi / 5;
  EXPECT_EQ(brightness({lamp}, camera, Vec3::Zero(), Vec3::UnitZ()), 0) << "outside the cone";
  lamp.vector = Vec3::Zero();
  EXPECT_EQ(brightness({lamp}, camera, Vec3::Zero(), Vec3::UnitZ()), 0) << "in the lamp itself";
}

TEST(Light, BadFieldsAreNamed) {
  Light light;
  light.strength = -1;
  try {
    validate(light, 3);
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_NE(std::string(error.what()).find("lights[3].strength"), std::string::npos);
  }
  light = Light{};
  light.kind = LightKind::sun;
  EXPECT_THROW(validate(light, 0), InvalidInput);
  light.kind = LightKind::spot;
  EXPECT_THROW(validate(light, 0), InvalidInput);
  light.kind = LightKind::point;
  light.vector.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(validate(light, 0), InvalidInput);
  light = Light{};
  EXPECT_NO_THROW(validate(light, 0));
}

TEST(StepAlong, SamplesAreEvenAndInTheFrame) {
  const std::vector<Vec2> line{{-1e7, 5}, {4, 5}, {4, 1e7}};
  std::vector<Vec2> samples;
  step_along({line.data(), line.size()}, false, 0.5, Frame{Vec2::Zero(), Vec2(10, 10)},
             [&](const CurveSample& sample) { samples.push_back(sample.image); });
  ASSERT_GE(samples.size(), 16U);
  EXPECT_LE(samples.size(), 19U);
  for (const Vec2& sample : samples) {
    EXPECT_TRUE(sample.minCoeff() >= -1e-6 && sample.maxCoeff() <= 10 + 1e-6);
  }
}

// --- tone

TEST(ToneRegions, LevelsOfASphereUnderAHeadlight) {
  const Surface sphere = shapes::sphere_surface(1, 5);
  const Camera camera = cameras::orthographic(Vec3::UnitZ(), 1.25, 400);
  const VisibleImage image = render_visible(sphere, camera, 1, {}, 1);
  ToneOptions options;
  const ToneMap tone = tone_levels({sphere, image, camera, {}}, options);
  const double area = pi * 160 * 160;
  const auto share = [&](Tone level) {
    return double(std::count(tone.level.begin(), tone.level.end(), level)) / area;
  };
  const double high = 0.85 * 0.85, low = 0.45 * 0.45;
  EXPECT_NEAR(share(Tone::highlight), 1 - high, 0.005);  // brightness^2 = 1 - r^2
  EXPECT_NEAR(share(Tone::midtone), high - low, 0.005);
  EXPECT_NEAR(share(Tone::shadow), low, 0.01);
  EXPECT_EQ(tone.level[0], Tone::nothing);
  EXPECT_EQ(tone.brightness[0], 0);
  EXPECT_EQ(tone.cell_of(Vec2(399.5, 1.5)), 799);

  options.highlight_threshold = options.shadow_threshold = 1;
  const ToneMap dark = tone_levels({sphere, image, camera, {}}, options);
  EXPECT_EQ(std::count(dark.level.begin(), dark.level.end(), Tone::midtone), 0);
  EXPECT_EQ(std::count(dark.level.begin(), dark.level.end(), Tone::highlight), 0);
}

TEST(ToneRegions, BadOptionsAreNamed) {
  ToneOptions options;
  options.undercut_px = -1;
  EXPECT_THROW(validate(options), InvalidInput);
  options = {};
  options.highlight_threshold = std::nan("");
  EXPECT_THROW(validate(options), InvalidInput);
  EXPECT_NO_THROW(validate(ToneOptions{}));
}

}  // namespace
}  // namespace illustrate
