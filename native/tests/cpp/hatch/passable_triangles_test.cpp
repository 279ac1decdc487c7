#include "hatch/view/passable_triangles.h"

#include <gtest/gtest.h>

#include <random>

#include "surface/locate.h"
#include "tests/cpp/hatch/hatch_scene.h"

namespace illustrate {
namespace {

using namespace hatching;

Scene torus_from(const Camera& eye) {
  return scene_of(shapes::torus_surface(1, 0.4, 90, 40), eye, round_z);
}

// Tones and undercuts in patches of 25 cells, and the rest white.
void tone_in_patches(Scene& scene, unsigned seed) {
  std::mt19937 random(seed);
  const int across = scene.tone.width / 25 + 1;
  std::vector<unsigned> patches(idx(across) * idx(scene.tone.height / 25 + 1));
  for (unsigned& patch : patches) patch = random() % 4;
  for (std::size_t cell = 0; cell < scene.tone.level.size(); ++cell) {
    const int column = static_cast<int>(cell) % scene.tone.width;
    const int row = static_cast<int>(cell) / scene.tone.width;
    const unsigned patch = patches[idx(row / 25 * across + column / 25)];
    if (scene.tone.level[cell] != Tone::nothing && patch > 0) {
      scene.tone.level[cell] = Tone::highlight;
    }
    scene.tone.band[cell] = patch == 2 ? Band::undercut : Band::nothing;
  }
}

HatchPoint point_at(const Scene& scene, int triangle, double b1, double b2) {
  const SurfacePoint on{triangle, b1, b2};
  const Vec3 p = position_at(scene.surface, on), mapped = apply(image_map(scene.camera), p);
  return {p, on, mapped.head<2>() / mapped[2]};
}

// How many triangles are said to let nothing pass; fails where something passes all the same.
std::size_t impassable(const Scene& scene, Area where) {
  const HatchScene view = scene.view();
  const HatchArea area(view);
  const std::vector<std::uint8_t> passable = passable_triangles(view, where);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> share(0, 1);
  std::size_t count = 0;
  for (std::size_t t = 0; t < passable.size(); ++t) {
    count += passable[t] == 0;
    for (int i = 0; i < 10; ++i) {
      const double a = share(random), b = share(random) * (1 - a);
      const bool passes = area.may_pass(point_at(scene, static_cast<int>(t), a, b), where);
      EXPECT_TRUE(passable[t] || !passes) << "triangle " << t;
    }
  }
  return count;
}

class PassableTriangles : public testing::TestWithParam<Camera> {};

TEST_P(PassableTriangles, LeaveOutNothingThatMayPass) {
  Scene scene = torus_from(GetParam());
  impassable(scene, Area::hatched);
  for (unsigned seed = 0; seed < 3; ++seed) {
    tone_in_patches(scene, seed);
    impassable(scene, Area::hatched);
    impassable(scene, Area::undercut);
  }
}

// From outside, from far away, flat on, nearby with a part behind the eye, and from inside the
// tube.
INSTANTIATE_TEST_SUITE_P(
    Cameras, PassableTriangles,
    testing::Values(cameras::perspective({0, -3, 4}, Vec3::Zero(), 0.1, 40, 400),
                    cameras::perspective({0, -60, 80}, Vec3::Zero(), 0.1, 40, 400),
                    cameras::orthographic({1, 2, 3}, 0.9, 300),
                    cameras::perspective({0, 0.7, 0.5}, {0, -1, 0}, 0.3, 60, 400),
                    cameras::perspective({1, 0, 0}, {0.9, 0.5, 0}, 0.1, 90, 400)));

TEST(PassableTriangles, LeaveOutWhatIsHiddenOrOutsideOrWhite) {
  const Scene seen = torus_from(cameras::perspective({0, -3, 4}, Vec3::Zero(), 0.1, 40, 400));
  const std::size_t all = seen.surface.triangles.size();
  EXPECT_GT(impassable(seen, Area::hatched), all / 8);
  EXPECT_EQ(impassable(seen, Area::undercut), all);
  const Scene beside = torus_from(cameras::perspective({9, 0, 0}, {0, 9, 0}, 0.1, 40, 400));
  EXPECT_EQ(impassable(beside, Area::hatched), all);
}

}  // namespace
}  // namespace illustrate
