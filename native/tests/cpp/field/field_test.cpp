#include <gtest/gtest.h>

#include <cstring>
#include <set>

#include "core/errors.h"
#include "field/search/minimise.h"
#include "tests/cpp/field/field_checks.h"

namespace illustrate {
namespace {

using namespace field_checks;

// --- solved fields -------------------------------------------------------------------------------

TEST(CrossFieldSolve, CylinderGetsRingsAndGenerators) {
  const Vec3 axis = Vec3(1, 2, 0.5).normalized();
  const Surface surface = cylinder(48, 20, axis);
  for (const FieldOptions& options : {FieldOptions{}, all_free()}) {
    const CrossField field = solved(surface, options);
    for (std::size_t i = 0; i < field.directions.size(); ++i) {
      EXPECT_LT(off_cross(field.directions[i], surface.normals[i], axis), 1e-3);
    }
    EXPECT_TRUE(field.singular_triangles.empty());
  }
  const CrossField field = solved(surface, {});
  EXPECT_EQ(std::count(field.reliable.begin(), field.reliable.end(), 1),
            static_cast<long>(surface.positions.size()));
}

TEST(CrossFieldSolve, FillsWhereNothingIsKnown) {
  Surface surface = cylinder(48, 40, Vec3::UnitX());
  for (std::size_t i = 0; i < surface.positions.size(); ++i) {
    const double x = surface.positions[i].x();
    if (x > 0.8 && x < 2.2) shapes::set_curvature(surface, i, 0, Vec3::Zero(), 0, Vec3::Zero());
  }
  FieldOptions options;
  options.default_direction = Vec3(1, 1, 1);
  const CrossField field = solved(surface, options);
  EXPECT_GT(field.energy_initial, field.energy + 10);
  for (std::size_t i = 0; i < field.directions.size(); ++i) {
    EXPECT_LT(off_cross(field.directions[i], surface.normals[i], Vec3::UnitX()), 0.02);
  }
}

TEST(CrossFieldSolve, PlaneIsParallelToItsBoundary) {
  const double angle = 0.4;
  const Surface surface =
      shapes::plain_surface(rotated(shapes::plane(12, 12), angle, Vec3::UnitZ()));
  const CrossField field = solved(surface, {});
  int edges = 0;
  paper_energy(surface, field.directions, &edges);
  EXPECT_NEAR(field.energy, -edges, 1e-9);
  for (const Vec3& direction : field.directions) {
    EXPECT_LT(off_cross(direction, Vec3::UnitZ(), {std::cos(angle), std::sin(angle), 0}), 1e-6);
  }
}

TEST(CrossFieldSolve, DefaultDirectionDecidesWhereNothingElseDoes) {
  const Surface surface = shapes::plain_surface(rotated(shapes::plane(12, 12), 0.4, Vec3::UnitZ()));
  FieldOptions options = all_free();
  options.alignment_weight = 0;
  options.default_direction = Vec3(2, 1, 5);
  const CrossField field = solved(surface, options);
  for (const Vec3& direction : field.directions) {
    EXPECT_LT(off_cross(direction, Vec3::UnitZ(), Vec3(2, 1, 0).normalized()), 1e-6);
  }
}

TEST(CrossFieldSolve, CubeFollowsItsCreases) {
  const Eigen::AngleAxisd rotation(0.7, Vec3(1, 3, 2).normalized());
  const Surface surface = creased(rotated(shapes::cube(), rotation.angle(), rotation.axis()));
  const CrossField field = solved(surface, {});
  for (std::size_t i = 0; i < field.directions.size(); ++i) {
    double along_an_axis = 0;
    for (int axis = 0; axis < 3; ++axis) {
      along_an_axis =
          std::max(along_an_axis, std::abs(field.directions[i].dot(rotation * Vec3::Unit(axis))));
    }
    EXPECT_GT(along_an_axis, 1 - 1e-6);
  }
}

TEST(CrossFieldSolve, ReliableVerticesKeepTheirDirections) {
  const Surface surface = shapes::torus_surface(1, 0.15, 60, 20);
  const CrossField field = solved(surface, {});
  EXPECT_GT(std::count(field.reliable.begin(), field.reliable.end(), 1), 500);
  for (std::size_t i = 0; i < field.directions.size(); ++i) {
    if (!field.reliable[i]) continue;
    EXPECT_LT(off_cross(field.directions[i], surface.normals[i], surface.curvature[i].w1), 1e-9);
  }
}

TEST(CrossFieldSolve, EachThresholdMakesVerticesUnreliable) {
  Surface surface = shapes::torus_surface(1, 0.15, 60, 20);
  const auto count = [&](const FieldOptions& options) {
    const CrossField field = solved(surface, options);
    return std::count(field.reliable.begin(), field.reliable.end(), 1);
  };
  EXPECT_EQ(count(all_free()), 0);
  FieldOptions flat;
  flat.least_curvature = 100;  // the tube's curvature times the diagonal is 22
  EXPECT_EQ(count(flat), 0);
  const auto before = count({});
  const std::size_t odd = 7 * 20;  // turned by 45 degrees: its neighbours are irregular, too
  Vec3 &w1 = surface.curvature[odd].w1, &w2 = surface.curvature[odd].w2;
  w1 = (w1 + w2).normalized();
  w2 = surface.normals[odd].cross(w1);
  const auto after = count({});
  EXPECT_LT(after, before);
  EXPECT_GE(after, before - 7);
}

TEST(CrossFieldSolve, PartsAreSolvedOneByOne) {
  const Surface sphere = shapes::sphere_surface(1, 3, {5, 0, 0});
  const Surface both = shapes::joined(shapes::torus_surface(1, 0.4, 32, 16), sphere);
  const CrossField field = solved(both, all_free());
  int on_torus = 0, on_sphere = 0;
  for (std::size_t s = 0; s < field.singular_triangles.size(); ++s) {
    const bool first = both.triangle_objects[index_of(field.singular_triangles[s])] == 0;
    (first ? on_torus : on_sphere) += field.singular_indices[s];
  }
  EXPECT_EQ(on_torus, 0);
  EXPECT_EQ(on_sphere, 8);
}

TEST(CrossFieldSolve, ManyLooseTriangles) {
  const Surface surface = shapes::plain_surface(shapes::unwelded(shapes::icosphere_mesh(1, 4)));
  const CrossField field = solved(surface, {});
  EXPECT_TRUE(field.singular_triangles.empty());
}

// Across a seam where the cross jumped the energy of an edge would not depend on its length.
TEST(CrossFieldSolve, SurfacesThatCannotBeOrientedHaveNoSeam) {
  const auto mean_energy = [](const Surface& surface) {
    EXPECT_GT(std::count_if(surface.flips.begin(), surface.flips.end(),
                            [](std::uint8_t bits) { return bits != 0; }),
              0);
    const CrossField field = solved(surface, {});
    int edges = 0;
    paper_energy(surface, field.directions, &edges);
    return 1 + field.energy / edges;
  };
  EXPECT_LT(mean_energy(unorientable(shapes::moebius_mesh(120, 12))),
            0.35 * mean_energy(unorientable(shapes::moebius_mesh(60, 6))));
  EXPECT_LT(mean_energy(unorientable(shapes::klein_mesh(120, 48))),
            0.35 * mean_energy(unorientable(shapes::klein_mesh(60, 24))));
}

TEST(CrossFieldSolve, TurningVerticesOverChangesNothing) {
  const Surface plain = smooth_cube(3);
  Surface seamed = plain;
  for (std::size_t t = 0; t < seamed.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (seamed.triangles[t][k] % 3 == 0) {
        seamed.flips[t] = static_cast<std::uint8_t>(seamed.flips[t] | 1U << k);
      }
    }
  }
  for (std::size_t i = 0; i < seamed.normals.size(); i += 3) seamed.normals[i] *= -1;
  const CrossField expected = solved(plain, all_free()), field = solved(seamed, all_free());
  EXPECT_NEAR(field.energy, expected.energy, 1e-4 * std::abs(expected.energy));
  EXPECT_EQ(index_sum(field), 8);
  EXPECT_EQ(field.singular_triangles.size(), 8U);
}

TEST(CrossFieldSolve, FindsAFarBetterBasinThanTheInitialField) {
  const Surface surface = blob(5);
  const CrossField field = solved(surface, all_free());
  EXPECT_EQ(field.singular_triangles.size(), 8U);
  EXPECT_TRUE(field.converged);
  const FieldGraph graph = whole_graph(surface);
  CrossNumbers nearby(graph.size(), 1);
  minimise(graph, 500, 1, nearby, {});
  const double edges = 1.5 * static_cast<double>(surface.triangles.size());
  const double local = energy(graph, arguments(nearby).data(), nullptr, 1);
  EXPECT_LT(1 + field.energy / edges, 0.7 * (1 + local / edges));
}

TEST(CrossFieldSolve, SameBytesForAnyThreadCount) {
  const Surface surface = blob(5);
  FieldOptions options = all_free();
  const CrossField one = solve_cross_field(surface, surface.curvature, options);
  options.threads = 2;
  const CrossField two = solve_cross_field(surface, surface.curvature, options);
  ASSERT_EQ(one.theta.size(), two.theta.size());
  EXPECT_EQ(std::memcmp(one.theta.data(), two.theta.data(), sizeof(double) * one.theta.size()), 0);
  EXPECT_EQ(std::memcmp(one.directions.data(), two.directions.data(),
                        sizeof(Vec3) * one.directions.size()),
            0);
  EXPECT_EQ(one.energy, two.energy);
  EXPECT_EQ(one.singular_triangles, two.singular_triangles);
}

TEST(CrossFieldSolve, SmallestSurfaces) {
  EXPECT_TRUE(solved(Surface{}, {}).theta.empty());
  Surface triangle =
      shapes::plain_surface(shapes::polygon_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}));
  EXPECT_NEAR(solved(triangle, {}).energy, -3, 1e-9);
}

TEST(CrossFieldSolve, DegenerateInputGivesNoNaN) {
  Surface surface = smooth_cube(2);
  const double nan = std::nan("");
  surface.normals[3].setZero();
  surface.normals[8].setZero();
  surface.positions[10] = surface.positions[11];
  surface.curvature[5].k1 = nan;
  surface.curvature[6].w1 = Vec3(nan, nan, nan);
  surface.curvature[6].k1 = 3;
  const int last = surface.triangles[7][0];
  surface.positions[index_of(last)] *= 1e9;
  check(surface, solve_cross_field(surface, surface.curvature, {}));

  PolygonMesh flat = shapes::plane(4, 4);
  for (Vec3& p : flat.positions) p.setZero();
  Surface point = shapes::plain_surface(flat);
  for (Vec3& normal : point.normals) normal = Vec3::Zero();
  check(point, solve_cross_field(point, point.curvature, {}));
}

TEST(CrossFieldSolve, UnusedVerticesAreLeftAlone) {
  PolygonMesh mesh = shapes::icosphere_mesh(1, 2);
  mesh.positions.emplace_back(0, 0, 9);
  const CrossField field = solved(shapes::plain_surface(mesh), {});
  EXPECT_EQ(index_sum(field), 8);
}

TEST(CrossFieldSolve, StopsWhenAsked) {
  const Surface surface = smooth_cube(4);
  for (const int stop : {0, 3, 20, 60}) {
    int calls = 0;
    const Progress progress([&](double, const std::string&) { return calls++ < stop; }, "field");
    EXPECT_THROW(solve_cross_field(surface, surface.curvature, all_free(), {}, progress),
                 Cancelled);
    EXPECT_EQ(calls, stop + 1);
  }
}

TEST(CrossFieldSolve, ProgressNeverGoesBack) {
  const Surface surface = blob(4);
  double last = 0;
  const Progress progress(
      [&](double fraction, const std::string&) {
        EXPECT_GE(fraction, last);
        last = fraction;
        return fraction <= 1;
      },
      "field");
  solve_cross_field(surface, surface.curvature, all_free(), {}, progress);
  EXPECT_GT(last, 0.5);
}

TEST(CrossFieldSolve, NamesTheOptionThatIsWrong) {
  const auto message = [](const auto& spoil) {
    FieldOptions options;
    spoil(options);
    try {
      validate(options);
    } catch (const InvalidInput& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(message([](FieldOptions&) {}), "");
  const auto names = [&](const char* name, const auto& spoil) {
    EXPECT_NE(message(spoil).find(name), std::string::npos) << name;
  };
  names("parabolic_ratio", [](FieldOptions& o) { o.parabolic_ratio = -1; });
  names("least_curvature", [](FieldOptions& o) { o.least_curvature = std::nan(""); });
  names("largest_energy", [](FieldOptions& o) { o.largest_energy = -0.1; });
  names("alignment_weight", [](FieldOptions& o) { o.alignment_weight = -0.1; });
  names("default_direction", [](FieldOptions& o) { o.default_direction.setZero(); });
  names("max_evaluations", [](FieldOptions& o) { o.max_evaluations = -1; });
  names("threads", [](FieldOptions& o) { o.threads = -1; });
}

// --- directions between the vertices -------------------------------------------------------------

TEST(CrossDirection, IsTheNearestBranchInTheTangentPlane) {
  const Surface surface = cylinder(48, 20, Vec3::UnitZ());
  const CrossField field = solved(surface, {});
  for (const int triangle : {0, 17, 500}) {
    const SurfacePoint at{triangle, 0.3, 0.5};
    const Vec3 normal = normal_at(surface, at);
    const Vec3 around = Vec3::UnitZ().cross(normal);
    for (const Vec3& branch : {Vec3(Vec3::UnitZ()), Vec3(-Vec3::UnitZ()), around, Vec3(-around)}) {
      const Vec3 between = branch + 0.3 * Vec3(1, 1, 1);
      const Vec3 found = cross_direction(surface, field, at, between);
      const Vec3 exact = cross_direction(surface, field, at, branch);
      EXPECT_NEAR(exact.norm(), 1, 1e-9);
      EXPECT_NEAR(exact.dot(normal), 0, 1e-9);
      EXPECT_GT(exact.dot(branch), 1 - 1e-6);
      EXPECT_GE(found.dot(between), exact.dot(between) - 1e-9);
    }
  }
}

TEST(CrossDirection, IsContinuousAcrossEdgesAndSheets) {
  const Surface surface = unorientable(shapes::klein_mesh(60, 24));
  const CrossField field = solved(surface, {});
  std::set<int> singular(field.singular_triangles.begin(), field.singular_triangles.end());
  for (int t = 0; t < static_cast<int>(surface.triangles.size()); t += 7) {
    const int other = surface.neighbours[index_of(t)][0];
    if (other == none || singular.count(t) + singular.count(other) > 0) continue;
    const Triangle& here = surface.triangles[index_of(t)];
    const Triangle& there = surface.triangles[index_of(other)];
    const auto weight = [&](std::size_t k) {
      return there[k] == here[0] ? 0.6 : there[k] == here[1] ? 0.4 : 0.0;
    };
    const Vec3 towards(0.3, -0.5, 0.8);
    const Vec3 a = cross_direction(surface, field, {t, 0.4, 0}, towards);
    const Vec3 b = cross_direction(surface, field, {other, weight(1), weight(2)}, towards);
    EXPECT_LT(off_cross(a, normal_at(surface, {t, 0.4, 0}), b), 1e-6);
  }
}

TEST(CrossDirection, IsDefinedForAnyDirection) {
  const Surface surface = smooth_cube(2);
  const CrossField field = solved(surface, all_free());
  for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t) {
    const SurfacePoint at{t, 1.0 / 3, 1.0 / 3};
    for (const Vec3& towards : {Vec3(Vec3::Zero()), normal_at(surface, at)}) {
      EXPECT_NEAR(cross_direction(surface, field, at, towards).norm(), 1, 1e-9);
    }
  }
}

}  // namespace
}  // namespace illustrate
