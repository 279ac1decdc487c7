#include "tests/cpp/check_sound.h"

#include <cmath>
#include <limits>

#include "tests/cpp/shapes.h"

namespace illustrate {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

// What describes a mesh, and does not tell of a repair.
const std::set<std::string> descriptions{"input_faces", "kept_faces", "parts", "polygons",
                                         "open_edges"};

// Nothing but the named repairs was done.
void expect_counts(const Counts& report, const Counts& expected) {
  for (const auto& [name, count] : report) {
    if (descriptions.count(name) && !expected.count(name)) continue;
    const auto found = expected.find(name);
    EXPECT_EQ(count, found == expected.end() ? 0 : found->second) << name;
  }
}

double volume(const SoundMesh& mesh) {
  double sum = 0;
  const int* corner = mesh.corner_vertices.data();
  for (const int size : mesh.face_sizes) {
    for (int k = 1; k + 1 < size; ++k)
      sum += mesh.positions[corner[0]].dot(
          mesh.positions[corner[k]].cross(mesh.positions[corner[k + 1]]));
    corner += size;
  }
  return sum / 6;
}

std::size_t count_open_edges(const SoundMesh& mesh) {
  const std::map<Edge, int> half_edges = check_half_edges(mesh);
  std::size_t open = 0;
  for (const auto& entry : half_edges)
    open += half_edges.count({entry.first[1], entry.first[0]}) == 0;
  return open;
}

int euler_characteristic(const SoundMesh& mesh) {
  const auto half_edges = mesh.corner_vertices.size();
  const auto edges = (half_edges + count_open_edges(mesh)) / 2;
  return static_cast<int>(mesh.positions.size()) - static_cast<int>(edges) +
         static_cast<int>(mesh.face_sizes.size());
}

TEST(Mesh, SoundMeshesPassUnchanged) {
  for (const PolygonMesh& input :
       {shapes::cube(), shapes::tetrahedron(), shapes::octahedron(), shapes::icosphere_mesh(1, 2),
        shapes::uv_sphere_mesh(1, 12, 7), shapes::torus_mesh(3, 1, 12, 8), shapes::plane(4, 3)}) {
    const Mended mended = mend(input);
    expect_counts(mended.report, {});
    EXPECT_EQ(mended.mesh.positions, input.positions);
    EXPECT_EQ(mended.mesh.face_sizes, input.face_sizes);
    EXPECT_EQ(mended.mesh.corner_vertices, input.corner_vertices);
    EXPECT_TRUE(mended.mesh.seams.empty());
  }
}

TEST(Mesh, NothingGivesNothing) {
  const Mended mended = mend({});
  EXPECT_TRUE(mended.mesh.positions.empty());
  expect_counts(mended.report, {{"empty_meshes", 1}, {"input_faces", 0}, {"parts", 0}});
}

TEST(Mesh, VerticesThatAreNotFiniteGoWithTheirFaces) {
  for (const double bad : {nan, infinity, -infinity, 1e200}) {
    PolygonMesh cube = shapes::cube();
    cube.positions[0].y() = bad;
    const Mended mended = mend(cube);
    expect_counts(mended.report, {{"nan_vertices", 1}, {"nan_faces", 3}});
    EXPECT_EQ(mended.mesh.source_faces, std::vector<int>({1, 3, 5}));
    EXPECT_EQ(mended.mesh.positions.size(), 7u);
  }
}

TEST(Mesh, HugeAndTinyMeshesAreTurnedOutward) {
  for (const double scale : {1e-120, 1e-30, 1e30, 1e149}) {
    PolygonMesh torus = shapes::turned(shapes::torus_mesh(3, 1, 8, 6));
    for (Vec3& position : torus.positions) position *= scale;
    torus.crease_angle_deg = 50;  // the turn round the tube is 60 degrees
    const Mended mended = mend(torus);
    expect_counts(mended.report, {{"turned_parts", 1}, {"angle_creases", 48}});
  }
}

TEST(Mesh, DegenerateFacesGoAndRepeatedCornersCollapse) {
  PolygonMesh mesh = shapes::plane(1, 1);
  for (const auto& face : std::vector<std::vector<int>>{
           {}, {0}, {0, 1}, {0, 0, 1}, {0, 1, 0, 2}, {0, 1, 2, 1}, {3, 3, 3, 3}})
    shapes::add_face(mesh, face);
  mesh.corner_vertices[0] = mesh.corner_vertices[3];
  const Mended mended = mend(mesh);
  expect_counts(mended.report,
                {{"degenerate_faces", 7}, {"repeated_corners", 1}, {"isolated_vertices", 1}});
  EXPECT_EQ(mended.mesh.face_sizes, std::vector<int>({3}));
}

TEST(Mesh, DuplicatesGoWhateverTheirStartAndWinding) {
  PolygonMesh mesh = shapes::cube();
  shapes::add_face(mesh, {3, 1, 0, 2});
  shapes::add_face(mesh, {6, 7, 5, 4});
  const Mended mended = mend(mesh);
  expect_counts(mended.report, {{"duplicate_faces", 2}});
  EXPECT_EQ(mended.mesh.corner_vertices, shapes::cube().corner_vertices);
}

TEST(Mesh, WhatIsFoundIsCounted) {
  // Two planes of 4 x 3 quads, one of them with a hole in its middle, and a cube.
  PolygonMesh holed = shapes::plane(4, 3);
  holed.face_sizes.erase(holed.face_sizes.begin());
  holed.corner_vertices.erase(holed.corner_vertices.begin() + 16,
                              holed.corner_vertices.begin() + 20);
  const PolygonMesh planes = shapes::joined(holed, shapes::moved(shapes::plane(4, 3), {0, 0, 1}));
  expect_counts(mend(shapes::joined(planes, shapes::moved(shapes::cube(), {9, 0, 0}))).report,
                {{"input_faces", 29}, {"kept_faces", 29}, {"parts", 3}, {"open_edges", 32}});
  // The cover has both sheets; what is counted is one.
  expect_counts(mend(shapes::moebius_mesh(12, 3)).report, {{"covered_parts", 1},
                                                           {"input_faces", 36},
                                                           {"kept_faces", 36},
                                                           {"parts", 1},
                                                           {"open_edges", 24}});
  PolygonMesh hexagon = shapes::polygon_mesh(
      {{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 1, 0}}, {{0, 1, 2, 3, 4}, {0, 4, 3, 2, 1}});
  expect_counts(mend(hexagon).report, {{"duplicate_faces", 1}, {"polygons", 1}});
}

TEST(Mesh, FacesWithTooManyCornersGo) {
  PolygonMesh mesh = shapes::tetrahedron();
  std::vector<int> corners;
  for (int i = 0; i < 70000; ++i) {
    corners.push_back(static_cast<int>(mesh.positions.size()));
    mesh.positions.emplace_back(std::cos(i * 1e-4), std::sin(i * 1e-4), 5);
  }
  shapes::add_face(mesh, corners);
  expect_counts(mend(mesh).report, {{"huge_faces", 1}, {"isolated_vertices", 70000}});
}

TEST(Mesh, VerticesWithTooManyFacesComeApart) {
  PolygonMesh fan;
  fan.positions.emplace_back(0, 0, 0);
  const int count = 66000;
  for (int i = 0; i < count; ++i) {
    fan.positions.emplace_back(std::cos(2 * pi * i / count), std::sin(2 * pi * i / count), 0);
    shapes::add_face(fan, {0, 1 + i, 1 + (i + 1) % count});
  }
  const Mended mended = mend(fan);
  expect_counts(mended.report, {{"split_edges", count}, {"split_vertices", 2 * count - 1}});
}

TEST(Mesh, UnweldedShapesClose) {
  const PolygonMesh torus = shapes::torus_mesh(3, 1, 8, 6);
  const Mended mended = mend(shapes::unwelded(torus));
  expect_counts(mended.report, {{"welded_vertices", 3 * 48}});
  EXPECT_EQ(mended.mesh.positions.size(), 48u);
  EXPECT_EQ(count_open_edges(mended.mesh), 0u);
  EXPECT_EQ(euler_characteristic(mended.mesh), 0);
}

TEST(Mesh, ZeroesOfBothSignsAreWelded) {
  PolygonMesh mesh = shapes::unwelded(shapes::plane(2, 1));
  for (Vec3& position : mesh.positions)
    if (position.x() == 0) position.x() = std::copysign(0.0, &position - &mesh.positions[4]);
  expect_counts(mend(mesh).report, {{"welded_vertices", 2}});
}

TEST(Mesh, PlacesApartByRoundingAreWelded) {
  PolygonMesh mesh = shapes::unwelded(shapes::torus_mesh(3, 1, 8, 6));
  const double step = 4 * std::numeric_limits<double>::epsilon();
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    mesh.positions[v] *= 1 + step * (static_cast<double>(v % 5) - 2);
  }
  const Mended mended = mend(mesh);
  expect_counts(mended.report, {{"welded_vertices", 3 * 48}});
  EXPECT_EQ(count_open_edges(mended.mesh), 0u);
}

TEST(Mesh, PlacesApartByMoreThanRoundingAreNotWelded) {
  PolygonMesh mesh = shapes::unwelded(shapes::plane(2, 1));
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    mesh.positions[v].z() += 1e-8 * static_cast<double>(v);
  }
  expect_counts(mend(mesh).report, {});
}

TEST(Mesh, AFarVertexDoesNotWeldTheOthers) {
  PolygonMesh mesh = shapes::unwelded(shapes::plane(2, 3));
  mesh.positions[0].x() = -1e13;
  EXPECT_EQ(mend(mesh).mesh.source_faces.size(), 6u);
}

TEST(Mesh, SheetsWithTwoSidesBecomeOne) {
  const PolygonMesh plane = shapes::plane(3, 2);
  const Mended mended = mend(shapes::joined(plane, shapes::turned(plane)));
  expect_counts(mended.report, {{"welded_vertices", 10}, {"isolated_vertices", 0}});
}

TEST(Mesh, CoincidentClosedPartsAreNotWelded) {
  const Mended mended = mend(shapes::joined(shapes::cube(), shapes::cube()));
  expect_counts(mended.report, {});
  EXPECT_EQ(mended.mesh.positions.size(), 16u);
}

TEST(Mesh, WeldingDropsFacesThatCollapse) {
  // The first two corners lie on each other: welded, nothing is left of the triangle.
  PolygonMesh mesh =
      shapes::polygon_mesh({{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
  const Mended mended = mend(mesh);
  expect_counts(mended.report, {{"welded_vertices", 1}, {"degenerate_faces", 1}});
  EXPECT_EQ(mended.mesh.source_faces, std::vector<int>({1}));
}

// A pipe whose end was closed by shrinking it: the ring of the cap and its middle are one place.
TEST(Mesh, ACapShrunkToAPointIsATip) {
  const int n = 7;
  PolygonMesh pipe;
  for (int i = 0; i < n; ++i) {
    pipe.positions.emplace_back(std::cos(i), std::sin(i), 0);
    pipe.positions.emplace_back(0, 0, 2);
  }
  pipe.positions.emplace_back(0, 0, 2);
  for (int i = 0; i < n; ++i) {
    const int next = (i + 1) % n;
    shapes::add_face(pipe, {2 * i, 2 * next, 2 * next + 1, 2 * i + 1});
    shapes::add_face(pipe, {2 * i + 1, 2 * next + 1, 2 * n});
  }
  EXPECT_EQ(mend(pipe).mesh.positions.size(), 15U);  // a cage stays as it is

  pipe.cage = false;
  const Mended mended = mend(pipe);
  EXPECT_EQ(mended.mesh.positions.size(), 8U);
  EXPECT_EQ(mended.report.at("welded_vertices"), n);
  EXPECT_EQ(mended.report.at("degenerate_faces"), n);
  EXPECT_EQ(mended.report.at("kept_faces"), n);
  EXPECT_EQ(mended.report.at("open_edges"), n);
}

TEST(Mesh, CrossingSheetsOnASharedEdgeGoStraightOn) {
  // Four quads on edge 0-1, two in each plane.
  PolygonMesh mesh = shapes::polygon_mesh({{0, 0, 0},
                                           {0, 1, 0},
                                           {1, 0, 0},
                                           {1, 1, 0},
                                           {-1, 0, 0},
                                           {-1, 1, 0},
                                           {0, 0, 1},
                                           {0, 1, 1},
                                           {0, 0, -1},
                                           {0, 1, -1}},
                                          {{0, 2, 3, 1}, {0, 1, 5, 4}, {0, 6, 7, 1}, {0, 1, 9, 8}});
  const Mended mended = mend(mesh);
  expect_counts(mended.report, {{"split_edges", 1}, {"split_vertices", 2}});
  EXPECT_TRUE(mended.mesh.seams.empty());
  const auto& corners = mended.mesh.corner_vertices;
  EXPECT_EQ(corners[0], corners[4]);
  EXPECT_EQ(corners[8], corners[12]);
  EXPECT_NE(corners[0], corners[8]);
}

TEST(Mesh, SolidsThatTouchAlongAnEdgeComeApart) {
  PolygonMesh mesh = shapes::joined(shapes::cube(), shapes::moved(shapes::cube(), {2, 2, 0}));
  for (int& vertex :
       mesh.corner_vertices) {  // corners 3 and 7 of the first are 0 and 4 of the second
    if (vertex == 8) vertex = 3;
    if (vertex == 12) vertex = 7;
  }
  const Mended mended = mend(mesh);
  expect_counts(mended.report,
                {{"split_edges", 1}, {"split_vertices", 2}, {"isolated_vertices", 2}});
  EXPECT_EQ(count_open_edges(mended.mesh), 0u);
  EXPECT_EQ(euler_characteristic(mended.mesh), 4);
  EXPECT_DOUBLE_EQ(volume(mended.mesh), 16);
}

TEST(Mesh, AThirdFaceOnAnEdgeBecomesASeam) {
  PolygonMesh mesh = shapes::plane(2, 1);
  const int first = static_cast<int>(mesh.positions.size());
  mesh.positions.emplace_back(0, -1, 1);
  mesh.positions.emplace_back(0, 1, 1);
  shapes::add_face(mesh, {2, 3, first + 1, first});
  const Mended mended = mend(mesh);
  expect_counts(mended.report, {{"split_edges", 1}, {"split_vertices", 2}});
  ASSERT_EQ(mended.mesh.seams.size(), 1u);
  const auto [a, b] = mended.mesh.seams[0];
  EXPECT_EQ(mended.mesh.source_vertices[a], 2);
  EXPECT_EQ(mended.mesh.source_vertices[b], 3);
  EXPECT_EQ(check_half_edges(mended.mesh).at({a, b}), 2);
}

TEST(Mesh, FansThatShareAVertexComeApartWithoutSeams) {
  PolygonMesh mesh = shapes::joined(shapes::cube(), shapes::moved(shapes::cube(), {2, 2, 2}));
  for (int& vertex : mesh.corner_vertices)
    if (vertex == 8) vertex = 7;
  const Mended mended = mend(mesh);
  expect_counts(mended.report, {{"split_vertices", 1}, {"isolated_vertices", 1}});
  EXPECT_EQ(mended.mesh.positions.size(), 16u);
  EXPECT_TRUE(mended.mesh.seams.empty());
}

TEST(Mesh, WindingIsMadeConsistentByTheMajority) {
  PolygonMesh mesh = shapes::plane(3, 3);
  std::reverse(mesh.corner_vertices.begin() + 8, mesh.corner_vertices.begin() + 12);
  const Mended mended = mend(mesh);
  expect_counts(mended.report, {{"flipped_faces", 1}});
  EXPECT_EQ(count_open_edges(mended.mesh), 12u);
}

TEST(Mesh, ClosedPartsFaceOutwardAlsoWhenNested) {
  PolygonMesh inner = shapes::cube();
  for (Vec3& position : inner.positions) position *= 0.5;
  const PolygonMesh outer = shapes::moved(shapes::turned(shapes::cube()), {0, 0, 0});
  const Mended mended =
      mend(shapes::moved(shapes::joined(shapes::turned(inner), outer), {9, 9, 9}));
  expect_counts(mended.report, {{"turned_parts", 2}});
  EXPECT_NEAR(volume(mended.mesh), 9, 1e-10);
}

TEST(Mesh, MoebiusStripIsCoveredByOneAnnulus) {
  const PolygonMesh strip = shapes::moebius_mesh(12, 3);
  const Mended mended = mend(strip);
  expect_counts(mended.report, {{"covered_parts", 1}});
  EXPECT_EQ(mended.mesh.face_sizes.size(), 2 * strip.face_sizes.size());
  EXPECT_EQ(mended.mesh.positions.size(), 2 * strip.positions.size());
  EXPECT_EQ(euler_characteristic(mended.mesh), 0);
  EXPECT_EQ(count_open_edges(mended.mesh), 2u * 24);
  EXPECT_TRUE(mended.mesh.seams.empty());
}

TEST(Mesh, KleinBottleIsCoveredByATorus) {
  const PolygonMesh klein = shapes::klein_mesh(10, 8);
  const Mended mended = mend(shapes::joined(klein, shapes::moved(shapes::cube(), {9, 0, 0})));
  expect_counts(mended.report, {{"covered_parts", 1}});
  EXPECT_EQ(mended.mesh.face_sizes.size(), 2u * 80 + 6);
  EXPECT_EQ(euler_characteristic(mended.mesh), 2);
  EXPECT_EQ(count_open_edges(mended.mesh), 0u);
}

TEST(Mesh, KeptSheetOfTheCoverDisagreesOnlyWhereItMust) {
  const Mended mended = mend(shapes::moebius_mesh(12, 3));
  const auto half_edges = check_half_edges(mended.mesh);
  int disagreements = 0;
  for (const auto& [edge, face] : half_edges) {
    const auto other = half_edges.find({edge[1], edge[0]});
    if (other != half_edges.end() && mended.mesh.kept[face] && !mended.mesh.kept[other->second])
      ++disagreements;
  }
  // Both sides of one seam across the band: 3 steps across and at most as many along, as the flood
  // arrives.
  EXPECT_EQ(disagreements % 2, 0);
  EXPECT_GE(disagreements, 2 * 3);
  EXPECT_LE(disagreements, 2 * 6);
}

TEST(Mesh, SharpnessFollowsSplitAndWeldedEdges) {
  PolygonMesh mesh = shapes::unwelded(shapes::plane(2, 1));
  // Quad 0 is 0 1 2 3, quad 1 is 4 5 6 7; 1-2 and 4-7 are the same edge.
  mesh.edge_vertices = {{1, 2}, {7, 4}, {0, 1}, {0, 6}, {1, 5}, {4, 5}, {2, 3}};
  mesh.edge_sharpness = {1.5, 2.5, 99, 3, nan, 0, -1};
  mesh.vertex_sharpness = {0, 1, 0, nan, 4, infinity, 0, 0};
  mesh.marked_edges = {{4, 7}, {0, 6}};
  const Mended mended = mend(mesh);
  expect_counts(mended.report,
                {{"welded_vertices", 2}, {"ignored_creases", 3}, {"ignored_marks", 1}});
  ASSERT_EQ(mended.mesh.edge_sharpness.size(), 2u);
  EXPECT_EQ(mended.mesh.edge_sharpness, std::vector<double>({10, 2.5}));
  EXPECT_EQ(mended.mesh.marked_edges.size(), 1u);
  EXPECT_EQ(mended.mesh.vertex_sharpness, std::vector<double>({0, 4, 0, 0, 10, 0}));
}

TEST(Mesh, CoverCarriesSharpnessOnBothSheets) {
  PolygonMesh strip = shapes::moebius_mesh(6, 2);
  strip.edge_vertices = {{0, 1}};
  strip.edge_sharpness = {3};
  const Mended mended = mend(strip);
  EXPECT_EQ(mended.mesh.edge_sharpness, std::vector<double>({3, 3}));
}

TEST(Mesh, CreaseAngleIsMeasuredAfterOrientation) {
  PolygonMesh cube = shapes::cube();
  std::reverse(cube.corner_vertices.begin(), cube.corner_vertices.begin() + 4);
  for (const auto& [angle, creases] : {std::pair(89.0, 12), {91.0, 0}, {180.0, 0}}) {
    cube.crease_angle_deg = angle;
    const Mended mended = mend(cube);
    expect_counts(mended.report, {{"flipped_faces", 1}, {"angle_creases", creases}});
    EXPECT_EQ(mended.mesh.edge_vertices.size(), static_cast<std::size_t>(creases));
  }
  PolygonMesh flat = shapes::plane(2, 2);
  std::reverse(flat.corner_vertices.begin(), flat.corner_vertices.begin() + 4);
  flat.crease_angle_deg = 1;
  EXPECT_TRUE(mend(flat).mesh.edge_vertices.empty());
}

TEST(Mesh, MaterialsHolesAndSettingsArePassedOn) {
  PolygonMesh mesh = shapes::plane(3, 1);
  mesh.face_materials = {5, 6, 7};
  mesh.hole_faces = {1, 1};
  mesh.boundary = BoundaryRule::edges;
  mesh.scheme = Scheme::loop;
  mesh.level = 2;
  mesh.edge_length = 0.5;
  mesh.name = "plane";
  const SoundMesh sound = mend(mesh).mesh;
  EXPECT_EQ(sound.face_materials, mesh.face_materials);
  EXPECT_EQ(sound.holes, std::vector<std::uint8_t>({0, 1, 0}));
  EXPECT_EQ(sound.boundary, BoundaryRule::edges);
  EXPECT_EQ(sound.scheme, Scheme::loop);
  EXPECT_EQ(sound.level, 2);
  EXPECT_EQ(sound.edge_length, 0.5);
  EXPECT_EQ(sound.name, "plane");
}

}  // namespace
}  // namespace illustrate
