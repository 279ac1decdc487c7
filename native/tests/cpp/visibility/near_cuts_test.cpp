// Scenes of which a part goes on past the camera: what it hides has no outline in front.
#include <gtest/gtest.h>

#include "tests/cpp/blocks.h"
#include "tests/cpp/cameras.h"

namespace illustrate {
namespace {

// A square in the plane z = 0 round the origin.
PolygonMesh ground(double half_width, int quads) {
  PolygonMesh plane = shapes::plane(quads, quads);
  for (Vec3& p : plane.positions) p *= 2 * half_width;
  const Vec3 middle = (plane.positions.front() + plane.positions.back()) / 2;
  for (Vec3& p : plane.positions) p -= middle;
  plane.cage = false;
  return plane;
}

// Of what is seen of an object: the part of its length for which `is_hidden` holds.
template <class Test>
double length_px(const Drawing& drawing, int object, const Test& is_hidden) {
  double length = 0;
  for (std::size_t s = 0; s < drawing.kinds.size(); ++s) {
    if (drawing.objects[s] != object) continue;
    for (int i = drawing.offsets[s]; i + 1 < drawing.offsets[s + 1]; ++i) {
      const Vec3 middle = (drawing.points[idx(i)] + drawing.points[idx(i) + 1]) / 2;
      if (is_hidden(middle)) length += (drawing.image[idx(i) + 1] - drawing.image[idx(i)]).norm();
    }
  }
  return length;
}

TEST(NearCuts, WhatIsBelowAGroundThatPassesTheCameraIsHidden) {
  const auto is_below = [](const Vec3& p) { return p.z() < -0.02; };
  const auto is_above = [](const Vec3& p) { return p.z() > 0; };
  for (const double half_width : {2.0, 8.0, 60.0}) {
    for (const double near : {0.1, 0.001}) {
      const Camera camera = cameras::perspective(Vec3(1, -6, 2), Vec3(0, 0, 0), near);
      const Drawing drawing =
          blocks::drawn({ground(half_width, 3), shapes::uv_sphere_mesh(0.6, 32, 16),
                         blocks::block(Vec3(0.9, -0.4, -0.3), Vec3(1.7, 0.4, 0.5))},
                        camera);
      for (const int object : {1, 2}) {
        EXPECT_GT(length_px(drawing, object, is_above), 200);
        EXPECT_LT(length_px(drawing, object, is_below), 2)
            << "object " << object << ", ground " << half_width << ", near " << near;
      }
    }
  }
}

TEST(NearCuts, ABlockBesideTheCameraHidesItsOwnBack) {
  const Camera camera = cameras::perspective(Vec3(0, -4, 1), Vec3(0, 4, 1));
  const Drawing drawing = blocks::drawn({blocks::block(Vec3(1, -3.5, -2.5), Vec3(8, 3.5, 4.5)),
                                         blocks::block(Vec3(-0.5, 2.5, 0), Vec3(0.5, 3.5, 1))},
                                        camera);
  // Its left face alone is turned to the camera, and its far edges are those of that face.
  EXPECT_GT(length_px(drawing, 0, [](const Vec3& p) { return p.x() < 1.01; }), 200);
  EXPECT_LT(length_px(drawing, 0, [](const Vec3& p) { return p.x() > 1.01; }), 2);
}

}  // namespace
}  // namespace illustrate
