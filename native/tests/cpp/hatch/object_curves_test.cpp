#include "hatch/curves/object_curves.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/cpp/hatch/hatch_scene.h"

namespace illustrate {
namespace {

using namespace hatching;

void expect_same(const CurvesOfObject& a, const CurvesOfObject& b) {
  const SurfaceCurves of_a{a.curves(), 0, a.seeds(), 0, {}}, of_b{b.curves(), 0, b.seeds(), 0, {}};
  EXPECT_TRUE(is_start_of(of_a, of_b) && is_start_of(of_b, of_a));
  EXPECT_EQ(of_a.seeds.size(), of_b.seeds.size());
  EXPECT_DOUBLE_EQ(a.area(), b.area());
}

// A torus, and one that is twice as large.
TEST(ObjectCurves, OfObjectsThatShareASurfaceAreMadeOnce) {
  const Surface torus = shapes::torus_surface(1, 0.4, 40, 20);
  Surface large = torus;
  for (Vec3& p : large.positions) p *= 2;
  Surface two = shapes::joined(torus, large);
  two.object_is_smooth.assign(2, 1);
  Instances instances;
  instances.originals = {0, 0};
  instances.placements.resize(2);
  instances.placements[1].scale = 2;
  const CrossField field = field_of(torus, round_z);
  CrossField field_of_two = field;
  shapes::append(field_of_two.directions, field.directions);
  ObjectCurves shared(torus, field, instances, triangle_areas(two)), separate(two, field_of_two);
  for (const double radius : {0.2, 0.05}) {
    const CurvesOfObjects ours = shared.down_to({radius, 2 * radius});
    const CurvesOfObjects theirs = separate.down_to({radius, 2 * radius});
    EXPECT_EQ(ours[0].shared, ours[1].shared);
    for (const std::size_t o : {0, 1}) expect_same(ours[o], theirs[o]);
  }
  const double infinite = std::numeric_limits<double>::infinity();
  const CurvesOfObjects one = shared.down_to({infinite, 0.1}, {0, 1});
  EXPECT_FALSE(one[0]);
  EXPECT_TRUE(one[1].curves().empty());
  EXPECT_FALSE(one[1].seeds().empty());
}

}  // namespace
}  // namespace illustrate
