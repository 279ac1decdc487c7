// Control meshes that keep to the artist's mesh.
#include "control/choose_scheme.h"
#include "control/keep_to_mesh.h"
#include "control/limit_masks.h"
#include "control/split_faces.h"
#include "control/split_once.h"

#include "surface/refine.h"
#include "tests/cpp/check_sound.h"
#include "tests/cpp/shapes.h"

namespace illustrate {
namespace {

Points refined(SoundMesh mesh, Scheme scheme, int level) {
  mesh.cage = true;
  mesh.scheme = scheme;
  mesh.level = level;
  Counts report;
  return refine({std::move(mesh)}, {}, report).positions;
}

SoundMesh sound(PolygonMesh mesh, bool cage = false) {
  mesh.cage = cage;
  mesh.boundary = BoundaryRule::edges;
  Counts report;
  SoundMesh result = sanitize(mesh, report);
  if (choose_scheme(result, Scheme::automatic) == Scheme::loop)
    result = split_into_triangles(std::move(result));
  return result;
}

// A Möbius strip of pentagons, which Loop's scheme cuts into triangles on both sheets.
PolygonMesh covered_pentagons() {
  const PolygonMesh strip = shapes::moebius_mesh(9, 1);
  PolygonMesh mesh;
  mesh.positions = strip.positions;
  for (std::size_t f = 0; f < strip.face_sizes.size(); ++f) {
    const int* c = strip.corner_vertices.data() + 4 * f;
    mesh.positions.push_back((strip.positions[c[0]] + strip.positions[c[1]]) / 2);
    const int middle = static_cast<int>(mesh.positions.size()) - 1;
    shapes::add_face(mesh, {c[0], middle, c[1], c[2], c[3]});
  }
  mesh.scheme = Scheme::loop;
  return mesh;
}

// Open, creased, semi-sharp, of all sizes of faces.
std::vector<PolygonMesh> varied_meshes() {
  const auto bump = [](double x, double y) { return std::cos(2 * x) * std::sin(1 + y); };
  PolygonMesh creased = shapes::cube();
  creased.edge_vertices = {{0, 1}, {1, 3}, {3, 2}, {2, 0}, {4, 5}, {5, 7}};
  creased.edge_sharpness = {10, 10, 10, 10, 0.6, 2.3};
  creased.vertex_sharpness = {0, 0, 0, 0, 0, 0, 0.4, 10};
  return {shapes::cube(),
          creased,
          shapes::height_field(4, 3, bump),
          shapes::split_the_same_way(shapes::height_field(4, 3, bump)),
          shapes::uv_sphere_mesh(1, 7, 4),
          shapes::icosahedron(),
          shapes::moebius_mesh(12, 2),
          shapes::klein_mesh(8, 6),
          covered_pentagons()};
}

double farthest_nearest(const Points& from, const Points& to) {
  double farthest = 0;
  for (const Vec3& p : from) {
    double nearest = 1e300;
    for (const Vec3& q : to) nearest = std::min(nearest, (p - q).norm());
    farthest = std::max(farthest, nearest);
  }
  return farthest;
}

// The scheme's own points on the split mesh have the parent's limit: level 2 of the one are those
// of level 1 of the other.
TEST(Control, ASplitCageHasTheLimitOfItsParent) {
  for (const PolygonMesh& mesh : varied_meshes()) {
    const SoundMesh parent = sound(mesh, true);
    const Scheme scheme = choose_scheme(parent, Scheme::automatic);
    const HalfEdges edges(parent);
    SoundMesh child = split_once(parent, edges, scheme);
    child.positions = cage_points(parent, edges, scheme);
    check_sound(child);
    EXPECT_LT(farthest_nearest(refined(child, scheme, 1), refined(parent, scheme, 2)), 1e-6);
  }
}

TEST(Control, MasksFindTheLimit) {
  for (const PolygonMesh& mesh : varied_meshes()) {
    const SoundMesh parent = sound(mesh);
    bool any_soft = false;
    for (const double s : parent.edge_sharpness) any_soft |= s < infinitely_sharp;
    if (any_soft) continue;
    const Scheme scheme = choose_scheme(parent, Scheme::automatic);
    const HalfEdges edges(parent);
    SoundMesh child = split_once(parent, edges, scheme);
    child.positions = cage_points(parent, edges, scheme);
    const HalfEdges child_edges(child);
    const auto places =
        limit_places(child, child_edges, find_sectors(child_edges, child.positions.size()),
                     child.positions, scheme);
    EXPECT_LT(farthest_nearest(places.positions, refined(child, scheme, 1)), 1e-12);
  }
}

struct Range {
  double low = 1e300, high = 0;
  void add(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
};

Range sphere_radii(const PolygonMesh& mesh) {
  const SoundMesh parent = sound(mesh);
  const Scheme scheme = choose_scheme(parent, Scheme::automatic);
  const auto kept = keep_to_mesh(parent, scheme, std::vector<double>(parent.face_sizes.size(), 1));
  Range radii;
  for (const Vec3& p : refined(kept->mesh, scheme, 2)) radii.add(p.norm());
  return radii;
}

TEST(Control, SpheresKeepTheirRadius) {
  for (const bool triangles : {false, true}) {
    double last = 1;
    for (const int n : {16, 32}) {
      PolygonMesh mesh = shapes::uv_sphere_mesh(1, n, n / 2);
      if (triangles) mesh = shapes::icosphere_mesh(1, n / 16 + 1);
      const Range radii = sphere_radii(mesh);
      const double off = std::max(1 - radii.low, radii.high - 1);
      EXPECT_LT(off, 0.01) << n;
      EXPECT_LT(off, last / 3) << n;
      last = off;
    }
  }
}

// n sides round z with k rings of quads, closed by n-gons, shaded smooth but for the rims.
PolygonMesh cylinder(int n, int k) {
  PolygonMesh mesh;
  for (int j = 0; j <= k; ++j)
    for (int i = 0; i < n; ++i)
      mesh.positions.emplace_back(std::cos(2 * pi * i / n), std::sin(2 * pi * i / n),
                                  2.0 * j / k - 1);
  std::vector<int> top, bottom;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < k; ++j)
      shapes::add_face(
          mesh, {n * j + i, n * j + (i + 1) % n, n * (j + 1) + (i + 1) % n, n * (j + 1) + i});
    top.push_back(n * k + i);
    bottom.insert(bottom.begin(), i);
  }
  for (const int v : mesh.corner_vertices)
    mesh.corner_normals.emplace_back(mesh.positions[v].x(), mesh.positions[v].y(), 0);
  shapes::add_face(mesh, top);
  shapes::add_face(mesh, bottom);
  for (int i = 0; i < 2 * n; ++i) mesh.corner_normals.emplace_back(0, 0, i < n ? 1 : -1);
  mesh.crease_angle_deg = 30;
  return mesh;
}

TEST(Control, CylindersKeepTheirRadius) {
  double last = 1;
  for (const int n : {8, 16}) {
    for (const int rings : {1, 3}) {
      const SoundMesh parent = sound(cylinder(n, rings));
      const auto kept = keep_to_mesh(parent, Scheme::catmull_clark);
      ASSERT_TRUE(kept);
      check_sound(kept->mesh);
      Range radii;
      for (const Vec3& p : refined(kept->mesh, Scheme::catmull_clark, 3)) {
        EXPECT_LT(std::abs(p.z()), 1 + 1e-12);
        if (std::abs(p.z()) < 0.999) radii.add(p.head<2>().norm());
      }
      const double off = std::max(1 - radii.low, radii.high - 1);
      EXPECT_LT(off, 0.01) << n;
      if (rings == 1) {
        EXPECT_LT(off, last / 4) << n;
        last = off;
      }
    }
  }
}

TEST(Control, FlatAndSharpMeshesAreTheirOwnCages) {
  const auto flat = [](double, double) { return 0.0; };
  EXPECT_FALSE(keep_to_mesh(sound(shapes::height_field(5, 4, flat)), Scheme::catmull_clark));
  PolygonMesh cube = shapes::cube();
  cube.crease_angle_deg = 30;
  EXPECT_FALSE(keep_to_mesh(sound(cube), Scheme::catmull_clark));
  EXPECT_FALSE(keep_to_mesh(sound(shapes::icosphere_mesh(1, 5)), Scheme::loop));
}

// A sphere beside a speck that is farther and farther away: in pixels it gets smaller. Its weight
// falls from 1 to 0 without a jump.
TEST(Control, TheFadeIsSteady) {
  const auto weight = [](double distance) {
    const PolygonMesh ball = shapes::icosphere_mesh(1, 2);
    const SoundMesh mesh = sound(shapes::joined(ball, shapes::moved(ball, {distance, 0, 0})));
    return kept_weights(mesh, Scheme::loop)[0];
  };
  double last = weight(2.5);
  EXPECT_EQ(last, 1);
  for (double distance = 2.5; distance < 60; distance += 0.1) {
    const double now = weight(distance);
    EXPECT_LE(now, last);
    EXPECT_NEAR(now, last, 0.06);
    last = now;
  }
  EXPECT_EQ(last, 0);
}

// A quarter of a coarse tube that runs on level: what is seen is the tube, however finely the
// little level piece is divided.
TEST(Control, APatchIsKeptForItsLargeFaces) {
  std::vector<Vec2> outline;
  for (int i = 0; i <= 4; ++i) outline.emplace_back(std::cos(i * pi / 8), std::sin(i * pi / 8));
  for (int i = 1; i <= 60; ++i) outline.emplace_back(-0.005 * i, 1);
  PolygonMesh mesh;
  for (const Vec2& p : outline)
    for (const double y : {0., 1., 2.}) mesh.positions.emplace_back(p.x(), y, p.y());
  for (int i = 0; i + 1 < static_cast<int>(outline.size()); ++i)
    for (const int v : {3 * i, 3 * i + 1}) shapes::add_face(mesh, {v, v + 1, v + 4, v + 3});
  EXPECT_EQ(kept_weights(sound(mesh), Scheme::catmull_clark)[0], 1);
}

TEST(Control, WeightsMayComeFromARestPose) {
  const SoundMesh parent = sound(shapes::icosphere_mesh(1, 1));
  const std::vector<double> none(parent.face_sizes.size(), 0), half(parent.face_sizes.size(), .5);
  EXPECT_FALSE(keep_to_mesh(parent, Scheme::loop, none));
  const auto whole = keep_to_mesh(parent, Scheme::loop);
  const auto faded = keep_to_mesh(parent, Scheme::loop, half);
  const Points cage = cage_points(parent, HalfEdges(parent), Scheme::loop);
  ASSERT_TRUE(whole && faded);
  for (std::size_t v = 0; v < cage.size(); ++v)
    EXPECT_LT((faded->mesh.positions[v] - (cage[v] + whole->mesh.positions[v]) / 2).norm(), 1e-14);
}

TEST(Control, SheetsOfADoubleCoverStayTogether) {
  for (const PolygonMesh& mesh :
       {shapes::moebius_mesh(12, 2), shapes::klein_mesh(8, 6), covered_pentagons()}) {
    const SoundMesh parent = sound(mesh);
    const auto kept = keep_to_mesh(parent, choose_scheme(parent, Scheme::automatic));
    ASSERT_TRUE(kept);
    check_sound(kept->mesh);
    for (std::size_t v = 0; v < kept->mesh.positions.size(); ++v)
      EXPECT_EQ(kept->mesh.positions[v], kept->mesh.positions[kept->mesh.twin_vertices[v]]);
  }
}

TEST(Control, MarksMaterialsAndHolesAreKept) {
  PolygonMesh mesh = shapes::uv_sphere_mesh(1, 8, 4);
  mesh.marked_edges = {{mesh.corner_vertices[0], mesh.corner_vertices[1]}};
  mesh.face_materials.assign(mesh.face_sizes.size(), 3);
  mesh.face_materials[5] = 4;
  mesh.hole_faces = {5};
  const SoundMesh parent = sound(mesh);
  const auto kept = keep_to_mesh(parent, Scheme::catmull_clark);
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->mesh.marked_edges.size(), 2U);
  for (std::size_t f = 0; f < kept->mesh.face_sizes.size(); ++f) {
    EXPECT_EQ(kept->mesh.holes[f], kept->mesh.source_faces[f] == 5);
    EXPECT_EQ(kept->mesh.face_materials[f], kept->mesh.source_faces[f] == 5 ? 4 : 3);
  }
}

// Three sheets along one edge: the fin's middle stays at that of the sheet.
TEST(Control, CopiesAlongASeamShareTheirPlaces) {
  const PolygonMesh mesh = shapes::polygon_mesh({{0, 0, 0},
                                                 {0, 1, 0},
                                                 {1, 0, .2},
                                                 {1, 1, .2},
                                                 {-1, 0, .3},
                                                 {-1, 1, .3},
                                                 {0, 0, 1},
                                                 {0, 1, 1}},
                                                {{0, 2, 3, 1}, {1, 5, 4, 0}, {0, 1, 7, 6}});
  const SoundMesh parent = sound(mesh);
  ASSERT_FALSE(parent.seams.empty());
  const HalfEdges edges(parent);
  const SoundMesh child = split_once(parent, edges, Scheme::catmull_clark);
  EXPECT_EQ(child.seams.size(), 2 * parent.seams.size());
  std::map<int, int> copies;
  for (const Edge& seam : child.seams)
    for (const int v : seam) ++copies[child.source_vertices[v]];
  EXPECT_EQ(copies.size(), 3U);
}

// A box in single precision, turned, whose top is cut into needles: its top is one flat area.
// Walls with a window, as a Boolean modifier cuts it: two faces round the hole, amid quads.
PolygonMesh wall_with_window() {
  PolygonMesh mesh;
  for (const double y : {-0.1, 0.1}) {
    for (const Vec2& p : {Vec2(-3, -2), Vec2(3, -2), Vec2(3, 2), Vec2(-3, 2), Vec2(-1, -1),
                          Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1)}) {
      mesh.positions.emplace_back(p.x(), y, p.y());
    }
  }
  shapes::add_face(mesh, {0, 4, 7, 3});
  shapes::add_face(mesh, {0, 1, 2, 3, 7, 6, 5, 4});
  shapes::add_face(mesh, {8, 11, 15, 12});
  shapes::add_face(mesh, {8, 12, 13, 14, 15, 11, 10, 9});
  for (int k = 0; k < 4; ++k) {
    const int next = (k + 1) % 4;
    shapes::add_face(mesh, {k, 8 + k, 8 + next, next});
    shapes::add_face(mesh, {4 + k, 4 + next, 12 + next, 12 + k});
  }
  mesh.crease_angle_deg = 30;
  return mesh;
}

TEST(Control, AWallDoesNotCloseItsWindow) {
  const SoundMesh wall = sound(wall_with_window());
  EXPECT_EQ(choose_scheme(wall, Scheme::automatic), Scheme::loop);
  EXPECT_EQ(choose_scheme(sound(wall_with_window(), true), Scheme::automatic),
            Scheme::catmull_clark)
      << "a cage is subdivided as its modifier does it";
  Counts report;
  SoundMesh fine = wall;
  fine.level = 3;
  const Surface surface = refine({fine}, {}, report);
  double area = 0;
  for (const Triangle& t : surface.triangles) {
    const Vec3& a = surface.positions[idx(t[0])];
    const Vec3 twice = (surface.positions[idx(t[1])] - a).cross(surface.positions[idx(t[2])] - a);
    area += twice.norm() / 2;
    const Vec3 middle = (a + surface.positions[idx(t[1])] + surface.positions[idx(t[2])]) / 3;
    EXPECT_FALSE(std::abs(middle.x()) < 1 - 1e-9 && std::abs(middle.z()) < 1 - 1e-9);
  }
  EXPECT_NEAR(area, 2 * (24 - 4) + 0.2 * (20 + 8), 1e-6) << "nothing lies twice";
}

TEST(Control, AFaceOfNeedlesIsFlat) {
  PolygonMesh mesh = shapes::polygon_mesh({{0, 0, 0},
                                           {1.5, 0, 0},
                                           {0, 1, 0},
                                           {1.5, 1, 0},
                                           {0, 0, .5},
                                           {1.5, 0, .5},
                                           {0, 1, .5},
                                           {1.5, 1, .5},
                                           {.3, .5, .5},
                                           {.300001, .5, .5},
                                           {.6, .5, .5},
                                           {.60001, .5, .5}},
                                          {{0, 2, 3, 1},
                                           {0, 1, 5, 4},
                                           {2, 6, 7, 3},
                                           {0, 4, 6, 2},
                                           {1, 3, 7, 5},
                                           {4, 5, 11},
                                           {4, 9, 8},
                                           {4, 10, 9},
                                           {4, 11, 10},
                                           {6, 8, 9},
                                           {6, 9, 10},
                                           {6, 10, 11},
                                           {6, 11, 7},
                                           {4, 8, 6},
                                           {5, 7, 11}});
  mesh.crease_angle_deg = 30;
  mesh.cage = false;
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).matrix();
  for (Vec3& p : mesh.positions) p = (turn * p + Vec3(3, -2, 1)).cast<float>().cast<double>();
  Counts report;
  const Surface surface = refine({sanitize(mesh, report)}, {}, report);
  EXPECT_EQ(report["angle_creases"], 12);
  for (const EdgeKind kind : surface.feature_kinds) EXPECT_EQ(kind, EdgeKind::crease);
  const Vec3 up = turn.col(2);
  for (std::size_t v = 0; v < surface.normals.size(); ++v) {
    if (std::abs(surface.normals[v].dot(up)) > 0.5) {
      EXPECT_LT(1 - std::abs(surface.normals[v].dot(up)), 1e-9);
    }
  }
}

// A mesh whose squares overflow stays as it is.
TEST(Control, ExtremeSizesStayCages) {
  for (const double scale : {1e-120, 1e120}) {
    PolygonMesh mesh = shapes::icosahedron();
    for (Vec3& p : mesh.positions) p *= scale;
    EXPECT_FALSE(keep_to_mesh(sound(mesh), Scheme::loop));
  }
}

}  // namespace
}  // namespace illustrate
