#include <gtest/gtest.h>

#include <cstring>

#include "core/errors.h"
#include "field/last_field.h"
#include "surface/jets/curvature.h"
#include "tests/cpp/field/field_checks.h"

namespace illustrate {
namespace {

using namespace field_checks;

bool same_bytes(const CrossField& a, const CrossField& b) {
  return a.theta.size() == b.theta.size() &&
         std::memcmp(a.theta.data(), b.theta.data(), sizeof(double) * a.theta.size()) == 0;
}

// --- guides --------------------------------------------------------------------------------------

// Off the rings of a cylinder about z by `angle`, from one side of its middle to the other, `off`
// away from the surface.
Guide helix(double angle, double weight, double off = 0) {
  Guide guide{{}, weight};
  for (double u = -1; u <= 1; u += 0.02) {
    guide.points.emplace_back((1 + off) * std::cos(u), (1 + off) * std::sin(u),
                              1.5 + std::tan(angle) * u);
  }
  return guide;
}

// Largest angle in degrees between the field and a helix, at the vertices next to it; ends left
// out.
double off_helix(const Surface& surface, const CrossField& field, double angle, double reach) {
  double most = 0;
  for (std::size_t i = 0; i < surface.positions.size(); ++i) {
    const Vec3& p = surface.positions[i];
    const double u = std::atan2(p.y(), p.x());
    if (std::abs(u) > 0.9 || std::abs(p.z() - 1.5 - std::tan(angle) * u) > reach) continue;
    const Vec3 around = Vec3::UnitZ().cross(surface.normals[i]);
    const Vec3 along = std::cos(angle) * around + std::sin(angle) * Vec3::UnitZ();
    most = std::max(most, std::asin(off_cross(field.directions[i], surface.normals[i], along)));
  }
  return most * 180 / pi;
}

FieldOptions guided(FieldOptions options, const Guide& guide) {
  options.guides = {guide};
  return options;
}

TEST(FieldGuides, AreFollowedTheMoreTheHeavierTheyAre) {
  const Surface surface = cylinder(96, 48, Vec3::UnitZ());
  const double angle = 20 * pi / 180;
  double last = 90;
  for (const double weight : {0.0, 0.1, 1.0, 10.0}) {
    const CrossField field = solved(surface, guided(all_free(), helix(angle, weight)));
    const double off = off_helix(surface, field, angle, 0.02);
    EXPECT_LT(off, last);
    last = off;
  }
  EXPECT_LT(last, 2);
}

TEST(FieldGuides, OverruleCurvatureNearby) {
  const Surface surface = cylinder(96, 48, Vec3::UnitZ());
  const double angle = 20 * pi / 180;
  const CrossField field = solved(surface, guided({}, helix(angle, 10)));
  EXPECT_LT(off_helix(surface, field, angle, 0.02), 3);
  for (std::size_t i = 0; i < surface.positions.size(); ++i) {
    const Vec3& p = surface.positions[i];
    const bool is_far = p.x() < -0.5;
    if (!is_far) continue;
    EXPECT_TRUE(field.reliable[i]);
    EXPECT_LT(off_cross(field.directions[i], surface.normals[i], Vec3::UnitZ()), 1e-9);
  }
  EXPECT_LT(std::count(field.reliable.begin(), field.reliable.end(), 1),
            static_cast<long>(surface.positions.size()));
}

TEST(FieldGuides, AreProjectedAndLeftOutWhereTheyAreFar) {
  const Surface surface = cylinder(96, 48, Vec3::UnitZ());
  const double angle = 20 * pi / 180;
  const CrossField near = solved(surface, guided(all_free(), helix(angle, 10, 0.05)));
  EXPECT_LT(off_helix(surface, near, angle, 0.02), 2);
  const CrossField far = solved(surface, guided(all_free(), helix(angle, 10, 0.5)));
  EXPECT_TRUE(same_bytes(far, solved(surface, all_free())));
}

TEST(FieldGuides, ThatLeadNowhereChangeNothing) {
  const Surface surface = shapes::sphere_surface(1, 4);
  const CrossField plain = solved(surface, all_free());
  const Vec3 on = surface.positions[3];
  for (const Points& points : {Points{}, Points{on}, Points{on, on}, Points{on, Vec3(1.01 * on)}}) {
    EXPECT_TRUE(same_bytes(solved(surface, guided(all_free(), {points, 10})), plain));
  }
}

TEST(FieldGuides, CrossEachOtherWithoutHarmAtRightAngles) {
  const Surface surface = cylinder(96, 48, Vec3::UnitZ());
  FieldOptions options = all_free();
  const double angle = 20 * pi / 180;
  options.guides = {helix(angle, 10), helix(angle - pi / 2, 10)};
  EXPECT_LT(off_helix(surface, solved(surface, options), angle, 0.02), 2);
}

TEST(FieldGuides, NeverRaiseTheEnergyAndGiveTheSameBytesForAnyThreadCount) {
  const Surface surface = blob(4);
  FieldOptions options = all_free();
  Guide guide{{}, 10};
  for (double u = 0; u < 1; u += 0.05) guide.points.emplace_back(std::cos(u), std::sin(u), 0.3 * u);
  options.guides = {guide};
  const CrossField one = solved(surface, options);
  EXPECT_LT(one.energy, one.energy_initial);
  options.threads = 2;
  EXPECT_TRUE(same_bytes(one, solved(surface, options)));
}

TEST(FieldGuides, AreCheckedByName) {
  FieldOptions options;
  options.guides = {{{}, 1}, {{Vec3(0, std::nan(""), 0)}, 1}};
  try {
    validate(options);
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_NE(std::string(error.what()).find("guides[1].points"), std::string::npos);
  }
}

// --- the last field ------------------------------------------------------------------------------

CrossField solved_after(const Surface& surface, const FieldOptions& options, const Surface& last,
                        const CrossField& field) {
  const FieldAids aids{nullptr, &last, &field};
  CrossField again = solve_cross_field(surface, surface.curvature, options, aids);
  check(surface, again);
  return again;
}

TEST(LastField, TurnsWithTheSurface) {
  PolygonMesh mesh = shapes::icosphere_mesh(1, 4);
  for (Vec3& p : mesh.positions) p.x() *= 1.5;
  const Eigen::AngleAxisd rotation(1.1, Vec3(1, 2, 3).normalized());
  const Surface before = shapes::plain_surface(mesh);
  const Surface now = shapes::plain_surface(rotated(mesh, rotation.angle(), rotation.axis()));
  const CrossField field = solved(before, all_free());
  const CrossField again = solved_after(now, all_free(), before, field);
  EXPECT_LE(again.evaluations, 12);
  EXPECT_NEAR(again.energy, field.energy, 1e-5 * std::abs(field.energy));
  for (std::size_t i = 0; i < again.directions.size(); ++i) {
    const Vec3 turned = rotation * field.directions[i];
    EXPECT_LT(off_cross(again.directions[i], now.normals[i], turned), 0.02);
  }
}

// Quads that are split along their other diagonals are the same.
TEST(LastField, TurnsWithQuads) {
  PolygonMesh mesh = shapes::torus_mesh(1, 0.4, 40, 20);
  const auto of_quads = [&] {
    Surface surface = shapes::plain_surface(mesh);
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
      surface.triangle_faces.push_back(static_cast<int>(t / 2));
    return surface;
  };
  const Surface before = of_quads();
  const double angle = 20 * pi / 180;
  CrossField field = solved(before, all_free());
  for (std::size_t i = 0; i < field.theta.size(); ++i) {
    field.theta[i] += angle;
    field.directions[i] = Eigen::AngleAxisd(angle, before.normals[i]) * field.directions[i];
  }
  const Eigen::AngleAxisd rotation(1.1, Vec3(1, 2, 3).normalized());
  mesh = rotated(mesh, rotation.angle(), rotation.axis());
  for (std::size_t c = 0; c < mesh.corner_vertices.size(); c += 4) {
    const auto first = mesh.corner_vertices.begin() + static_cast<std::ptrdiff_t>(c);
    std::rotate(first, first + 1, first + 4);
  }
  const Surface now = of_quads();
  ASSERT_NE(before.triangles, now.triangles);
  const CrossNumbers z = last_crosses(now, tangent_frames(now.normals, 1), triangle_edges(now),
                                      {nullptr, &before, &field}, {});
  const TangentFrames frames = tangent_frames(now.normals, 1);
  ASSERT_EQ(z.size(), now.positions.size());
  for (std::size_t i = 0; i < z.size(); ++i) {
    const CrossNumber turned = direction_in_frame(frames, i, rotation * field.directions[i]);
    EXPECT_LT(std::abs(fourth_power(turned) - z[i]), 0.02) << i;
  }
}

TEST(LastField, OfOtherTrianglesIsLeftAlone) {
  const Surface before = smooth_cube(3), now = blob(4);
  const CrossField field = solved(before, all_free());
  EXPECT_TRUE(same_bytes(solved_after(now, all_free(), before, field), solved(now, all_free())));
}

TEST(LastField, TakesUpANewGuide) {
  const Surface surface = cylinder(96, 48, Vec3::UnitZ());
  const double angle = 20 * pi / 180;
  const CrossField field = solved(surface, all_free());
  const FieldOptions options = guided(all_free(), helix(angle, 10));
  const CrossField again = solved_after(surface, options, surface, field);
  const CrossField fresh = solved(surface, options);
  EXPECT_LT(off_helix(surface, again, angle, 0.02), 2);
  EXPECT_NEAR(again.energy, fresh.energy, 1e-3 * std::abs(fresh.energy));
}

TEST(LastField, IsNearAMinimumOfAMovedSurface) {
  const Surface before = blob(5);
  Surface now = before;
  for (Vec3& p : now.positions) p.x() += 0.03 * std::sin(3 * p.y());
  now = shapes::plain_surface([&] {
    PolygonMesh mesh = shapes::icosphere_mesh(1, 5);
    mesh.positions = now.positions;
    return mesh;
  }());
  const CrossField again = solved_after(now, all_free(), before, solved(before, all_free()));
  EXPECT_EQ(again.singular_triangles.size(), 8U);
  EXPECT_LT(again.energy, again.energy_initial);
}

// --- the paper's own choices ---------------------------------------------------------------------

TEST(FieldOptions, NothingIsFreeWhereEverythingIsReliable) {
  const Surface surface = shapes::torus_surface(1, 0.4, 40, 20);
  FieldOptions options;
  options.parabolic_ratio = 1e9;
  options.least_curvature = 0;
  options.largest_energy = 2;
  const CrossField field = solved(surface, options);
  EXPECT_EQ(std::count(field.reliable.begin(), field.reliable.end(), 0), 0);
  EXPECT_EQ(field.energy, field.energy_initial);
  for (std::size_t i = 0; i < field.directions.size(); ++i) {
    EXPECT_LT(field.directions[i].cross(surface.curvature[i].w1).norm(), 1e-9);
  }
}

TEST(FieldOptions, StartFromPrincipalDirectionsStaysInTheirBasin) {
  Surface surface = blob(5);
  surface.curvature = jet_curvature(surface, {});
  FieldOptions options = all_free();
  const CrossField best = solve_cross_field(surface, surface.curvature, options);
  options.start = FieldStart::principal;
  const CrossField papers = solve_cross_field(surface, surface.curvature, options);
  check(surface, papers);
  EXPECT_LT(papers.energy, papers.energy_initial);
  EXPECT_GT(papers.energy, best.energy);
  EXPECT_GT(papers.singular_triangles.size(), best.singular_triangles.size());
  EXPECT_EQ(index_sum(papers), 8);
}

TEST(FieldOptions, InverseLengthsWeighEdges) {
  const Surface surface = smooth_cube(3);
  FieldOptions options = all_free();
  options.inverse_length_weights = true;
  const CrossField field = solved(surface, options);
  const TriangleEdges edges = triangle_edges(surface);
  double sum = 0, lengths = 0, inverse = 0;
  for (const Edge& edge : edges.vertices) {
    const auto i = index_of(edge[0]), j = index_of(edge[1]);
    const Vec3 along = surface.positions[j] - surface.positions[i];
    const double at_i = projected_angle(surface.normals[i], along, field.directions[i]);
    const double at_j = projected_angle(surface.normals[j], along, field.directions[j]);
    sum -= std::cos(4 * (at_i - at_j)) / along.norm();
    lengths += along.norm();
    inverse += 1 / along.norm();
  }
  const double count = static_cast<double>(edges.size());
  EXPECT_NEAR(field.energy, sum * count / inverse, 1e-6 * count);
  EXPECT_NE(lengths, count);
}

}  // namespace
}  // namespace illustrate
