// Levels: thresholds, shares of the visible area, shadows, extra levels.
#include <gtest/gtest.h>

#include "core/errors.h"
#include "tests/cpp/cameras.h"
#include "tests/cpp/shapes.h"
#include "tests/cpp/tone/sun.h"
#include "tone/tone_regions.h"

namespace illustrate {
namespace {

double share_of(const ToneMap& tone, Tone level) {
  const auto seen = std::count_if(tone.level.begin(), tone.level.end(),
                                  [](Tone other) { return other != Tone::nothing; });
  return double(std::count(tone.level.begin(), tone.level.end(), level)) / double(seen);
}

struct Scene {
  Surface surface;
  Camera camera;
  Bvh bvh{surface.positions, surface.triangles};
  VisibleImage visible = render_visible(surface, camera, 1, {}, 1);

  ToneMap tone(const std::vector<Light>& lights, const ToneOptions& options,
               const std::vector<std::uint8_t>& unhatched = {}) const {
    return tone_levels({surface, visible, camera, lights, &bvh, unhatched}, options);
  }
};

Scene ball(int level = 5) {
  return {shapes::sphere_surface(1, level), cameras::orthographic(Vec3::UnitZ(), 1.25, 400)};
}

// Of a disk, the share beyond a line at distance d of its centre.
double segment_share(double d) { return (std::acos(d) - d * std::sqrt(1 - d * d)) / pi; }

TEST(Levels, SphereUnderOneSun) {
  const Scene scene = ball();
  for (const bool shadows : {false, true}) {
    ToneOptions options;
    options.cast_shadows = shadows;
    const ToneMap tone = scene.tone({sun(Vec3(3, 0, 0))}, options);  // brightness is x
    EXPECT_NEAR(share_of(tone, Tone::highlight), segment_share(0.85), 0.002);
    EXPECT_NEAR(share_of(tone, Tone::midtone), segment_share(0.45) - segment_share(0.85), 0.002);
    const auto lit = std::count_if(tone.brightness.begin(), tone.brightness.end(),
                                   [](float b) { return b > 0; });
    EXPECT_NEAR(double(lit), pi / 2 * 160 * 160, 170) << "up to the terminator, x = 0";
  }
}

// A surface throws no shadow on itself where the light goes out smoothly, however coarse it is.
TEST(Levels, TheTerminatorHasNoAcne) {
  for (const int level : {2, 3, 5}) {
    const Scene scene = ball(level);
    for (const Vec3& towards : {Vec3(1, 0, 0), Vec3(1, 0.3, -0.4), Vec3(-0.2, 1, 0.5)}) {
      ToneOptions options;
      const ToneMap open = scene.tone({sun(towards)}, options);
      options.cast_shadows = true;
      EXPECT_EQ(scene.tone({sun(towards)}, options).brightness, open.brightness) << level;
    }
  }
}

Scene box_over_floor() {
  PolygonMesh box = shapes::cube();
  const double half = box.positions[0].cwiseAbs().maxCoeff();
  for (Vec3& p : box.positions) p = 0.3 / half * p + Vec3(0, 0, 0.4);  // z in [.1, .7]
  return {shapes::joined(shapes::plain_surface(shapes::plane(4, 4)), shapes::plain_surface(box)),
          cameras::orthographic(Vec3::UnitZ(), 1, 200)};
}

TEST(Levels, ShadowOfABoxHasItsOutline) {
  const Scene scene = box_over_floor();
  ToneOptions options;
  options.cast_shadows = true;
  const ToneMap tone = scene.tone({sun(Vec3(1, 0, 1))}, options);
  int shadowed = 0;
  for (int cell = 0; cell < 200 * 200; ++cell) {
    if (scene.surface.object_of(scene.visible.triangle[idx(cell)]) != 0) continue;
    const int row = cell / 200, column = cell % 200;
    const double x = (column + 0.5) / 100 - 1, y = 1 - (row + 0.5) / 100;
    const bool is_inside = x > -1 && x < -0.3 && std::abs(y) < 0.3;  // from -.3 - .7
    EXPECT_NEAR(tone.brightness[idx(cell)], is_inside ? 0 : std::sqrt(0.5), 1e-6) << x << " " << y;
    shadowed += is_inside ? 1 : 0;
  }
  EXPECT_EQ(shadowed, 70 * 60);

  Light shadowless = sun(Vec3(1, 0, 1));
  shadowless.casts_shadows = false;
  EXPECT_EQ(scene.tone({shadowless}, options).brightness,
            scene.tone({shadowless}, ToneOptions{}).brightness);
}

TEST(Levels, ShadowsAreTheSameAtAnyThreadCount) {
  const Scene scene = box_over_floor();
  Light panel;
  panel.kind = LightKind::area;
  panel.vector = Vec3(0.7, 0.2, 2);
  panel.edge_u = Vec3(0.6, 0, 0);
  panel.edge_v = Vec3(0, 0.4, 0);
  ToneOptions options;
  options.cast_shadows = true;
  options.threads = 1;
  const ToneMap one = scene.tone({panel}, options);
  options.threads = 3;
  EXPECT_EQ(scene.tone({panel}, options).brightness, one.brightness);
  const auto penumbra = std::count_if(one.brightness.begin(), one.brightness.end(),
                                      [](float light) { return light > 0.02F && light < 0.4F; });
  EXPECT_GT(penumbra, 500);
}

TEST(Levels, SharesDivideTheVisibleArea) {
  const Scene scene = ball();
  ToneOptions options;
  options.highlight_share = 0.25;
  options.shadow_share = 0.4;
  const ToneMap tone = scene.tone({}, options);  // brightness^2 = 1 - r^2
  EXPECT_NEAR(share_of(tone, Tone::highlight), 0.25, 1e-4);
  EXPECT_NEAR(share_of(tone, Tone::shadow), 0.4, 1e-4);
  EXPECT_NEAR(tone.highlight_threshold, std::sqrt(0.75), 0.003);
  EXPECT_NEAR(tone.shadow_threshold, std::sqrt(0.4), 0.003);

  Light strong;
  strong.strength = 30;  // white nearly everywhere, yet in the same order
  EXPECT_EQ(scene.tone({strong}, options).level, tone.level);
}

TEST(Levels, SharesAtTheirLimits) {
  const Scene scene = ball(3);
  ToneOptions options;
  options.highlight_share = 0;
  options.shadow_share = 1;
  EXPECT_EQ(share_of(scene.tone({}, options), Tone::shadow), 1);
  options.highlight_share = 1;
  options.shadow_share = 0;
  EXPECT_EQ(share_of(scene.tone({}, options), Tone::highlight), 1);
  options.shadow_share.reset();  // the other threshold stays as it is
  options.highlight_share = 0.1;
  EXPECT_NEAR(share_of(scene.tone({}, options), Tone::highlight), 0.1, 1e-3);
  EXPECT_EQ(scene.tone({}, options).shadow_threshold, 0.45);
}

TEST(Levels, EqualLightIsNotTornApart) {
  const Scene flat{shapes::plain_surface(shapes::plane(2, 2)),
                   cameras::orthographic(Vec3::UnitZ(), 0.9, 64)};
  ToneOptions options;
  options.highlight_share = 0.3;
  options.shadow_share = 0.3;
  EXPECT_EQ(share_of(flat.tone({}, options), Tone::midtone), 1);
  options.highlight_share = 0.6;
  EXPECT_EQ(share_of(flat.tone({}, options), Tone::highlight), 1);
}

TEST(Levels, ObjectsThatAreNotHatchedDoNotCount) {
  const Scene scene = box_over_floor();
  ToneOptions options;
  options.highlight_share = 0.3;
  const std::vector<Light> lights{sun(Vec3(0.2, 0.1, 1))};
  const auto floor_highlights = [&](const ToneMap& tone) {
    int count = 0;
    for (std::size_t cell = 0; cell < tone.level.size(); ++cell) {
      const int object = scene.surface.object_of(scene.visible.triangle[cell]);
      count += object == 0 && tone.level[cell] == Tone::highlight ? 1 : 0;
    }
    return count;
  };
  const int box = 60 * 60, all = 200 * 200;  // cells
  EXPECT_EQ(floor_highlights(scene.tone(lights, options, {0, 1})), 0) << "all floor is alike";
  options.highlight_share = 0.6;
  EXPECT_EQ(floor_highlights(scene.tone(lights, options, {0, 1})), all - box);
  const ToneMap of_box = scene.tone(lights, options, {1, 0});
  const auto bright = std::count(of_box.level.begin(), of_box.level.end(), Tone::highlight);
  EXPECT_NEAR(double(bright - floor_highlights(of_box)) / box, 0.6, 0.01);
}

TEST(Levels, ExtraLevelsDivideTheShadows) {
  const Scene scene = ball();
  ToneOptions options;
  options.extra_levels = 3;
  options.shadow_threshold = 0.4;
  const ToneMap tone = scene.tone({}, options);
  const double area = pi * 160 * 160;
  for (int extra = 1; extra <= 3; ++extra) {
    const auto cells = std::count(tone.extra.begin(), tone.extra.end(), extra);
    const double high = 0.4 - 0.1 * extra, low = extra == 3 ? 0 : high - 0.1;
    EXPECT_NEAR(double(cells) / area, high * high - low * low, 0.004) << extra;
  }
  options.shadow_share = 0.4;
  const ToneMap even = scene.tone({}, options);
  for (int extra = 1; extra <= 3; ++extra) {
    const auto cells = std::count(even.extra.begin(), even.extra.end(), extra);
    EXPECT_NEAR(double(cells) / area, 0.1, 0.002) << extra;
  }
  EXPECT_TRUE(scene.tone({}, ToneOptions{}).extra.empty());
}

TEST(Levels, ExtraTonesAreLevelsOfTheirOwn) {
  ToneMap tone;
  tone.level = {Tone::shadow, Tone::shadow, Tone::shadow,
                Tone::shadow, Tone::shadow, Tone::highlight};
  tone.extra = {0, 1, 2, 3, 3, 0};
  tone.band = {Band::nothing, Band::nothing,   Band::undercut,
               Band::nothing, Band::mach_band, Band::undercut};
  const ToneMap extra = extra_tones(tone);
  EXPECT_EQ(extra.level, (std::vector<Tone>{Tone::nothing, Tone::midtone, Tone::shadow,
                                            Tone::shadow, Tone::nothing, Tone::nothing}));
  EXPECT_EQ(extra.band, (std::vector<Band>{Band::nothing, Band::nothing, Band::nothing,
                                           Band::undercut, Band::nothing, Band::nothing}));
}

TEST(Levels, BadOptionsAreNamed) {
  const auto complaint = [](const ToneOptions& options) -> std::string {
    try {
      validate(options);
    } catch (const InvalidInput& error) {
      return error.what();
    }
    return "";
  };
  ToneOptions options;
  options.highlight_share = 1.2;
  EXPECT_NE(complaint(options).find("highlight_share"), std::string::npos);
  options.highlight_share = 0.7;
  options.shadow_share = 0.7;
  EXPECT_NE(complaint(options).find("together"), std::string::npos);
  options = {};
  options.shadow_share = std::nan("");
  EXPECT_NE(complaint(options).find("shadow_share"), std::string::npos);
  options = {};
  options.extra_levels = 4;
  EXPECT_NE(complaint(options).find("extra_levels"), std::string::npos);
}

}  // namespace
}  // namespace illustrate
