// What is sharp by how it is shaded.
#include "mesh/creases.h"

#include "tests/cpp/check_sound.h"
#include "tests/cpp/shapes.h"

namespace illustrate {
namespace {

constexpr double blender_angle_deg = 30;

// Normals by face and corner.
template <class Normal>
PolygonMesh shaded(PolygonMesh mesh, const Normal& normal) {
  mesh.crease_angle_deg = blender_angle_deg;
  mesh.corner_normals.clear();
  const int* corner = mesh.corner_vertices.data();
  for (int f = 0; f < static_cast<int>(mesh.face_sizes.size()); ++f) {
    Points face;
    for (int k = 0; k < mesh.face_sizes[f]; ++k) face.push_back(mesh.positions[corner[k]]);
    for (const Vec3& p : face) mesh.corner_normals.push_back(normal(face, p));
    corner += face.size();
  }
  return mesh;
}

Vec3 own_normal(const Points& face, const Vec3&) {
  return (face[1] - face[0]).cross(face[2] - face[0]).normalized();
}

Vec3 radial(const Points&, const Vec3& p) { return p; }

// Each corner a vertex of its own, as importers leave what they shade flat.
PolygonMesh with_split_vertices(const PolygonMesh& mesh) {
  PolygonMesh split = mesh;
  split.positions.clear();
  split.corner_vertices.clear();
  for (const int v : mesh.corner_vertices) {
    split.corner_vertices.push_back(static_cast<int>(split.positions.size()));
    split.positions.push_back(mesh.positions[v]);
  }
  return split;
}

Vec3 of_drum(const Points& face, const Vec3& p) {
  const Vec3 own = own_normal(face, p);
  return std::abs(own.z()) > 0.5 ? own : Vec3(p.x(), p.y(), 0);
}

// A tip at (0, 0, height), n sides, open below.
PolygonMesh cone(int n, double height) {
  PolygonMesh mesh;
  mesh.positions.emplace_back(0, 0, height);
  for (int i = 0; i < n; ++i) {
    mesh.positions.emplace_back(std::cos(2 * pi * i / n), std::sin(2 * pi * i / n), 0);
    shapes::add_face(mesh, {0, 1 + i, 1 + (i + 1) % n});
  }
  return mesh;
}

TEST(Creases, FlatFacesFollowTheAngle) {
  PolygonMesh cube = shaded(shapes::cube(), own_normal);
  EXPECT_EQ(mend(cube).report.at("angle_creases"), 12);
  EXPECT_EQ(mend(cube).report.at("normal_creases"), 0);
  cube.crease_angle_deg = 91;
  EXPECT_EQ(mend(cube).report.at("angle_creases"), 0);
  const Mended wheel = mend(shaded(shapes::drum(32), own_normal));
  EXPECT_EQ(wheel.report.at("angle_creases"), 64);
  EXPECT_EQ(mend(shaded(shapes::drum(8), own_normal)).report.at("angle_creases"), 24);
}

// As files have them, far from the origin.
PolygonMesh in_single_precision(PolygonMesh mesh, double offset) {
  for (Vec3& p : mesh.positions) {
    p = (p + Vec3::Constant(offset)).cast<float>().cast<double>();
  }
  return mesh;
}

TEST(Creases, EdgesThatTurnByJustTheAngleAreAllSharp) {
  for (const double offset : {0.0, 0.7, 10.0, 300.0}) {
    PolygonMesh prism = shaded(in_single_precision(shapes::drum(12), offset), own_normal);
    EXPECT_EQ(mend(prism).report.at("angle_creases"), 36) << offset;
    prism.corner_normals.clear();
    EXPECT_EQ(mend(prism).report.at("angle_creases"), 36) << offset;
    prism.crease_angle_deg = 30.2;
    EXPECT_EQ(mend(prism).report.at("angle_creases"), 24) << offset;
  }
}

TEST(Creases, SmoothShadingIsSmooth) {
  const Mended cube = mend(shaded(shapes::cube(), radial));
  EXPECT_EQ(cube.report.at("angle_creases"), 0);
  EXPECT_EQ(cube.report.at("normal_creases"), 0);
  EXPECT_EQ(cube.report.at("tips"), 0);
}

TEST(Creases, SplitVerticesAreWeldedAndTheirNormalsKept) {
  for (const auto& mesh : {shaded(shapes::drum(12), of_drum),
                           with_split_vertices(shaded(shapes::drum(12), of_drum))}) {
    const Mended drum = mend(mesh);
    EXPECT_EQ(drum.mesh.positions.size(), 24U);
    EXPECT_EQ(drum.report.at("open_edges"), 0);
    EXPECT_EQ(drum.report.at("normal_creases"), 24);
    EXPECT_EQ(drum.report.at("angle_creases"), 0);
  }
}

TEST(Creases, FacesWoundAgainstTheOthersAreComparedUpToTheirSide) {
  const PolygonMesh plain = shaded(shapes::drum(12), of_drum);
  PolygonMesh turned = plain, turned_normals = plain;
  for (const int f : {1, 5, 12}) {
    const int first = f == 12 ? 48 : 4 * f, size = plain.face_sizes[f];
    for (PolygonMesh* mesh : {&turned, &turned_normals}) {
      std::reverse(mesh->corner_vertices.begin() + first,
                   mesh->corner_vertices.begin() + first + size);
      std::reverse(mesh->corner_normals.begin() + first,
                   mesh->corner_normals.begin() + first + size);
    }
    for (int c = first; c < first + size; ++c) turned_normals.corner_normals[c] *= -1;
  }
  for (const PolygonMesh& mesh : {turned, turned_normals}) {
    const Mended drum = mend(mesh);
    EXPECT_EQ(drum.report.at("flipped_faces"), 3);
    EXPECT_EQ(drum.report.at("normal_creases"), 24);
    for (std::size_t c = 0; c < 48; ++c)
      EXPECT_GT(drum.mesh.corner_normals[c].dot(drum.mesh.positions[drum.mesh.corner_vertices[c]]),
                0.5);
  }
}

TEST(Creases, UnknownNormalsAreTheFaces) {
  const double nan = std::nan("");
  PolygonMesh cube = shaded(shapes::cube(), [&](const Points&, const Vec3& p) {
    return p.x() > 0 ? Vec3(Vec3::Zero()) : Vec3(nan, 0, 0);
  });
  EXPECT_EQ(mend(cube).report.at("angle_creases"), 12);
  cube.corner_normals.clear();
  EXPECT_EQ(mend(cube).report.at("angle_creases"), 12);
  cube.cage = false;
  EXPECT_EQ(mend(cube).report.at("angle_creases"), 12);
}

// Top and bottom of a cube keep their own normals, its sides are shaded round.
TEST(Creases, FlatAndSmoothFacesMeetInACrease) {
  const Mended cube = mend(shaded(shapes::cube(), of_drum));
  EXPECT_EQ(cube.report.at("normal_creases"), 8);
  EXPECT_EQ(cube.report.at("angle_creases"), 0);
}

TEST(Creases, AConeKeepsItsTip) {
  const auto split_at_tip = [](const Points& face, const Vec3& p) {
    const Vec3 middle = (face[1] + face[2]) / 2;
    const Vec3 at = p.z() > 0.5 ? middle : p;
    return Vec3(at.x(), at.y(), 1);
  };
  PolygonMesh mesh = shaded(cone(12, 1), split_at_tip);
  const Mended split = mend(mesh);
  EXPECT_EQ(split.report.at("tips"), 1);
  EXPECT_EQ(split.report.at("normal_creases"), 0);
  EXPECT_EQ(split.mesh.vertex_sharpness[0], infinitely_sharp);
  const auto smooth = [](const Points&, const Vec3& p) {
    return p.z() > 0.5 ? Vec3(0, 0, 1) : Vec3(p.x(), p.y(), 0.3);
  };
  EXPECT_EQ(mend(shaded(cone(12, 3), smooth)).report.at("tips"), 1);
  EXPECT_EQ(mend(shaded(cone(12, 0.5), smooth)).report.at("tips"), 0);
  EXPECT_EQ(mend(shaded(cone(24, 1), own_normal)).report.at("tips"), 1);
}

TEST(Creases, CornersOfBoundariesGoByTheirAngle) {
  const auto flat = [](double, double) { return 0.0; };
  for (PolygonMesh mesh : {shapes::height_field(1, 1, flat), shapes::height_field(4, 3, flat),
                           shapes::split_the_same_way(shapes::height_field(1, 1, flat)),
                           shapes::split_the_same_way(shapes::height_field(5, 2, flat))}) {
    mesh.cage = false;
    EXPECT_EQ(mend(mesh).report.at("corners"), 4);
  }
  PolygonMesh disc = cone(12, 0);
  disc.cage = false;
  EXPECT_EQ(mend(disc).report.at("corners"), 0);
}

TEST(Creases, CornersOfCreasesTurnMore) {
  for (const auto& [sides, corners] : {Edge{3, 6}, Edge{4, 8}, Edge{5, 0}, Edge{12, 0}}) {
    PolygonMesh mesh = shaded(shapes::drum(sides), of_drum);
    mesh.cage = false;
    EXPECT_EQ(mend(mesh).report.at("corners"), corners) << sides;
  }
}

// Two prisms over an outline, one on the other, that share the vertices between.
PolygonMesh stack(const std::vector<Vec2>& outline) {
  const int n = static_cast<int>(outline.size());
  PolygonMesh mesh;
  for (const double z : {0.0, 1.0, 2.0}) {
    for (const Vec2& p : outline) mesh.positions.emplace_back(p.x(), p.y(), z);
  }
  for (const int low : {0, n}) {
    std::vector<int> bottom, top;
    for (int i = 0; i < n; ++i) {
      const int next = (i + 1) % n;
      shapes::add_face(mesh, {low + i, low + next, low + n + next, low + n + i});
      bottom.insert(bottom.begin(), low + i);
      top.push_back(low + n + i);
    }
    shapes::add_face(mesh, bottom);
    shapes::add_face(mesh, top);
  }
  return mesh;
}

// The edges between have four faces, and splitting opens them.
TEST(Creases, BlocksOnEachOtherKeepTheirCornersWhereTheyAreFlat) {
  const std::vector<Vec2> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const std::vector<Vec2> angle{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  for (const std::vector<Vec2>& outline : {square, angle}) {
    PolygonMesh blocks = stack(outline);
    blocks.cage = false;
    const Mended flat = mend(shaded(blocks, own_normal));
    EXPECT_EQ(flat.report.at("split_edges"), static_cast<int>(outline.size()));
    EXPECT_EQ(flat.report.at("corners"), static_cast<int>(2 * outline.size()));
  }
}

TEST(Creases, CagesKeepWhatTheyHave) {
  PolygonMesh cube = shapes::cube();
  cube.edge_vertices = {{0, 1}};
  cube.edge_sharpness = {2.5};
  const Mended plain = mend(cube);
  EXPECT_TRUE(plain.mesh.corner_normals.empty());
  EXPECT_EQ(plain.mesh.edge_sharpness, std::vector<double>{2.5});
  EXPECT_EQ(plain.mesh.vertex_sharpness, std::vector<double>(8, 0));
}

// A plane of two good triangles with a needle between them, whose height is the rounding of single
// precision, and a neighbour across an edge that turns.
PolygonMesh plane_with_needle(double off) {
  PolygonMesh mesh = shapes::polygon_mesh(
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.4, 0.4 + 1e-7, off}, {2, 0, 1}, {2, 1, 1}},
      {{0, 1, 2}, {0, 2, 4}, {0, 4, 3}, {4, 2, 3}, {1, 5, 6, 2}});
  return mesh;
}

TEST(Creases, NoneComesFromASliversNoise) {
  for (const double off : {0.0, 1e-7, -3e-7, 6e-7}) {
    const Mended mended = mend(shaded(plane_with_needle(off), own_normal));
    EXPECT_EQ(mended.report.at("angle_creases"), 1) << off;
    EXPECT_EQ(mended.report.at("normal_creases"), 0) << off;
  }
}

// The tangent point of a round wall that stands on the rim of a plate: the needle between the
// wall's foot and the rim belongs to the plate's top, not to its side, though that is across its
// longest edge.
TEST(Creases, ASliverLiesAlongTheFaceThatItsOwnNormalIsNearest) {
  const PolygonMesh mesh =
      shapes::polygon_mesh({{0, 0, 0},
                            {1, 0, 0},
                            {0.01, 1e-5, 0},
                            {1, 1, 0},
                            {0, 1, 0},
                            {0, 0, -1},
                            {1, 0, -1},
                            {0, 0, 1},
                            {0.01, 1e-5, 1}},
                           {{0, 1, 2}, {2, 1, 3, 4}, {1, 0, 5, 6}, {0, 2, 8, 7}});
  const Mended mended = mend(shaded(mesh, own_normal));
  EXPECT_EQ(mended.report.at("angle_creases"), 2);  // of the needle, to the side and to the wall
  EXPECT_EQ(mended.report.at("normal_creases"), 0);
}

// Nor is a face a sliver for where it is: a chamfer as narrow as that stays one.
TEST(Creases, AreTheSameWhereverAMeshIs) {
  const PolygonMesh mesh = shapes::polygon_mesh({{0, 0, 0},
                                                 {1, 0, 0},
                                                 {1, 1, 0},
                                                 {0, 1, 0},
                                                 {1.0003, 0, -0.0003},
                                                 {1.0003, 1, -0.0003},
                                                 {1.0003, 0, -1},
                                                 {1.0003, 1, -1}},
                                                {{0, 1, 2, 3}, {1, 4, 5, 2}, {4, 6, 7, 5}});
  const Eigen::Quaterniond by = Eigen::Quaterniond(.3, -.7, .5, .1).normalized();
  for (const Vec3& shift : {Vec3(0, 0, 0), Vec3(5, -3, 2), Vec3(-1, 8, 6)}) {
    PolygonMesh there = mesh;
    for (Vec3& p : there.positions) p = by * p + shift;
    EXPECT_EQ(mend(shaded(there, own_normal)).report.at("angle_creases"), 2) << shift.transpose();
  }
}

}  // namespace
}  // namespace illustrate
