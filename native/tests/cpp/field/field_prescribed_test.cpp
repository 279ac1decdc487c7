#include <gtest/gtest.h>

#include <map>

#include "core/errors.h"
#include "field/problem/prescribed.h"
#include "field/singularities.h"
#include "tests/cpp/field/field_checks.h"

namespace illustrate {
namespace {

using namespace field_checks;

Vec3 middle(const Surface& surface, int triangle) {
  return position_at(surface, {triangle, 1.0 / 3, 1.0 / 3});
}

FieldOptions prescribing(const Surface& surface, const std::map<int, int>& index_of_triangle) {
  FieldOptions options = all_free();
  for (const auto& [triangle, index] : index_of_triangle) {
    options.singularities.positions.push_back(middle(surface, triangle));
    options.singularities.indices.push_back(index);
  }
  return options;
}

std::map<int, int> singularities_of(const CrossField& field) {
  std::map<int, int> found;
  for (std::size_t s = 0; s < field.singular_triangles.size(); ++s) {
    found[field.singular_triangles[s]] = field.singular_indices[s];
  }
  return found;
}

// `plus` and `minus` triangles spread over the surface.
std::map<int, int> spread(const Surface& surface, int plus, int minus) {
  std::map<int, int> wanted;
  const auto triangles = static_cast<int>(surface.triangles.size());
  for (int k = 0; k < plus + minus; ++k) {
    wanted[(37 + k * (triangles / (plus + minus))) % triangles] = k < plus ? 1 : -1;
  }
  return wanted;
}

void expect_kept(const Surface& surface, const std::map<int, int>& wanted) {
  const CrossField field = solved(surface, prescribing(surface, wanted));
  EXPECT_EQ(singularities_of(field), wanted);
}

TEST(PrescribedSingularities, AreKeptExactly) {
  const Surface sphere = shapes::sphere_surface(1, 3);
  expect_kept(sphere, spread(sphere, 8, 0));
  expect_kept(sphere, spread(sphere, 14, 6));
  const Surface bumpy = blob(5);
  expect_kept(bumpy, spread(bumpy, 8, 0));
  expect_kept(bumpy, spread(bumpy, 24, 16));
}

TEST(PrescribedSingularities, AreKeptOnSurfacesWithHandles) {
  const Surface torus = shapes::torus_surface(1, 0.4, 48, 24);
  expect_kept(torus, spread(torus, 3, 3));
  const Surface slab = two_holed_slab(6);
  expect_kept(slab, spread(slab, 0, 8));
  expect_kept(slab, spread(slab, 4, 12));
}

TEST(PrescribedSingularities, AreKeptOnOneSidedAndOpenSurfaces) {
  const Surface klein = unorientable(shapes::klein_mesh(60, 24));
  expect_kept(klein, spread(klein, 3, 3));
  const Surface plane = shapes::plain_surface(shapes::plane(16, 16));
  expect_kept(plane, {{200, 1}});
  expect_kept(plane, {{100, 1}, {300, 1}, {410, -1}});
  expect_kept(cylinder(48, 20, Vec3::UnitZ()), {{300, -1}});
}

TEST(PrescribedSingularities, HoldForTheirPartOnly) {
  const Surface both = shapes::joined(shapes::torus_surface(1, 0.4, 32, 16),
                                      shapes::sphere_surface(1, 3, {5, 0, 0}));
  const std::map<int, int> wanted{{50, 1}, {400, -1}};
  const CrossField field = solved(both, prescribing(both, wanted));
  std::map<int, int> on_torus, on_sphere;
  for (const auto& [triangle, index] : singularities_of(field)) {
    (both.triangle_objects[index_of(triangle)] == 0 ? on_torus : on_sphere)[triangle] = index;
  }
  EXPECT_EQ(on_torus, wanted);
  EXPECT_EQ(on_sphere.size(), 8U);
}

TEST(PrescribedSingularities, OfSeveralQuarterTurnsBecomeSingleOnesCloseBy) {
  const Surface sphere = shapes::sphere_surface(1, 4);
  FieldOptions options = all_free();
  options.singularities = {{Vec3::UnitZ(), -Vec3::UnitZ()}, {4, 4}};
  const CrossField field = solved(sphere, options);
  ASSERT_EQ(field.singular_triangles.size(), 8U);
  for (std::size_t s = 0; s < 8; ++s) {
    EXPECT_EQ(field.singular_indices[s], 1);
    EXPECT_GT(std::abs(field.singular_positions[s].z()), 0.95);
  }
}

TEST(PrescribedSingularities, ComeBeforeGuidesFeaturesAndCurvature) {
  const Surface sphere = shapes::sphere_surface(1, 4);
  std::map<int, int> wanted = spread(sphere, 8, 0);
  FieldOptions options = prescribing(sphere, wanted);
  Guide ring{{}, 100};
  for (double u = 0; u < 6.3; u += 0.02) ring.points.emplace_back(std::cos(u), std::sin(u), 0);
  Guide across = ring;
  for (Vec3& p : across.points) p = {p.x(), 0.7 * p.y(), 0.7 * p.y()};
  options.guides = {ring, across};
  options.parabolic_ratio = 1e9;
  options.largest_energy = 2;
  const CrossField field = solved(sphere, options);
  EXPECT_EQ(singularities_of(field), wanted);
  EXPECT_EQ(std::count(field.reliable.begin(), field.reliable.end(), 1), 0);
}

TEST(PrescribedSingularities, AreTheSameBytesForAnyThreadCount) {
  const Surface torus = shapes::torus_surface(1, 0.4, 96, 48);
  FieldOptions options = prescribing(torus, spread(torus, 3, 3));
  const CrossField one = solved(torus, options);
  options.threads = 2;
  EXPECT_EQ(one.theta, solved(torus, options).theta);
}

// The turns close up round every triangle, and are the least that do: the gradient of a potential.
TEST(PrescribedSingularities, NeedTheTurnsThatTheirTrianglesMiss) {
  const Surface sphere = shapes::sphere_surface(1, 3);
  const TangentFrames frames = tangent_frames(sphere.normals, 1);
  const TriangleEdges edges = triangle_edges(sphere);
  const std::vector<double> excess = triangle_excess(sphere, edges, frames, 1, {});
  PlacedSingularities placed{std::vector<int>(sphere.triangles.size(), 0), {1}};
  for (const auto& [triangle, index] : spread(sphere, 8, 0)) {
    placed.index_of_triangle[index_of(triangle)] = index;
  }
  const FieldParts parts{std::vector<int>(sphere.positions.size(), 0), 1};
  const std::vector<double> turns = least_turns(sphere, edges, excess, parts, placed);
  for (std::size_t t = 0; t < sphere.triangles.size(); ++t) {
    double sum = excess[t];
    for (int k = 0; k < 3; ++k) {
      sum += side_sign(sphere, t, k) * turns[index_of(edges.of_triangle[t][index_of(k)])];
    }
    EXPECT_NEAR(sum, pi / 2 * placed.index_of_triangle[t], 1e-6);
  }
  std::vector<double> around(sphere.positions.size(), 0);  // any circulation would be waste
  for (std::size_t e = 0; e < edges.size(); ++e) {
    around[index_of(edges.vertices[e][0])] += turns[e];
    around[index_of(edges.vertices[e][1])] -= turns[e];
  }
  for (const double sum : around) EXPECT_NEAR(sum, 0, 1e-6);
}

std::string refusal(const Surface& surface, const FieldOptions& options) {
  try {
    solve_cross_field(surface, surface.curvature, options);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "";
}

TEST(PrescribedSingularities, MustSumToFourChiOnClosedParts) {
  const Surface both = shapes::joined(shapes::torus_surface(1, 0.4, 32, 16),
                                      shapes::sphere_surface(1, 3, {5, 0, 0}));
  const auto torus = static_cast<int>(2 * 32 * 16);
  const std::string message =
      refusal(both, prescribing(both, {{50, 1}, {torus + 3, 1}, {torus + 300, 1}}));
  EXPECT_NE(message.find("mesh 0) has 1, but must have 4 chi = 0"), std::string::npos) << message;
  EXPECT_NE(message.find("mesh 1) has 2, but must have 4 chi = 8"), std::string::npos) << message;
}

TEST(PrescribedSingularities, NeedRoom) {
  const Surface tetrahedron = shapes::plain_surface(shapes::tetrahedron());
  const std::string message = refusal(tetrahedron, prescribing(tetrahedron, {{0, 8}}));
  EXPECT_NE(message.find("no room for singularities[0]"), std::string::npos) << message;
  FieldOptions options = all_free();
  options.singularities = {{Vec3::Zero()}, {1, 2}};
  EXPECT_NE(refusal(tetrahedron, options).find("singularities"), std::string::npos);
  EXPECT_NE(refusal(Surface{}, prescribing(tetrahedron, {{0, 1}})), "");
}

}  // namespace
}  // namespace illustrate
