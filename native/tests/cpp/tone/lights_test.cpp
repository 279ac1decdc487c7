// Lights: what a point receives, and what reaches it.
#include <gtest/gtest.h>

#include "core/errors.h"
#include "mesh/bvh.h"
#include "tests/cpp/cameras.h"
#include "tests/cpp/shapes.h"
#include "tone/area_light.h"
#include "tone/shadows.h"

namespace illustrate {
namespace {

const Camera& above() {
  static const Camera camera = cameras::orthographic(Vec3::UnitZ(), 2);
  return camera;
}

// Radiance of a white floor below a lamp, x beside it.
double floor_light(const Light& light, double x) {
  return received(light, above(), Vec3(x, 0, 0), Vec3::UnitZ());
}

Light lamp(LightKind kind, double height, double strength) {
  Light light;
  light.kind = kind;
  light.vector = Vec3(0, 0, height);
  light.strength = strength;
  light.falloff_distance = 1;
  return light;
}

Light area_lamp(double height, double strength, double width, double length) {
  Light light = lamp(LightKind::area, height, strength);
  light.edge_u = width * Vec3::UnitX();
  light.edge_v = length * Vec3::UnitY();
  return light;
}

// The integral of the two cosines over the squared distance, by the midpoint rule.
double integrated(const Light& light, const Vec3& position, const Vec3& normal, int steps) {
  const Vec3 axis = light.direction.normalized();
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    for (int j = 0; j < steps; ++j) {
      const Vec3 ray = point_on(light, (i + 0.5) / steps, (j + 0.5) / steps) - position;
      const double distance = ray.norm();
      sum += std::max(0.0, ray.dot(normal)) * std::max(0.0, -ray.dot(axis)) / std::pow(distance, 4);
    }
  }
  return sum / (steps * steps);
}

TEST(Lights, ComeFromTheirMeanSide) {
  const auto of_kind = [](LightKind kind, const Vec3& vector) {
    Light light;
    light.kind = kind;
    light.vector = vector;
    return light;
  };
  const Light right = of_kind(LightKind::sun, Vec3(2, 0, 0)),
              head = of_kind(LightKind::head, Vec3::Zero());
  const auto side = [](const std::vector<Light>& lights) -> Vec3 {
    return light_side(lights, above(), Vec3::Zero());
  };
  EXPECT_EQ(side({}), Vec3::Zero());
  EXPECT_EQ(side({head}), Vec3::Zero());
  EXPECT_EQ(side({right}), Vec3::UnitX());
  EXPECT_EQ(side({right, of_kind(LightKind::ambient, Vec3::Zero())}), Vec3(0.5, 0, 0));
  EXPECT_EQ(side({right, of_kind(LightKind::sun, Vec3(-1, 0, 0))}), Vec3::Zero());
  EXPECT_EQ(side({of_kind(LightKind::point, Vec3(0, -3, 0))}), Vec3(0, -1, 0));
}

TEST(Lights, FallWithTheSquareOfTheDistance) {
  Light light = lamp(LightKind::point, 2, 8);
  EXPECT_NEAR(floor_light(light, 0), 2, 1e-12);
  light.falloff_distance = 2;
  EXPECT_NEAR(floor_light(light, 0), 8, 1e-12) << "as strong as its strength at that distance";
  light.vector *= 2;
  EXPECT_NEAR(floor_light(light, 0), 2, 1e-12);
  light.falloff_distance = 0;
  EXPECT_NEAR(floor_light(light, 0), 8, 1e-12);
}

// Radiance that a path tracer (Cycles, 512 samples a pixel) gave a white diffuse floor under lamps
// of 100 W: 100 / (4 pi^2) one unit away from points and spots, 100 / (4 pi) from areas.
TEST(Lights, AgreeWithAPathTracer) {
  const double bulb = 100 / (4 * pi * pi), panel = 100 / (4 * pi);
  const Light point = lamp(LightKind::point, 2, bulb);
  EXPECT_NEAR(floor_light(point, 0), 0.63324, 1e-4);
  EXPECT_NEAR(floor_light(point, 3), 0.10808, 1e-4);

  Light spot = lamp(LightKind::spot, 4, bulb);
  spot.angle_rad = pi / 6;
  spot.blend = 0.5;
  EXPECT_NEAR(floor_light(spot, 1), 0.14024, 1e-4);
  EXPECT_NEAR(floor_light(spot, 2), 0.03920, 1e-4) << "in the blend";
  EXPECT_EQ(floor_light(spot, 3), 0);
  spot.angle_rad = pi / 4;
  spot.blend = 0;
  EXPECT_NEAR(floor_light(spot, 3), 0.06485, 1e-4);

  const Light square = area_lamp(2, panel, 1, 1);
  EXPECT_NEAR(floor_light(square, 0), 1.8371, 2e-3);
  EXPECT_NEAR(floor_light(square, 2), 0.50694, 5e-4);
  const Light strip = area_lamp(1, panel, 3, 1);
  EXPECT_NEAR(floor_light(strip, 0), 3.404, 4e-3);
  EXPECT_NEAR(floor_light(strip, 2), 0.84716, 1e-3);
  Light disk = area_lamp(1, panel, 2, 2);
  disk.ellipse = true;
  EXPECT_NEAR(floor_light(disk, 0), 3.979, 8e-3);
  EXPECT_NEAR(floor_light(disk, 3), 0.09474, 2e-4);
}

TEST(Lights, AreaIsTheIntegralAlsoAcrossTheHorizon) {
  const Light light = area_lamp(1.5, 1, 3, 0.7);
  for (const Vec3& normal : {Vec3(0, 0, 1), Vec3(1, 0, 0.2), Vec3(-0.5, 0.8, 0.1)}) {
    for (const Vec3& at : {Vec3(0.3, 0.1, 0), Vec3(-2, 1, 0.5)}) {
      const Vec3 n = normal.normalized();
      EXPECT_NEAR(mean_form_factor(light, at, n), integrated(light, at, n, 400), 2e-5);
    }
  }
  EXPECT_EQ(mean_form_factor(light, Vec3(0, 0, 2), -Vec3::UnitZ()), 0) << "behind the lamp";
}

TEST(Lights, SmallAreasAreLikePoints) {
  Light small = area_lamp(2, 3, 1e-3, 1e-3), none_at_all = small;
  none_at_all.edge_u = none_at_all.edge_v = Vec3::Zero();
  for (const double x : {0.0, 1.0, 3.0}) {
    EXPECT_NEAR(floor_light(small, x), floor_light(none_at_all, x), 1e-6);
  }
  small.falloff_distance = none_at_all.falloff_distance = 0;
  EXPECT_NEAR(floor_light(small, 1), floor_light(none_at_all, 1), 1e-6);
}

TEST(Lights, NothingBlowsUpInTheLamp) {
  for (Light light : {lamp(LightKind::point, 0, 1), area_lamp(0, 1, 1, 1)}) {
    EXPECT_TRUE(std::isfinite(floor_light(light, 0)));
    EXPECT_TRUE(std::isfinite(floor_light(light, 0.5)));
    light.vector.z() = 1e-200;
    EXPECT_TRUE(std::isfinite(floor_light(light, 0)));
  }
}

TEST(Lights, ASpotWithoutACosineIsAPointWithinItsCone) {
  Light spot = lamp(LightKind::spot, 2, 3), point = lamp(LightKind::point, 2, 3);
  spot.angle_rad = pi / 4;
  for (const double x : {0.0, 1.0, 1.9}) {
    const double cosine = 2 / std::hypot(2, x);
    EXPECT_NEAR(floor_light(spot, x), cosine * floor_light(point, x), 1e-12);
    spot.cosine = false;
    EXPECT_NEAR(floor_light(spot, x), floor_light(point, x), 1e-12);
    spot.cosine = true;
  }
  spot.cosine = false;
  EXPECT_EQ(floor_light(spot, 2.1), 0);
}

TEST(Lights, ALargeLampIsWeakerNearIt) {
  Light light = lamp(LightKind::point, 2, 8);
  light.radius = 2;
  EXPECT_NEAR(floor_light(light, 0), 1, 1e-12) << "8 / (2^2 + 2^2)";
  light.vector.z() = 200;
  EXPECT_NEAR(floor_light(light, 0), 8.0 / (200 * 200), 1e-7);
}

// What passes through a plane: the light of rings of a floor, all round below the lamp.
double flux(const Light& light, double reach) {
  const int steps = 4000;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double x = (i + 0.5) / steps * reach;
    sum += floor_light(light, x) * 2 * pi * x * reach / steps;
  }
  return sum;
}

TEST(Lights, ASpreadKeepsTheLightOfAnArea) {
  Light light = lamp(LightKind::area, 1, 1);
  const double all = flux(light, 100);
  for (const double spread : {2.5, 1.5, 0.5, 0.01}) {
    light.spread_rad = spread;
    const double reach = std::tan(spread / 2);
    EXPECT_NEAR(flux(light, reach), all, 2e-3 * all) << spread;
    EXPECT_EQ(floor_light(light, 1.001 * reach), 0) << spread;
    EXPECT_GT(floor_light(light, 0.9 * reach), 0) << spread;
  }
}

TEST(Lights, AreasWithASpreadAreTheSumOfTheirParts) {
  const int across = 3;
  Light whole = area_lamp(2, 9, 1.5, 0.9);
  whole.spread_rad = 1.2;
  for (const double x : {0.0, 0.7, 1.4, 2.5}) {
    double sum = 0;
    for (int i = 0; i < across; ++i) {
      for (int j = 0; j < across; ++j) {
        Light part = whole;
        part.strength = whole.strength / (across * across);
        part.edge_u /= across;
        part.edge_v /= across;
        part.vector = point_on(whole, (i + 0.5) / across, (j + 0.5) / across);
        sum += floor_light(part, x);
      }
    }
    EXPECT_NEAR(floor_light(whole, x), sum, 0.01 * sum + 0.001) << x;
  }
}

TEST(Lights, SideLightTurnsWithTheViewer) {
  Light side;
  side.kind = LightKind::side;
  side.vector = Vec3(-1, 0, 1);
  for (const Vec3& eye : {Vec3(5, 0, 0), Vec3(0, -4, 3), Vec3(-1, 2, 6)}) {
    const Camera camera = cameras::perspective(eye, Vec3::Zero());
    const Vec3 right = camera.view().row(0).head<3>();
    const Vec3 back = camera.view().row(2).head<3>();
    EXPECT_NEAR(brightness({side}, camera, Vec3::Zero(), back), std::sqrt(0.5), 1e-12);
    const Vec3 left_front = (back - right).normalized(), right_front = (back + right).normalized();
    EXPECT_NEAR(brightness({side}, camera, Vec3::Zero(), left_front), 1, 1e-12);
    EXPECT_NEAR(brightness({side}, camera, Vec3::Zero(), right_front), 0, 1e-12);
  }
}

TEST(Lights, BadDetailsAreNamed) {
  const auto complaint = [](const Light& light) -> std::string {
    try {
      validate(light, 2);
    } catch (const InvalidInput& error) {
      return error.what();
    }
    return "";
  };
  Light light = area_lamp(1, 1, 1, 1);
  EXPECT_EQ(complaint(light), "");
  light.edge_v = 2 * light.edge_u;
  EXPECT_NE(complaint(light).find("lights[2].edges"), std::string::npos);
  light.edge_v = Vec3(0, std::nan(""), 0);
  EXPECT_NE(complaint(light).find("lights[2].edges"), std::string::npos);
  light = lamp(LightKind::spot, 1, 1);
  light.angle_rad = 1;
  light.blend = 1.5;
  EXPECT_NE(complaint(light).find("lights[2].blend"), std::string::npos);
  light = area_lamp(1, 1, 1, 1);
  light.spread_rad = 0;
  EXPECT_NE(complaint(light).find("lights[2].spread_rad"), std::string::npos);
  light = lamp(LightKind::point, 1, 1);
  light.radius = -1;
  EXPECT_NE(complaint(light).find("lights[2].radius"), std::string::npos);
  light.radius = 0;
  light.falloff_distance = -1;
  EXPECT_NE(complaint(light).find("lights[2].falloff_distance"), std::string::npos);
  light.kind = LightKind::side;
  light.falloff_distance = 0;
  light.vector = Vec3::Zero();
  EXPECT_NE(complaint(light).find("lights[2].vector"), std::string::npos);
}

// --- shadows ------------------------------------------------------------------------------------

TEST(Shadows, HalfAnAreaBehindAnEdgeGivesHalf) {
  const Surface plate =
      shapes::plain_surface(shapes::moved(shapes::plane(2, 2), Vec3(1, 0, 0.5)));  // x in [0, 2]
  const Bvh bvh(plate.positions, plate.triangles);
  Light light = area_lamp(1, 1, 0.5, 0.5);
  const auto share = [&](double x) {
    return share_reaching(light, above(), bvh, Vec3(x, 0, 0), Vec3::UnitZ());
  };
  EXPECT_NEAR(share(0), 0.5, 0.03);
  EXPECT_EQ(share(-0.3), 1);
  EXPECT_EQ(share(0.3), 0);
  EXPECT_NEAR(share(-0.125), 0.75, 0.03);  // the edge hides what is right of x = .125
  light.ellipse = true;
  EXPECT_NEAR(share(0), 0.5, 0.03);
  light = lamp(LightKind::point, 1, 1);
  EXPECT_EQ(share(-0.01), 1);
  EXPECT_EQ(share(0.01), 0);
  light.vector.z() = 0.4;
  EXPECT_EQ(share(0.01), 1) << "the lamp is below the plate";
}

// An edge across a square at any angle: the share falls from one to nothing, in steps that no
// drawing shows, as the part of the square beyond a line does.
TEST(Shadows, HalfShadowsOfSlantedEdgesAreSmooth) {
  const Light light = area_lamp(1, 1, 0.5, 0.5);
  for (const double angle : {0.0, 0.2, pi / 8, pi / 4}) {
    PolygonMesh half = shapes::moved(shapes::plane(2, 2), Vec3(1, 0, 0.5));  // x in [0, 2]
    const Eigen::AngleAxisd turn(angle, Vec3::UnitZ());
    for (Vec3& p : half.positions) p = turn * p;
    const Surface plate = shapes::plain_surface(half);
    const Bvh bvh(plate.positions, plate.triangles);
    double before = 1;
    for (int step = -40; step <= 40; ++step) {
      const Vec3 towards = turn * Vec3::UnitX();
      const Vec3 at = 0.01 * step * towards;
      const double share = share_reaching(light, above(), bvh, at, Vec3::UnitZ());
      int seen = 0;  // of 500 x 500 places: those whose ray passes before the edge
      for (int i = 0; i < 500; ++i) {
        for (int j = 0; j < 500; ++j) {
          const Vec3 place = point_on(light, (i + 0.5) / 500, (j + 0.5) / 500);
          seen += (place + at).dot(towards) < 0 ? 1 : 0;
        }
      }
      EXPECT_NEAR(share, seen / 250000.0, 0.08) << angle << " " << step;
      EXPECT_LE(share, before);
      EXPECT_LE(before - share, 0.07) << angle << " " << step;
      before = share;
    }
  }
}

// A corner of an area that is hidden tells that more of it may be.
TEST(Shadows, BeginWhereACornerOfTheAreaIsHidden) {
  const Surface plate =
      shapes::plain_surface(shapes::moved(shapes::plane(2, 2), Vec3(1, 1, 0.5)));  // x, y in [0, 2]
  const Bvh bvh(plate.positions, plate.triangles);
  const Light light = area_lamp(1, 1, 0.5, 0.5);
  const auto share = [&](double x) {
    return share_reaching(light, above(), bvh, Vec3(x, x, 0), Vec3::UnitZ());
  };
  EXPECT_EQ(share(-0.26), 1);
  for (const double x : {-0.24, -0.2, -0.15, 0.0}) {
    const double hidden = (x + 0.25) / 0.5;  // of each side
    EXPECT_NEAR(share(x), 1 - hidden * hidden, 0.025) << x;
  }
}

TEST(Shadows, RaysStartAboveTheTrianglesOfConvexSurfaces) {
  const Surface sphere = shapes::sphere_surface(1, 2);
  for (int t = 0; t < static_cast<int>(sphere.triangles.size()); ++t) {
    for (const auto& [b1, b2] : {std::pair{1 / 3.0, 1 / 3.0}, {0.1, 0.8}, {0.0, 0.5}}) {
      const SurfacePoint on{t, b1, b2};
      const Vec3 normal = normal_at(sphere, on);
      const Vec3 outside = shadow_origin(sphere, on, normal);
      EXPECT_GE(outside.norm(), position_at(sphere, on).norm());
      EXPECT_NEAR(outside.norm(), 1, 0.03);
      const Vec3 inside = shadow_origin(sphere, on, -normal);
      EXPECT_LT(inside.norm(), position_at(sphere, on).norm());
    }
  }
}

}  // namespace
}  // namespace illustrate
