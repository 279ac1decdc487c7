// Input of stage `mesh` that nobody would make on purpose.
#include "tests/cpp/check_sound.h"

#include <limits>
#include <random>
#include <set>
#include <string>

#include "core/errors.h"
#include "tests/cpp/shapes.h"

namespace illustrate {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

// Few vertices, so that edges with many faces, pinches and duplicates abound.
PolygonMesh nasty_mesh(unsigned seed) {
  std::mt19937 random(seed);
  const auto below = [&](int count) {
    return static_cast<int>(random() % static_cast<unsigned>(count));
  };
  const std::vector<double> coordinates{0, 1, 2, -0.0, 1e-30, 1e30, 0.5, not_a_number};
  const int vertices = 4 + below(20), faces = below(60), known = 3 + below(6);
  PolygonMesh mesh;
  for (int v = 0; v < vertices; ++v)
    mesh.positions.emplace_back(coordinates[below(known)], coordinates[below(known)],
                                coordinates[below(known)]);
  for (int f = 0; f < faces; ++f) {
    std::vector<int> face(below(6));
    for (int& vertex : face) vertex = below(vertices);
    shapes::add_face(mesh, face);
  }
  for (int e = 0; e < 10; ++e) {
    mesh.edge_vertices.push_back({below(vertices), below(vertices)});
    mesh.edge_sharpness.push_back(coordinates[below(8)]);
    mesh.marked_edges.push_back({below(vertices), below(vertices)});
  }
  mesh.crease_angle_deg = below(181);
  mesh.cage = below(2) == 0;
  mesh.edge_length = 2 * (seed % 8);
  if (below(2) == 0) return mesh;
  for (std::size_t c = 0; c < mesh.corner_vertices.size(); ++c)
    mesh.corner_normals.emplace_back(coordinates[below(8)], below(3) - 1, below(3) - 1);
  return mesh;
}

TEST(MeshInput, NastyMeshesBecomeSound) {
  Counts total;
  for (unsigned seed = 0; seed < 1500; ++seed) {
    const Mended mended = mend(nasty_mesh(seed));
    for (const auto& [name, count] : mended.report) total[name] += count;
    if (HasFailure()) FAIL() << "seed " << seed;
  }
  // Random faces are no strips, make no straight lines and are near no others.
  const std::set<std::string> rare{"huge_faces", "fine_bends", "crease_tails", "closed_gaps"};
  for (const auto& [name, count] : total)
    if (rare.count(name) == 0) {
      EXPECT_GT(count, 0) << name;
    }
}

TEST(MeshInput, SoundMeshesStaySound) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    const SoundMesh once = mend(nasty_mesh(seed)).mesh;
    PolygonMesh again;
    again.positions = once.positions;
    // What lies on each other would be welded again.
    for (std::size_t v = 0; v < again.positions.size(); ++v)
      again.positions[v] = {static_cast<double>(v), static_cast<double>(v * v), 1};
    again.face_sizes = once.face_sizes;
    again.corner_vertices = once.corner_vertices;
    const Mended twice = mend(again);
    EXPECT_EQ(twice.report.at("split_edges"), 0);
    EXPECT_EQ(twice.report.at("split_vertices"), 0);
    EXPECT_EQ(twice.report.at("flipped_faces"), 0);
    EXPECT_EQ(twice.report.at("covered_parts"), 0);
  }
}

void expect_invalid(const PolygonMesh& mesh, const std::string& words) {
  Counts report;
  try {
    sanitize(mesh, report);
    ADD_FAILURE() << "no error: " << words;
  } catch (const InvalidInput& error) {
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

template <class Change>
PolygonMesh changed(const Change& change) {
  PolygonMesh mesh = shapes::cube();
  change(mesh);
  return mesh;
}

TEST(MeshInput, ArraysThatDoNotFitAreNamed) {
  expect_invalid(changed([](auto& m) { m.face_sizes[2] = -4; }), "face_sizes[2] = -4");
  expect_invalid(changed([](auto& m) { m.face_sizes[2] = 5; }), "corner_vertices (24)");
  expect_invalid(changed([](auto& m) { m.corner_vertices[7] = 8; }), "corner_vertices[7] = 8");
  expect_invalid(changed([](auto& m) { m.corner_vertices[7] = -1; }), "corner_vertices[7] = -1");
  expect_invalid(changed([](auto& m) { m.edge_vertices = {{0, 1}}; }), "edge_sharpness (0)");
  expect_invalid(changed([](auto& m) {
                   m.edge_vertices = {{0, 9}};
                   m.edge_sharpness = {1};
                 }),
                 "edge_vertices[0] = 9");
  expect_invalid(changed([](auto& m) { m.vertex_sharpness = {1}; }), "vertex_sharpness (1)");
  expect_invalid(changed([](auto& m) { m.marked_edges = {{-2, 0}}; }), "marked_edges[0] = -2");
  expect_invalid(changed([](auto& m) { m.face_materials = {1}; }), "face_materials (1)");
  expect_invalid(changed([](auto& m) { m.hole_faces = {6}; }), "hole_faces[0] = 6");
  expect_invalid(changed([](auto& m) { m.crease_angle_deg = not_a_number; }), "crease_angle_deg");
  expect_invalid(changed([](auto& m) { m.level = -2; }), "level");
  expect_invalid(changed([](auto& m) { m.edge_length = -1; }), "edge_length");
}

}  // namespace
}  // namespace illustrate
