// Reflectance of meshes: textures, faces and corners, instances, and the exposure that suits it.
#include <gtest/gtest.h>

#include "core/errors.h"
#include "mesh/instance.h"
#include "surface/refine.h"
#include "tests/cpp/shapes.h"
#include "tone/exposure.h"
#include "tone/lightness.h"
#include "tone/tone_regions.h"

namespace illustrate {
namespace {

Texture ramp(Wrap wrap) { return Texture(4, 1, {0, 0.25F, 0.5F, 0.75F}, wrap); }

TEST(Texture, IsLinearBetweenTheMiddlesOfTexels) {
  const Texture texture = ramp(Wrap::extend);
  for (const double u : {0.125, 0.2, 0.5, 0.875}) {
    EXPECT_NEAR(texture.mean_at({u, 0.3}, 1), u - 0.125, 1e-7) << u;
  }
  EXPECT_DOUBLE_EQ(texture.mean_at({1, 0.5}, 1), 0.75);
}

TEST(Texture, GoesOnOutsideAsItsWrapSays) {
  const double u = 1.375;  // the middle of the second texel, once round
  EXPECT_DOUBLE_EQ(ramp(Wrap::repeat).mean_at({u, 0.5}, 1), 0.25);
  EXPECT_DOUBLE_EQ(ramp(Wrap::repeat).mean_at({u - 3, 7.5}, 1), 0.25);
  EXPECT_DOUBLE_EQ(ramp(Wrap::mirror).mean_at({u, 0.5}, 1), 0.5);
  EXPECT_DOUBLE_EQ(ramp(Wrap::extend).mean_at({u, 0.5}, 1), 0.75);
  EXPECT_DOUBLE_EQ(ramp(Wrap::clip).mean_at({u, 0.5}, 1), 0);
  EXPECT_DOUBLE_EQ(ramp(Wrap::repeat).mean_at({1e300, 0.5}, 1), 0);
}

TEST(Texture, FarAwayIsItsMean) {
  std::vector<float> checks;
  for (int i = 0; i < 64 * 64; ++i) checks.push_back((i / 64 + i) % 2 == 0 ? 1.0F : 0.0F);
  const Texture texture(64, 64, checks, Wrap::repeat);
  for (const double texels : {2.0, 3.0, 64.0, 1e9}) {
    EXPECT_NEAR(texture.mean_at({0.31, 0.77}, texels), 0.5, 1e-6) << texels;
  }
}

TEST(Texture, RefusesWhatDoesNotFit) {
  EXPECT_THROW(Texture(0, 1, {}, Wrap::repeat), InvalidInput);
  EXPECT_THROW(Texture(2, 2, {1, 1, 1}, Wrap::repeat), InvalidInput);
}

// A triangle that carries a linear function of its plane at its corners.
TEST(Lightness, OfCornersIsLinearInATriangle) {
  PolygonMesh mesh = shapes::polygon_mesh({{0, 0, 1}, {4, 0, 2}, {0, 3, 1}}, {{0, 1, 2}});
  const auto value = [](const Vec3& p) { return 0.1 + 0.15 * p.x() + 0.05 * p.y(); };
  for (const Vec3& p : mesh.positions) mesh.reflectance.corners.push_back(value(p));
  const FaceLightness face(mesh, 0, 0);
  for (const Vec2& share : {Vec2(0.2, 0.3), Vec2(0.6, 0.1), Vec2(0, 0), Vec2(0.5, 0.5)}) {
    const Vec3 p = mesh.positions[0] + share.x() * (mesh.positions[1] - mesh.positions[0]) +
                   share.y() * (mesh.positions[2] - mesh.positions[0]);
    EXPECT_NEAR(face.at(p, 0.01), value(p), 1e-12);
  }
}

TEST(Lightness, IsTheProductOfWhatIsGivenAndEndsAtWhite) {
  PolygonMesh mesh = shapes::plane(1, 1);
  mesh.reflectance.faces = {0.5};
  mesh.reflectance.textures = {
      std::make_shared<Texture>(1, 1, std::vector<float>{0.5F}, Wrap::extend)};
  mesh.reflectance.uv.assign(4, Vec2(0.5, 0.5));
  mesh.reflectance.face_textures = {0};
  EXPECT_DOUBLE_EQ(FaceLightness(mesh, 0, 0).at(mesh.positions[0], 1), 0.25);
  mesh.reflectance.faces = {1.25};
  EXPECT_DOUBLE_EQ(FaceLightness(mesh, 0, 0).at(mesh.positions[0], 1), 0.625);
  mesh.reflectance.faces = {0.5};
  mesh.reflectance.face_textures = {none};
  EXPECT_DOUBLE_EQ(FaceLightness(mesh, 0, 0).at(mesh.positions[0], 1), 0.5);
  mesh.reflectance.faces = {7};
  EXPECT_DOUBLE_EQ(FaceLightness(mesh, 0, 0).at(mesh.positions[0], 1), 1);
}

// Each face of a cube has a shade of its own: every triangle made of it has it too.
TEST(Lightness, TrianglesKnowTheirFace) {
  auto mesh = std::make_shared<PolygonMesh>(shapes::cube());
  mesh->cage = false;
  mesh->crease_angle_deg = 30;
  for (std::size_t f = 0; f < mesh->face_sizes.size(); ++f) {
    mesh->reflectance.faces.push_back(0.1 * static_cast<double>(f + 1));
  }
  Counts counts;
  SurfaceOptions options;
  options.level = 2;
  const Surface surface = refine({sanitize(*mesh, counts)}, options, counts);
  const std::vector<std::shared_ptr<const PolygonMesh>> meshes{mesh};
  const Lightness lightness(surface, meshes);
  ASSERT_FALSE(lightness.is_white());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const int face = surface.triangle_faces[t];
    const Triangle& triangle = surface.triangles[t];
    EXPECT_DOUBLE_EQ(lightness.of_triangle(static_cast<int>(t))->at(Vec3::Zero(), 1),
                     0.1 * (face + 1));
    // A face of the cube is where its triangles are.
    Vec3 middle = Vec3::Zero();
    for (int k = 0; k < 4; ++k) {
      middle += mesh->positions[idx(mesh->corner_vertices[idx(4 * face + k)])] / 4;
    }
    for (const int v : triangle) {
      EXPECT_NEAR((surface.positions[idx(v)] - middle).dot(middle) / middle.norm(), 0, 1e-9);
    }
  }
}

TEST(Lightness, OfAMirroredInstanceStaysWithItsCorners) {
  auto mesh = std::make_shared<PolygonMesh>(shapes::plane(1, 1));
  mesh->reflectance.corners = {0.1, 0.2, 0.3, 0.4};
  Mat4 mirror = Mat4::Identity();
  mirror(0, 0) = -1;
  const PolygonMesh mirrored = instance(mesh, mirror, "mirrored");
  const FaceLightness one(*mesh, 0, 0), other(mirrored, 0, 0);
  for (const Vec3& p : mesh->positions) {
    EXPECT_NEAR(one.at(p, 1), other.at(Vec3(-p.x(), p.y(), p.z()), 1), 1e-12);
  }
}

// --- Exposure

std::vector<double> evenly(std::size_t count, double low, double high) {
  std::vector<double> light;
  for (std::size_t i = 0; i < count; ++i) {
    light.push_back(low + (high - low) * static_cast<double>(i) / static_cast<double>(count - 1));
  }
  return light;
}

double share_above(const std::vector<double>& light, double threshold) {
  return static_cast<double>(
             std::count_if(light.begin(), light.end(), [&](double b) { return b > threshold; })) /
         static_cast<double>(light.size());
}

TEST(Exposure, TheLightestTwentiethIsWhiteWhateverTheLampsStrength) {
  for (const double strength : {1e-6, 0.3, 1.0, 5e4}) {
    const double factor = suitable_exposure({}, evenly(1001, 0, strength));
    EXPECT_NEAR(factor * strength, 1 / 0.95, 1e-9);
  }
}

TEST(Exposure, NoMoreThanSixTenthsAreOneTone) {
  std::vector<double> dim = evenly(900, 0.001, 0.2), glints = evenly(100, 0.9, 1);
  dim.insert(dim.end(), glints.begin(), glints.end());
  EXPECT_NEAR(share_above(dim, 0.45 / suitable_exposure({}, dim)), 0.4, 0.002);
  const std::vector<double> bright = evenly(1001, 0.8, 1);
  EXPECT_NEAR(share_above(bright, 0.85 / suitable_exposure({}, bright)), 0.6, 0.002);
}

TEST(Exposure, WhereAllIsAlikeItStaysWhite) {
  EXPECT_DOUBLE_EQ(suitable_exposure({}, std::vector<double>(50, 0.25)), 4);
  EXPECT_DOUBLE_EQ(suitable_exposure({}, std::vector<double>(50, 0)), 1);
  EXPECT_DOUBLE_EQ(suitable_exposure({}, {}), 1);
}

}  // namespace
}  // namespace illustrate
