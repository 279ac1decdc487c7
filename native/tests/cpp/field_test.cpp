#include <gtest/gtest.h>

#include <cstring>
#include <random>
#include <set>

#include "core/errors.h"
#include "field/cross_field.h"
#include "field/diffusion.h"
#include "field/energy.h"
#include "field/hierarchy.h"
#include "field/minimise.h"
#include "field/singularities.h"
#include "tests/cpp/shapes.h"

namespace illustrate {
namespace {

using shapes::pi;

FieldOptions all_free() {
  FieldOptions options;
  options.parabolic_ratio = 0;
  options.threads = 1;
  return options;
}

std::size_t index_of(int i) { return static_cast<std::size_t>(i); }

// --- the paper's formulas, written down once more -----------------------------------------------------

double projected_angle(const Vec3& normal, const Vec3& from, const Vec3& to) {
  const Vec3 a = (from - from.dot(normal) * normal).normalized();
  const Vec3 b = (to - to.dot(normal) * normal).normalized();
  return std::atan2(a.cross(b).dot(normal), a.dot(b));
}

// - sum of cos 4((theta_i - phi_ij) - (theta_j - phi_ji)); across sheets the angles at j are turned over.
double paper_energy(const Surface& surface, const Points& directions, int* edge_count = nullptr) {
  std::map<Edge, double> terms;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const int a = surface.triangles[t][index_of(k)];
      const int b = surface.triangles[t][index_of(next_corner(k))];
      const auto i = index_of(std::min(a, b)), j = index_of(std::max(a, b));
      const Vec3 along = surface.positions[j] - surface.positions[i];
      const double sign = surface.corner_sign(static_cast<int>(t), k) *
                          surface.corner_sign(static_cast<int>(t), next_corner(k));
      const double at_i = projected_angle(surface.normals[i], along, directions[i]);
      const double at_j = projected_angle(surface.normals[j], along, directions[j]);
      terms[{std::min(a, b), std::max(a, b)}] = -std::cos(4 * (at_i - sign * at_j));
    }
  }
  double sum = 0;
  for (const auto& [edge, term] : terms) sum += term;
  if (edge_count) *edge_count = static_cast<int>(terms.size());
  return sum;
}

// What holds for the field of any surface.
void check(const Surface& surface, const CrossField& field) {
  const std::size_t n = surface.positions.size();
  ASSERT_EQ(field.theta.size(), n);
  ASSERT_EQ(field.reliable.size(), n);
  for (std::size_t i = 0; i < n; ++i) {
    ASSERT_TRUE(std::isfinite(field.theta[i]));
    ASSERT_NEAR(field.directions[i].norm(), 1, 1e-9);
    ASSERT_NEAR(field.reference[i].norm(), 1, 1e-9);
    if (surface.normals[i].norm() > 0.5) {
      ASSERT_NEAR(field.directions[i].dot(surface.normals[i]), 0, 1e-9);
      ASSERT_NEAR(projected_angle(surface.normals[i], field.reference[i], field.directions[i]),
                  field.theta[i], 1e-9);
    }
  }
  EXPECT_LE(field.energy, field.energy_initial);
  EXPECT_EQ(field.singular_triangles.size(), field.singular_indices.size());
}

CrossField solved(const Surface& surface, const FieldOptions& options) {
  CrossField field = solve_cross_field(surface, surface.curvature, options);
  check(surface, field);
  return field;
}

int index_sum(const CrossField& field) {
  int sum = 0;
  for (const int index : field.singular_indices) sum += index;
  return sum;
}

// Sine of four times... of the angle between a cross and a direction, in [0, sin 45 deg].
double off_cross(const Vec3& cross, const Vec3& normal, const Vec3& direction) {
  return std::min(std::abs(cross.dot(direction)), std::abs(normal.cross(cross).dot(direction)));
}

// --- surfaces -----------------------------------------------------------------------------------------

// Open, axis `axis`, radius 1, with analytic normals and curvature.
Surface cylinder(int around, int along, const Vec3& axis, double height = 3) {
  const Vec3 x = axis.unitOrthogonal(), y = axis.cross(x);
  Points positions;
  for (int i = 0; i < around; ++i)
    for (int j = 0; j <= along; ++j) {
      const double u = 2 * pi * i / around;
      positions.push_back(std::cos(u) * x + std::sin(u) * y + height * j / along * axis);
    }
  Surface surface = shapes::plain_surface(shapes::quads(
      around, along, positions, [=](int i, int j) { return i % around * (along + 1) + j; }));
  for (std::size_t i = 0; i < positions.size(); ++i) {
    surface.normals[i] = (positions[i] - positions[i].dot(axis) * axis).normalized();
    shapes::set_curvature(surface, i, -1, axis.cross(surface.normals[i]), 0, axis);
  }
  return surface;
}

// The surface of unit cubes: a slab of 5 x 3 x 1 with two holes, each face cut in `cells` squared.
Surface two_holed_slab(int cells) {
  const auto is_solid = [](const Eigen::Vector3i& c) {
    const bool inside = c.minCoeff() >= 0 && c.x() < 5 && c.y() < 3 && c.z() < 1;
    return inside && !(c.y() == 1 && (c.x() == 1 || c.x() == 3));
  };
  PolygonMesh mesh;
  std::map<std::array<int, 3>, int> numbers;
  const auto vertex = [&](const Eigen::Vector3i& at) {
    const auto [entry, is_new] = numbers.try_emplace({at.x(), at.y(), at.z()},
                                                     static_cast<int>(mesh.positions.size()));
    if (is_new) mesh.positions.push_back(at.cast<double>() / cells);
    return entry->second;
  };
  for (int c = 0; c < 15; ++c)
    for (int axis = 0; axis < 3; ++axis)
      for (int side = 0; side < 2; ++side) {
        const Eigen::Vector3i cube(c % 5, c / 5, 0), out = Eigen::Vector3i::Unit(axis);
        if (!is_solid(cube) || is_solid(cube + (2 * side - 1) * out)) continue;
        const Eigen::Vector3i u = Eigen::Vector3i::Unit((axis + (side ? 1 : 2)) % 3);
        const Eigen::Vector3i v = Eigen::Vector3i::Unit((axis + (side ? 2 : 1)) % 3);
        for (int a = 0; a < cells; ++a)
          for (int b = 0; b < cells; ++b) {
            const Eigen::Vector3i at = cells * (cube + side * out) + a * u + b * v;
            shapes::add_face(mesh, {vertex(at), vertex(at + u), vertex(at + u + v), vertex(at + v)});
          }
      }
  return shapes::plain_surface(mesh);
}

// Triangles keep their windings; the normal of a vertex is that of the sheet of its first triangle.
Surface unorientable(const PolygonMesh& mesh) {
  Surface surface = shapes::plain_surface(mesh);
  const auto face_normal = [&](const Triangle& t) {
    const Vec3& origin = surface.positions[index_of(t[0])];
    return Vec3((surface.positions[index_of(t[1])] - origin)
                    .cross(surface.positions[index_of(t[2])] - origin));
  };
  Points sums(surface.positions.size(), Vec3::Zero());
  for (const Triangle& t : surface.triangles) {
    for (const int vertex : t) {
      Vec3& sum = sums[index_of(vertex)];
      sum += sum.dot(face_normal(t)) < 0 ? Vec3(-face_normal(t)) : face_normal(t);
    }
  }
  for (std::size_t i = 0; i < sums.size(); ++i) surface.normals[i] = sums[i].normalized();
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& normal = surface.normals[index_of(surface.triangles[t][k])];
      if (normal.dot(face_normal(surface.triangles[t])) < 0) {
        surface.flips[t] = static_cast<std::uint8_t>(surface.flips[t] | 1U << k);
      }
    }
  }
  return surface;
}

// |x|^6 + |y|^6 + |z|^6 = 1: a cube with smooth edges and corners.
Surface smooth_cube(int level) {
  PolygonMesh mesh = shapes::icosphere_mesh(1, level);
  for (Vec3& p : mesh.positions) p /= std::pow(p.array().abs().pow(6).sum(), 1.0 / 6);
  return shapes::plain_surface(mesh);
}

Surface blob(int level) {
  PolygonMesh mesh = shapes::icosphere_mesh(1, level);
  for (Vec3& p : mesh.positions) {
    const double x = p.x(), y = p.y(), z = p.z();
    p *= 1 + 0.15 * std::sin(5 * x + 1) * std::sin(4 * y + 2) * std::sin(6 * z + 3) +
         0.06 * std::sin(11 * x) * std::sin(9 * y + 1) + 0.05 * std::sin(13 * z + x);
  }
  return shapes::plain_surface(mesh);
}

// Faces as they are, with vertices of their own; what was one vertex is one place, what was one edge a crease.
Surface creased(const PolygonMesh& mesh) {
  Surface surface = shapes::plain_surface(shapes::unwelded(mesh));
  surface.places = mesh.corner_vertices;
  shapes::link_neighbours(surface);
  std::map<Edge, int> triangles;
  const auto own_edge = [&](std::size_t t, int k) {
    const int a = surface.triangles[t][index_of(k)];
    const int b = surface.triangles[t][index_of(next_corner(k))];
    return Edge{std::min(a, b), std::max(a, b)};
  };
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) ++triangles[own_edge(t, k)];
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k)
      if (triangles[own_edge(t, k)] == 1) surface.edge_kinds[t][index_of(k)] = EdgeKind::crease;
  return surface;
}

PolygonMesh rotated(PolygonMesh mesh, double angle, const Vec3& axis) {
  const Eigen::AngleAxisd rotation(angle, axis.normalized());
  for (Vec3& p : mesh.positions) p = rotation * p;
  return mesh;
}

FieldGraph whole_graph(const Surface& surface, const CrossNumbers& pulls) {
  const TangentFrames frames = tangent_frames(surface.normals, 1);
  std::vector<int> vertices;
  return free_graph(field_edges(surface, triangle_edges(surface), frames, 1), pulls,
                    std::vector<std::uint8_t>(pulls.size(), 0), CrossNumbers(pulls.size(), 1),
                    vertices);
}

FieldGraph whole_graph(const Surface& surface) {
  return whole_graph(surface, CrossNumbers(surface.positions.size(), 0));
}

CrossNumbers random_crosses(std::size_t count, std::uint64_t seed) {
  SeededNumbers numbers(seed);
  CrossNumbers z(count);
  for (CrossNumber& cross : z) cross = normalized(numbers.number(), 1);
  return z;
}

std::vector<double> arguments(const CrossNumbers& z) {
  std::vector<double> u;
  for (const CrossNumber& cross : z) u.push_back(std::arg(cross));
  return u;
}

// --- energy -------------------------------------------------------------------------------------------

TEST(FieldEnergy, IsThePapersSum) {
  for (const Surface& surface : {shapes::torus_surface(1, 0.4, 24, 12), smooth_cube(3),
                                 unorientable(shapes::klein_mesh(60, 24))}) {
    const CrossField field = solved(surface, all_free());
    EXPECT_NEAR(field.energy, paper_energy(surface, field.directions), 1e-6);
  }
}

TEST(FieldEnergy, DoesNotChangeByQuarterTurns) {
  const Surface surface = smooth_cube(3);
  const CrossField field = solved(surface, all_free());
  Points turned = field.directions;
  for (std::size_t i = 0; i < turned.size(); i += 3) {
    turned[i] = surface.normals[i].cross(turned[i]);
  }
  EXPECT_NEAR(paper_energy(surface, turned), field.energy, 1e-6);
  const std::size_t some = 5;
  turned[some] = (turned[some] + surface.normals[some].cross(turned[some])).normalized();
  EXPECT_GT(paper_energy(surface, turned), field.energy + 1);
}

TEST(FieldEnergy, GradientAgreesWithDifferences) {
  const Surface surface = unorientable(shapes::moebius_mesh(12, 3));
  const std::size_t n = surface.positions.size();
  CrossNumbers pulls = random_crosses(n, 3);
  for (std::size_t i = 0; i < n; i += 2) pulls[i] *= 0.3;
  const FieldGraph graph = whole_graph(surface, pulls);
  std::vector<double> u = arguments(random_crosses(n, 4)), gradient(n);
  energy(graph, u.data(), gradient.data(), 1);
  const double h = 1e-5;
  for (std::size_t i = 0; i < n; ++i) {
    const double at = u[i];
    u[i] = at + h;
    const double above = energy(graph, u.data(), nullptr, 1);
    u[i] = at - h;
    const double below = energy(graph, u.data(), nullptr, 1);
    u[i] = at;
    EXPECT_NEAR(gradient[i], (above - below) / (2 * h), 1e-6);
  }
}

TEST(FieldEnergy, HeldCrossesPullTheirNeighbours) {
  const Surface surface = unorientable(shapes::klein_mesh(60, 24));
  const std::size_t n = surface.positions.size();
  const auto edges = field_edges(surface, triangle_edges(surface),
                                 tangent_frames(surface.normals, 1), 1);
  const CrossNumbers first = random_crosses(n, 5);
  CrossNumbers second = random_crosses(n, 6);
  std::vector<std::uint8_t> held(n, 0);
  for (std::size_t i = 0; i < n; i += 3) {
    held[i] = 1;
    second[i] = first[i];
  }
  std::vector<int> vertices;
  const FieldGraph graph = free_graph(edges, CrossNumbers(n, 0), held, first, vertices);
  const auto reduced = [&](const CrossNumbers& z) {
    std::vector<double> u;
    for (const int vertex : vertices) u.push_back(std::arg(z[index_of(vertex)]));
    return energy(graph, u.data(), nullptr, 1);
  };
  EXPECT_NEAR(reduced(second) - reduced(first), energy(edges, second) - energy(edges, first), 1e-9);
}

TEST(FieldHierarchy, AggregatesHaveTheSameEnergyUpToAConstant) {
  for (const Surface& surface : {smooth_cube(3), unorientable(shapes::klein_mesh(60, 24))}) {
    const FieldGraph fine = whole_graph(surface, random_crosses(surface.positions.size(), 1));
    const Hierarchy hierarchy(fine, fine.size() - 1, {});
    ASSERT_EQ(hierarchy.coarsest(), 1U);
    const FieldGraph& coarse = hierarchy.graph(1);
    EXPECT_LT(coarse.size(), fine.size() * 2 / 3);
    std::set<long> differences;
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
      const CrossNumbers z = random_crosses(coarse.size(), seed);
      const CrossNumbers prolonged = hierarchy.prolonged(z, 0);
      const double difference = energy(fine, arguments(prolonged).data(), nullptr, 1) -
                                energy(coarse, arguments(z).data(), nullptr, 1);
      differences.insert(std::lround(difference * 1e6));
      const CrossNumbers back = hierarchy.restricted(prolonged);
      for (std::size_t i = 0; i < z.size(); ++i) EXPECT_NEAR(std::abs(back[i] - z[i]), 0, 1e-9);
    }
    EXPECT_LE(*differences.rbegin() - *differences.begin(), 1);
  }
}

TEST(FieldHierarchy, SweepsNeverRaiseTheEnergy) {
  const FieldGraph graph = whole_graph(unorientable(shapes::klein_mesh(60, 24)));
  CrossNumbers z = random_crosses(graph.size(), 1);
  double last = energy(graph, arguments(z).data(), nullptr, 1);
  for (int k = 0; k < 10; ++k) {
    sweep(graph, 1, z);
    const double now = energy(graph, arguments(z).data(), nullptr, 1);
    EXPECT_LT(now, last);
    last = now;
  }
}

// --- singularities ------------------------------------------------------------------------------------

TEST(FieldSingularities, SumToFourChiOfTheLeastField) {
  EXPECT_EQ(index_sum(solved(shapes::sphere_surface(1, 3), all_free())), 8);
  EXPECT_EQ(index_sum(solved(shapes::torus_surface(1, 0.4, 32, 16), all_free())), 0);
  EXPECT_EQ(index_sum(solved(two_holed_slab(2), all_free())), -8);
  EXPECT_EQ(index_sum(solved(unorientable(shapes::klein_mesh(60, 24)), all_free())), 0);
}

TEST(FieldSingularities, SumToFourChiForAnyField) {
  const std::pair<Surface, int> cases[] = {
      {shapes::sphere_surface(1, 2), 8},
      {shapes::torus_surface(1, 0.4, 20, 10), 0},
      {two_holed_slab(2), -8},
      {shapes::plain_surface(shapes::tetrahedron()), 8},
      {unorientable(shapes::klein_mesh(60, 24)), 0},
  };
  for (const auto& [surface, four_chi] : cases) {
    const TangentFrames frames = tangent_frames(surface.normals, 1);
    const std::vector<double> u = arguments(random_crosses(frames.size(), 9));
    CrossField field;
    for (std::size_t i = 0; i < u.size(); ++i) field.directions.push_back(frames.direction(i, u[i]));
    find_singularities(surface, triangle_edges(surface), frames, 1, field);
    EXPECT_GT(field.singular_triangles.size(), 0U);
    EXPECT_EQ(index_sum(field), four_chi);
  }
}

// The paper's figure 10, eight times.
TEST(FieldSingularities, EveryCornerOfASmoothCubeHasOne) {
  const Surface surface = smooth_cube(4);
  const CrossField field = solved(surface, all_free());
  ASSERT_EQ(field.singular_triangles.size(), 8U);
  std::set<int> octants;
  for (std::size_t s = 0; s < 8; ++s) {
    EXPECT_EQ(field.singular_indices[s], 1);
    const Triangle& t = surface.triangles[index_of(field.singular_triangles[s])];
    const Vec3& p = surface.positions[index_of(t[0])];
    EXPECT_GT(p.cwiseAbs().minCoeff(), 0.6);
    octants.insert((p.x() > 0) + 2 * (p.y() > 0) + 4 * (p.z() > 0));
  }
  EXPECT_EQ(octants.size(), 8U);
}

// --- solved fields ------------------------------------------------------------------------------------

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
  const Surface surface =
      shapes::plain_surface(rotated(shapes::plane(12, 12), 0.4, Vec3::UnitZ()));
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
      along_an_axis = std::max(along_an_axis,
                               std::abs(field.directions[i].dot(rotation * Vec3::Unit(axis))));
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
    EXPECT_LT(off_cross(field.directions[i], surface.normals[i], surface.curvature.w1[i]), 1e-9);
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
  const std::size_t odd = 7 * 20;  // its cross is turned by 45 degrees, so its neighbours are irregular, too
  surface.curvature.w1[odd] = (surface.curvature.w1[odd] + surface.curvature.w2[odd]).normalized();
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
  const Surface surface =
      shapes::plain_surface(shapes::unwelded(shapes::icosphere_mesh(1, 4)));
  const CrossField field = solved(surface, {});
  EXPECT_TRUE(field.singular_triangles.empty());
}

// Across a seam where the cross jumped the energy of an edge would not depend on its length.
TEST(CrossFieldSolve, SurfacesThatCannotBeOrientedHaveNoSeam) {
  const auto mean_energy = [](const Surface& surface) {
    EXPECT_GT(std::count_if(surface.flips.begin(), surface.flips.end(),
                            [](std::uint8_t bits) { return bits != 0; }), 0);
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
                        sizeof(Vec3) * one.directions.size()), 0);
  EXPECT_EQ(one.energy, two.energy);
  EXPECT_EQ(one.singular_triangles, two.singular_triangles);
}

TEST(CrossFieldSolve, SmallestSurfaces) {
  EXPECT_TRUE(solved(Surface{}, {}).theta.empty());
  Surface triangle = shapes::plain_surface(
      shapes::polygon_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}));
  EXPECT_NEAR(solved(triangle, {}).energy, -3, 1e-9);
}

TEST(CrossFieldSolve, DegenerateInputGivesNoNaN) {
  Surface surface = smooth_cube(2);
  const double nan = std::nan("");
  surface.normals[3].setZero();
  surface.normals[8].setZero();
  surface.positions[10] = surface.positions[11];
  surface.curvature.k1[5] = nan;
  surface.curvature.w1[6] = Vec3(nan, nan, nan);
  surface.curvature.k1[6] = 3;
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
  const Surface surface = smooth_cube(3);
  for (const int stop : {0, 3, 20, 60}) {
    int calls = 0;
    const Progress progress([&](double, const std::string&) { return calls++ < stop; }, "field");
    EXPECT_THROW(solve_cross_field(surface, surface.curvature, all_free(), progress), Cancelled);
    EXPECT_EQ(calls, stop + 1);
  }
}

TEST(CrossFieldSolve, ProgressNeverGoesBack) {
  const Surface surface = blob(4);
  double last = 0;
  const Progress progress([&](double fraction, const std::string&) {
    EXPECT_GE(fraction, last);
    last = fraction;
    return fraction <= 1;
  }, "field");
  solve_cross_field(surface, surface.curvature, all_free(), progress);
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

// --- directions between the vertices ------------------------------------------------------------------

TEST(CrossDirection, IsTheNearestBranchInTheTangentPlane) {
  const Surface surface = cylinder(48, 20, Vec3::UnitZ());
  const CrossField field = solved(surface, {});
  for (const int triangle : {0, 17, 500}) {
    const SurfacePoint at{triangle, 0.3, 0.5};
    const Vec3 normal = normal_at(surface, at);
    const Vec3 around = Vec3::UnitZ().cross(normal);
    for (const Vec3& branch : {Vec3(Vec3::UnitZ()), Vec3(-Vec3::UnitZ()), around, Vec3(-around)}) {
      const Vec3 found = cross_direction(surface, field, at, branch + 0.3 * Vec3(1, 1, 1));
      const Vec3 exact = cross_direction(surface, field, at, branch);
      EXPECT_NEAR(exact.norm(), 1, 1e-9);
      EXPECT_NEAR(exact.dot(normal), 0, 1e-9);
      EXPECT_GT(exact.dot(branch), 1 - 1e-6);
      EXPECT_GE(found.dot(branch + 0.3 * Vec3(1, 1, 1)), exact.dot(branch + 0.3 * Vec3(1, 1, 1)) - 1e-9);
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
