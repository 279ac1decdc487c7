#include "surface/planes/plane_faces.h"

#include <gtest/gtest.h>

#include "field/cross_field.h"
#include "field/problem/coplanar.h"
#include "surface/jets/curvature.h"
#include "tests/cpp/surface_checks.h"

namespace illustrate {
namespace {

using namespace surface_checks;

struct Found {
  SoundMesh mesh;
  std::vector<PlaneFace> planes;

  int count(int plane) const {
    return static_cast<int>(std::count(mesh.face_planes.begin(), mesh.face_planes.end(), plane));
  }
};

Found found_in(const PolygonMesh& mesh) {
  Counts counts;
  Found found{sanitize(mesh, counts), {}};
  found.planes = find_plane_faces(found.mesh, 0, 0, 1);
  return found;
}

// A prism along z over a convex outline; its ends are fans from the first corner, its sides two
// triangles each.
PolygonMesh prism_of_triangles(const std::vector<Vec2>& outline, double length) {
  const int n = static_cast<int>(outline.size());
  Points positions;
  for (const double z : {0., length}) {
    for (const Vec2& p : outline) positions.emplace_back(p.x(), p.y(), z);
  }
  std::vector<std::vector<int>> faces;
  for (int k = 1; k + 1 < n; ++k) {
    faces.push_back({0, k + 1, k});
    faces.push_back({n, n + k, n + k + 1});
  }
  for (int k = 0; k < n; ++k) {
    const int l = (k + 1) % n;
    faces.push_back({k, l, n + l});
    faces.push_back({k, n + l, n + k});
  }
  PolygonMesh mesh = shapes::polygon_mesh(std::move(positions), faces);
  mesh.crease_angle_deg = 30;
  mesh.cage = false;
  return mesh;
}

// A box whose edges along z are rounded, each by `strips` strips.
std::vector<Vec2> rounded_outline(double width, double height, double radius, int strips) {
  std::vector<Vec2> outline;
  const Vec2 half(width / 2 - radius, height / 2 - radius);
  for (int quarter = 0; quarter < 4; ++quarter) {
    const Vec2 corner(quarter == 1 || quarter == 2 ? -half.x() : half.x(),
                      quarter < 2 ? half.y() : -half.y());
    for (int k = 0; k <= strips; ++k) {
      const double a = pi / 2 * (quarter + double(k) / strips);
      outline.push_back(corner + radius * Vec2(std::cos(a), std::sin(a)));
    }
  }
  return outline;
}

std::vector<Vec2> circle(int sides) {
  std::vector<Vec2> outline;
  for (int k = 0; k < sides; ++k) {
    const double a = 2 * pi * k / sides;
    outline.emplace_back(std::cos(a), std::sin(a));
  }
  return outline;
}

// Degrees from a direction to the nearest one of a cross.
double off_cross(const Vec3& direction, const Vec3& normal, const Vec3& cross) {
  const double along = std::abs(cross.dot(direction));
  const double aside = std::abs(normal.cross(cross).dot(direction));
  return std::atan2(std::min(along, aside), std::max(along, aside)) * 180 / pi;
}

TEST(PlaneFaces, SidesOfACubeAreSix) {
  const Found found = found_in(prism_of_triangles({{0, 0}, {2, 0}, {2, 1}, {0, 1}}, 3));
  ASSERT_EQ(found.planes.size(), 6u);
  for (int p = 0; p < 6; ++p) {
    EXPECT_EQ(found.count(p), 2);
    const PlaneFace& plane = found.planes[idx(p)];
    EXPECT_TRUE(plane.ends_sharply);
    EXPECT_NEAR(plane.agreement, 1, 1e-12);
    EXPECT_NEAR(plane.direction.cwiseAbs().maxCoeff(), 1, 1e-12);
  }
}

TEST(PlaneFaces, SliversBelongToTheirPlane) {
  // A corner split in two, a millionth of the side apart, and a point on a side.
  const Found found =
      found_in(prism_of_triangles({{0, 0}, {1, 0}, {2, 0}, {2, 1 - 2e-6}, {2, 1}, {0, 1}}, 3));
  EXPECT_EQ(found.planes.size(), 6u);
  EXPECT_EQ(std::count(found.mesh.face_planes.begin(), found.mesh.face_planes.end(), none), 0);
}

TEST(PlaneFaces, OfACylinderTheEndsAlone) {
  for (const int sides : {24, 64}) {
    const Found found = found_in(prism_of_triangles(circle(sides), 6));
    ASSERT_EQ(found.planes.size(), 2u);
    EXPECT_EQ(found.count(0), sides - 2);
    EXPECT_LT(found.planes[0].agreement, .19);
  }
}

TEST(PlaneFaces, OfARoundedBoxTheFlatSidesAndNoStrip) {
  const Found found = found_in(prism_of_triangles(rounded_outline(2, 1.2, .2, 6), 5));
  EXPECT_EQ(found.planes.size(), 6u);
  EXPECT_EQ(std::count_if(found.planes.begin(), found.planes.end(),
                          [](const PlaneFace& plane) { return plane.ends_sharply; }),
            2);
}

// A drum whose upper rim is rounded off by five strips.
PolygonMesh drum_with_round_rim(double radius) {
  constexpr int sides = 48, strips = 5;
  Points positions;
  const auto add_ring = [&](double r, double z) {
    for (int k = 0; k < sides; ++k) {
      const double a = 2 * pi * k / sides;
      positions.emplace_back(r * std::cos(a), r * std::sin(a), z);
    }
  };
  add_ring(1, -1);
  for (int s = 0; s <= strips; ++s) {
    const double a = s * pi / 2 / strips;
    add_ring(1 - radius + radius * std::cos(a), radius * std::sin(a) - radius);
  }
  std::vector<std::vector<int>> faces(2);
  for (int k = 0; k < sides; ++k) {
    faces[0].push_back(sides - 1 - k);
    faces[1].push_back((strips + 1) * sides + k);
    for (int ring = 0; ring <= strips; ++ring) {
      const int a = ring * sides + k, b = ring * sides + (k + 1) % sides;
      faces.push_back({a, b, b + sides, a + sides});
    }
  }
  PolygonMesh mesh = shapes::polygon_mesh(std::move(positions), faces);
  mesh.crease_angle_deg = 30;
  mesh.cage = false;
  return mesh;
}

// The crease in the middle of the rounding ends it, where there is one.
TEST(PlaneFaces, EndSharplyAtAFineRounding) {
  PolygonMesh drum = drum_with_round_rim(.01);
  const auto top = [&] {
    const Found found = found_in(drum);
    return found.planes[idx(found.mesh.face_planes[1])];
  };
  EXPECT_FALSE(top().ends_sharply);
  drum.edge_length = .05;
  EXPECT_TRUE(top().ends_sharply);
}

TEST(PlaneFaces, SmoothFormsHaveNone) {
  for (PolygonMesh mesh : {shapes::torus_mesh(1, .4, 24, 12), shapes::icosphere_mesh(1, 2),
                           shapes::uv_sphere_mesh(1, 16, 8), shapes::moebius_mesh(12, 3)}) {
    EXPECT_TRUE(found_in(mesh).planes.empty());
  }
}

TEST(PlaneFaces, ARimIsMeasuredWhereItIsStraight) {
  // A half disc, its chord turned by 20 degrees.
  std::vector<Vec2> outline;
  for (int k = 0; k <= 20; ++k) {
    const double a = pi * (k / 20. + 20 / 180.);
    outline.emplace_back(std::cos(a), std::sin(a));
  }
  const Found found = found_in(prism_of_triangles(outline, 1));
  const Vec3 chord(std::cos(pi / 9), std::sin(pi / 9), 0);
  for (const PlaneFace& plane : found.planes) {
    if (std::abs(plane.normal.z()) < .9) continue;
    EXPECT_LT(off_cross(chord, plane.normal, plane.direction), .5);
    EXPECT_NEAR(plane.agreement, 2 / (2 + pi), .01);
  }
}

PlaneFace rectangle(const Vec3& centre, const Vec2& half, int object) {
  PlaneFace plane;
  plane.centre = centre;
  plane.half = half;
  plane.object = object;
  return plane;
}

TEST(PlaneFaces, NeighboursInOnePlaneAreAGroup) {
  std::vector<PlaneFace> planes{
      rectangle({0, 0, 0}, {1, 1}, 0),    rectangle({2.02, 0, 0}, {1, .5}, 1),
      rectangle({4, 0, 0}, {.99, .5}, 2), rectangle({0, 4, 0}, {1, 1}, 3),
      rectangle({0, 0, .1}, {1, 1}, 4),   rectangle({0, 0, 0}, {1, 1}, 5)};
  planes[5].normal = -planes[5].normal;
  EXPECT_EQ(coplanar_groups(planes, true), (std::vector<int>{0, 0, 0, 3, 4, 5}));
  EXPECT_EQ(coplanar_groups(planes, false), (std::vector<int>{0, 1, 2, 3, 4, 5}));
  planes[2].object = planes[1].object;
  EXPECT_EQ(coplanar_groups(planes, false), (std::vector<int>{0, 1, 1, 3, 4, 5}));
}

struct Solved {
  Surface surface;
  CrossField field;
};

Solved solve(const std::vector<PolygonMesh>& meshes) {
  Counts counts;
  std::vector<SoundMesh> sound;
  for (const PolygonMesh& mesh : meshes) sound.push_back(sanitize(mesh, counts));
  SurfaceOptions options;
  options.triangle_budget = 20000;
  Solved solved{refine(std::move(sound), options, counts), {}};
  solved.field = solve_cross_field(solved.surface, jet_curvature(solved.surface, {}), {});
  return solved;
}

TEST(PlaneFaces, FieldsOfRoundedBoxesRunAlongTheirAxis) {
  const Solved solved = solve({prism_of_triangles(rounded_outline(2, 1.2, .2, 6), 5)});
  for (std::size_t v = 0; v < solved.surface.positions.size(); ++v) {
    const Vec3& normal = solved.surface.normals[v];
    const Vec3 axis = std::abs(normal.z()) > .9 ? Vec3::UnitX() : Vec3::UnitZ();
    ASSERT_LT(off_cross(axis, normal, solved.field.directions[v]), 1);
  }
}

// A square plate with a round hole, whose edge is bevelled in two narrow strips.
PolygonMesh bevelled_hole() {
  constexpr int n = 32;
  PolygonMesh mesh;
  const auto add_ring = [&](double radius, double z, double squareness) {
    for (int i = 0; i < n; ++i) {
      const Vec2 on_circle(std::cos(2 * pi * i / n), std::sin(2 * pi * i / n));
      const double to_square = 1 / on_circle.cwiseAbs().maxCoeff();
      const Vec2 p = radius * std::pow(to_square, squareness) * on_circle;
      mesh.positions.emplace_back(p.x(), p.y(), z);
    }
  };
  add_ring(1, 0, 1);
  add_ring(.5, 0, 0);
  add_ring(.493, -.003, 0);
  add_ring(.49, -.01, 0);
  add_ring(.49, -1, 0);
  for (int ring = 0; ring < 4; ++ring) {
    for (int i = 0; i < n; ++i) {
      const int a = ring * n + i, b = ring * n + (i + 1) % n;
      shapes::add_face(mesh, {a, b, b + n, a + n});
    }
  }
  mesh.cage = false;
  return mesh;
}

TEST(PlaneFaces, FieldsStayStraightUpToABevelledHole) {
  const Solved solved = solve({bevelled_hole()});
  const Surface& surface = solved.surface;
  int count = 0;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    if (surface.triangle_planes[t] == none) continue;
    ++count;
    for (const int v : surface.triangles[t]) {
      const Vec3& normal = surface.normals[idx(v)];
      ASSERT_LT(off_cross(Vec3::UnitX(), normal, solved.field.directions[idx(v)]), 2);
    }
  }
  EXPECT_GT(count, 100);
}

TEST(PlaneFaces, CoplanarNeighboursFollowTheLongestRimThatAgrees) {
  const PolygonMesh skew = prism_of_triangles({{1, 0}, {2.6, -.7}, {2.6, .3}, {1, 1}}, .4);
  const Vec3 slope = Vec3(1.6, -.7, 0).normalized();
  for (const double width : {1., .5}) {  // 4 and 3 of the square's rim, 3.49 of the other's
    const PolygonMesh square =
        prism_of_triangles({{1 - width, 0}, {1, 0}, {1, 1}, {1 - width, 1}}, .4);
    const Solved solved = solve({square, skew});
    const Vec3 wanted = width == 1 ? Vec3::UnitX() : slope;
    for (std::size_t v = 0; v < solved.surface.positions.size(); ++v) {
      const Vec3& normal = solved.surface.normals[v];
      if (std::abs(normal.z()) < .9) continue;
      ASSERT_LT(off_cross(wanted, normal, solved.field.directions[v]), 1e-6);
    }
  }
}

TEST(PlaneFaces, ADiscTakesAnAxisOfItsObject) {
  PolygonMesh mesh = shapes::joined(prism_of_triangles({{0, 0}, {2, 1}, {1.5, 2}, {-.5, 1}}, 1),
                                    shapes::moved(prism_of_triangles(circle(64), 1), {5, 0, .5}));
  const Vec3 edge = Vec3(2, 1, 0).normalized();
  const Solved solved = solve({mesh});
  for (std::size_t v = 0; v < solved.surface.positions.size(); ++v) {
    const Vec3& normal = solved.surface.normals[v];
    if (std::abs(normal.z()) < .9) continue;
    ASSERT_LT(off_cross(edge, normal, solved.field.directions[v]), 1e-6);
  }
}

}  // namespace
}  // namespace illustrate
