#include "mesh/memory_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

#include "tests/cpp/shapes.h"

namespace illustrate {
namespace {

std::vector<int> shuffled(std::size_t count, unsigned seed) {
  std::vector<int> order(count);
  std::iota(order.begin(), order.end(), 0);
  std::mt19937 random(seed);
  for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[random() % i]);
  return order;
}

// A mesh with its faces and vertices in any order; faces carry their number as their material.
PolygonMesh scattered(const PolygonMesh& mesh) {
  PolygonMesh result = mesh;
  const std::vector<int> vertices = shuffled(mesh.positions.size(), 1);
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    result.positions[idx(vertices[v])] = mesh.positions[v];
  }
  result.corner_vertices.clear();
  const auto size = static_cast<std::size_t>(mesh.face_sizes[0]);
  for (const int face : shuffled(mesh.face_sizes.size(), 2)) {
    for (std::size_t k = 0; k < size; ++k) {
      const int vertex = mesh.corner_vertices[idx(face) * size + k];
      result.corner_vertices.push_back(vertices[idx(vertex)]);
    }
  }
  result.face_materials.resize(mesh.face_sizes.size());
  std::iota(result.face_materials.begin(), result.face_materials.end(), 0);
  return result;
}

SoundMesh sound_of(const PolygonMesh& mesh) {
  Counts report;
  return sanitize(mesh, report);
}

double mean_jump(const std::vector<int>& corners) {
  double sum = 0;
  for (std::size_t c = 1; c < corners.size(); ++c) sum += std::abs(corners[c] - corners[c - 1]);
  return sum / static_cast<double>(corners.size());
}

TEST(MemoryOrder, NeighboursLieNearEachOther) {
  for (const int side : {80, 160}) {
    const PolygonMesh mesh = scattered(shapes::plane(side, side));
    const double root = std::sqrt(static_cast<double>(mesh.positions.size()));
    EXPECT_GT(mean_jump(mesh.corner_vertices), 20 * root);
    EXPECT_LT(mean_jump(sound_of(mesh).corner_vertices), 2 * root);
  }
}

TEST(MemoryOrder, IsTheSameMesh) {
  PolygonMesh mesh = scattered(shapes::plane(80, 80));
  mesh.edge_vertices = {{mesh.corner_vertices[0], mesh.corner_vertices[1]}};
  mesh.edge_sharpness = {3};
  mesh.marked_edges = {{mesh.corner_vertices[4], mesh.corner_vertices[5]}};
  mesh.vertex_sharpness.assign(mesh.positions.size(), 0);
  mesh.vertex_sharpness[7] = 2;
  mesh.hole_faces = {11};
  const SoundMesh sound = sound_of(mesh);
  ASSERT_EQ(sound.positions.size(), mesh.positions.size());
  ASSERT_EQ(sound.face_sizes.size(), mesh.face_sizes.size());
  const auto source = [&](int vertex) { return sound.source_vertices[idx(vertex)]; };
  std::set<int> sources;
  std::size_t corner = 0;
  for (std::size_t f = 0; f < sound.face_sizes.size(); ++f) {
    const int face = sound.source_faces[f];
    sources.insert(face);
    EXPECT_EQ(sound.face_materials[f], face);
    EXPECT_EQ(sound.holes[f], face == 11);
    for (std::size_t k = 0; k < 4; ++k, ++corner) {
      EXPECT_EQ(source(sound.corner_vertices[corner]), mesh.corner_vertices[idx(face) * 4 + k]);
    }
  }
  EXPECT_EQ(sources.size(), mesh.face_sizes.size());
  for (std::size_t v = 0; v < sound.positions.size(); ++v) {
    EXPECT_EQ(sound.positions[v], mesh.positions[idx(sound.source_vertices[v])]);
    EXPECT_EQ(sound.vertex_sharpness[v], sound.source_vertices[v] == 7 ? 2 : 0);
  }
  const auto sources_of = [&](const Edge& edge) {
    return std::minmax({source(edge[0]), source(edge[1])});
  };
  EXPECT_EQ(sources_of(sound.edge_vertices.at(0)),
            std::minmax({mesh.corner_vertices[0], mesh.corner_vertices[1]}));
  EXPECT_EQ(sources_of(sound.marked_edges.at(0)),
            std::minmax({mesh.corner_vertices[4], mesh.corner_vertices[5]}));
}

TEST(MemoryOrder, NormalsStayAtTheirCorners) {
  PolygonMesh mesh = scattered(shapes::plane(80, 80));
  for (const int vertex : mesh.corner_vertices) {
    const Vec3& p = mesh.positions[idx(vertex)];
    mesh.corner_normals.push_back(Vec3(0.1 * p.x(), 0.1 * p.y(), 1).normalized());
  }
  const SoundMesh sound = sound_of(mesh);
  ASSERT_EQ(sound.corner_normals.size(), sound.corner_vertices.size());
  for (std::size_t c = 0; c < sound.corner_vertices.size(); ++c) {
    const Vec3& p = sound.positions[idx(sound.corner_vertices[c])];
    EXPECT_LT((sound.corner_normals[c] - Vec3(0.1 * p.x(), 0.1 * p.y(), 1).normalized()).norm(),
              1e-12);
  }
}

TEST(MemoryOrder, ASeamRunsAlongItsFace) {
  PolygonMesh mesh = scattered(shapes::plane(80, 80));
  const int count = static_cast<int>(mesh.positions.size());
  for (int k = 0; k < 2; ++k) {  // a fin on an edge inside
    mesh.positions.push_back(mesh.positions[idx(mesh.corner_vertices[idx(k)])] + Vec3::UnitZ());
  }
  mesh.corner_vertices.insert(mesh.corner_vertices.end(),
                              {mesh.corner_vertices[0], mesh.corner_vertices[1], count + 1, count});
  mesh.face_sizes.push_back(4);
  mesh.face_materials.push_back(0);
  const SoundMesh sound = sound_of(mesh);
  std::set<Edge> half_edges;
  for (std::size_t c = 0; c < sound.corner_vertices.size(); ++c) {
    const std::size_t next = c % 4 == 3 ? c - 3 : c + 1;
    half_edges.insert({sound.corner_vertices[c], sound.corner_vertices[next]});
  }
  EXPECT_FALSE(sound.seams.empty());
  for (const Edge& seam : sound.seams) EXPECT_EQ(half_edges.count(seam), 1U);
}

TEST(MemoryOrder, DoesNotDependOnThePose) {
  PolygonMesh mesh = scattered(shapes::plane(80, 80));
  const std::vector<int> before = sound_of(mesh).source_vertices;
  for (Vec3& p : mesh.positions) p.z() += std::sin(3 * p.x()) * p.y();
  EXPECT_EQ(sound_of(mesh).source_vertices, before);
}

TEST(MemoryOrder, GoodOrdersStay) {
  const PolygonMesh mesh = shapes::plane(160, 160);
  const SoundMesh sound = sound_of(mesh);
  EXPECT_EQ(sound.corner_vertices, mesh.corner_vertices);
  EXPECT_EQ(sound.source_faces.back(), static_cast<int>(mesh.face_sizes.size()) - 1);
}

}  // namespace
}  // namespace illustrate
