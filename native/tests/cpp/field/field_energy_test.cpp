#include <gtest/gtest.h>

#include <numeric>
#include <set>

#include "field/search/hierarchy.h"
#include "field/singularities.h"
#include "tests/cpp/field/field_checks.h"

namespace illustrate {
namespace {

using namespace field_checks;

// --- energy --------------------------------------------------------------------------------------

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
  const auto edges =
      field_edges(surface, triangle_edges(surface), tangent_frames(surface.normals, 1), {}, 1);
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
    const Hierarchy hierarchy(fine, fine.size() - 1, Pairing::parallel, {});
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

// --- singularities -------------------------------------------------------------------------------

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
    const TriangleEdges edges = triangle_edges(surface);
    const std::vector<int> indices = triangle_indices(
        surface, edges, field_edges(surface, edges, frames, {}, 1),
        triangle_excess(surface, edges, frames, 1, {}), random_crosses(frames.size(), 9), 1, {});
    EXPECT_NE(std::count(indices.begin(), indices.end(), 0), static_cast<long>(indices.size()));
    EXPECT_EQ(std::accumulate(indices.begin(), indices.end(), 0), four_chi);
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

}  // namespace
}  // namespace illustrate
