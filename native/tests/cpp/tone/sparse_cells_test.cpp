#include "tone/sparse_cells.h"

#include <gtest/gtest.h>

#include <atomic>

#include "tests/cpp/cameras.h"
#include "tests/cpp/shapes.h"

namespace illustrate {
namespace {

constexpr int image_px = 202;  // of one cell each, no multiple of a square's side

struct Seen {
  Surface surface;
  Camera camera;
  VisibleImage visible = render_visible(surface, camera, 1, {}, 1);
  mutable std::atomic<int> asked{0};

  explicit Seen(Surface seen, const Camera& by) : surface(std::move(seen)), camera(by) {}

  template <typename Value>
  std::vector<float> sparsely(const Value& value, int threads = 2) const {
    asked = 0;
    return ask_sparsely(
        surface, visible, camera,
        [&](std::size_t cell) {
          ++asked;
          return value(static_cast<int>(cell) % image_px, static_cast<int>(cell) / image_px);
        },
        threads);
  }

  template <typename Value>
  std::vector<float> all(const Value& value) const {
    std::vector<float> at(visible.triangle.size(), 0);
    for (int cell = 0; cell < image_px * image_px; ++cell) {
      if (visible.triangle[idx(cell)] == none) continue;
      at[idx(cell)] = static_cast<float>(value(cell % image_px, cell / image_px));
    }
    return at;
  }
};

const Seen& floor_seen() {
  static const Seen seen(shapes::plain_surface(shapes::plane(4, 4)),
                         cameras::orthographic(Vec3(0, 0, 1), 1, image_px));
  return seen;
}

TEST(SparseCells, WhatIsLinearIsExactForASixteenthOfTheCells) {
  const auto value = [](int x, int y) { return (x + 2 * y) / 1000.0; };
  const std::vector<float> found = floor_seen().sparsely(value), all = floor_seen().all(value);
  for (std::size_t cell = 0; cell < all.size(); ++cell) EXPECT_NEAR(found[cell], all[cell], 1e-6);
  EXPECT_LE(floor_seen().asked, image_px * image_px / 14);
}

TEST(SparseCells, ErrorsOfWhatIsSmoothAreThoseOfItsCurvature) {
  const auto value = [](int x, int y) {
    return 0.5 + 0.5 * std::sin(x / 25.0) * std::cos(y / 30.0);
  };
  const std::vector<float> found = floor_seen().sparsely(value), all = floor_seen().all(value);
  for (std::size_t cell = 0; cell < all.size(); ++cell) {
    EXPECT_NEAR(found[cell], all[cell], 4 * 4 / 8.0 / 25 / 25);  // squares of 4, both ways
  }
}

TEST(SparseCells, JumpsAreWhereTheyAre) {
  const auto value = [](int x, int y) { return 3 * x + y < 300 ? 0.0 : 1.0; };
  EXPECT_EQ(floor_seen().sparsely(value), floor_seen().all(value));
  EXPECT_LE(floor_seen().asked, image_px * image_px / 4);
}

// A strip of two cells that leaves a wide dark place, and passes between the corners of squares.
TEST(SparseCells, NarrowThingsAreFollowedFromWhereTheyBegin) {
  const auto value = [](int x, int y) {
    return x < 50 || (y - (x - 50) / 8) / 2 == 50 ? 0.0 : 1.0;
  };
  EXPECT_EQ(floor_seen().sparsely(value), floor_seen().all(value));
}

TEST(SparseCells, ObjectsDoNotMixWithWhatIsBehind) {
  const Seen seen(
      shapes::joined(shapes::plain_surface(shapes::plane(4, 4)), shapes::sphere_surface(0.4, 4)),
      cameras::orthographic(Vec3(0.3, 0.2, 1), 1, image_px));
  const auto value = [&](int x, int y) {
    const int triangle = seen.visible.triangle[idx(y * image_px + x)];
    return seen.surface.object_of(triangle) == 0 ? 0.5 : 0.55;
  };
  EXPECT_EQ(seen.sparsely(value), seen.all(value));
}

TEST(SparseCells, PartsOfOneObjectDoNotMix) {
  Surface plates = shapes::joined(
      shapes::plain_surface(shapes::plane(4, 4)),
      shapes::plain_surface(shapes::moved(shapes::plane(1, 1), Vec3(0.6, 0.5, 0.5))));
  std::fill(plates.triangle_objects.begin(), plates.triangle_objects.end(), 0);
  const Seen seen(std::move(plates), cameras::orthographic(Vec3(0.3, 0.2, 1), 1, image_px));
  const auto value = [&](int x, int y) {
    return seen.visible.triangle[idx(y * image_px + x)] < 32 ? 0.5 : 0.55;
  };
  EXPECT_EQ(seen.sparsely(value), seen.all(value));
}

TEST(SparseCells, SlantedPlanesAreOnePiece) {
  const Seen seen(shapes::plain_surface(shapes::plane(50, 50)),
                  cameras::perspective(Vec3(0, -0.5, 0.2), Vec3(0, -0.3, 0), 0.01, 40, image_px));
  seen.sparsely([](int, int) { return 0.5; });
  EXPECT_LE(seen.asked, image_px * image_px / 14);
}

TEST(SparseCells, ThreadsChangeNothing) {
  const auto value = [](int x, int y) { return std::abs(std::sin(x * y / 900.0)); };
  EXPECT_EQ(floor_seen().sparsely(value, 1), floor_seen().sparsely(value, 3));
}

}  // namespace
}  // namespace illustrate
