#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numeric>

#include "surface/planes/mean_value.h"
#include "surface/planes/untangle.h"
#include "tests/cpp/surface_checks.h"

namespace illustrate {
namespace {

using namespace surface_checks;

// A prism of height 1 over a plane polygon.
PolygonMesh prism(const std::vector<Vec2>& outline, const std::vector<std::vector<int>>& top) {
  const int n = static_cast<int>(outline.size());
  Points positions;
  for (const double z : {0., 1.})
    for (const Vec2& p : outline) positions.emplace_back(p.x(), p.y(), z);
  std::vector<std::vector<int>> faces;
  for (const std::vector<int>& face : top) {
    faces.push_back({face.rbegin(), face.rend()});
    faces.emplace_back();
    for (const int v : face) faces.back().push_back(v + n);
  }
  for (int k = 0; k < n; ++k) {
    const int l = (k + 1) % n;
    faces.push_back({k, l, n + l, n + k});
  }
  PolygonMesh mesh = shapes::polygon_mesh(std::move(positions), faces);
  mesh.crease_angle_deg = 60;
  return mesh;
}

const std::vector<Vec2> l_outline{{0, 0}, {1, 0}, {1, .3}, {.3, .3}, {.3, 1}, {0, 1}};

// Two of its triangles share the corner where the outline turns the other way.
PolygonMesh l_of_triangles() {
  return prism(l_outline, {{0, 1, 3}, {1, 2, 3}, {0, 3, 5}, {3, 4, 5}});
}

// A prism over a polygon with a hole of the same shape, whose corners are turned the other way.
PolygonMesh frame(int sides, double wobble) {
  Points positions;
  for (const double z : {0., .3}) {
    for (const double size : {1., .5}) {
      for (int k = 0; k < sides; ++k) {
        const double a = 2 * pi * k / sides, r = size * (1 + wobble * std::sin(5. * k * k));
        positions.emplace_back(r * std::cos(a), r * std::sin(a), z);
      }
    }
  }
  std::vector<std::vector<int>> faces;
  const int rings[5] = {0, 2 * sides, 3 * sides, sides, 0};  // outside, up, in, down, out
  for (int r = 0; r < 4; ++r) {
    const int from = rings[r], to = rings[r + 1];
    for (int k = 0; k < sides; ++k) {
      const int l = (k + 1) % sides;
      faces.push_back({from + k, from + l, to + l});
      faces.push_back({from + k, to + l, to + k});
    }
  }
  PolygonMesh mesh = shapes::polygon_mesh(std::move(positions), faces);
  mesh.crease_angle_deg = 60;
  return mesh;
}

// A frame with a rim round it that falls off too little for a crease: what smooth edges connect is
// not flat.
PolygonMesh rimmed_frame(int sides, double wobble) {
  PolygonMesh mesh = frame(sides, wobble);
  const int top = 2 * sides, rim = static_cast<int>(mesh.positions.size());
  for (int k = 0; k < sides; ++k) {
    const Vec3& p = mesh.positions[idx(top + k)];
    mesh.positions.emplace_back(1.3 * p.x(), 1.3 * p.y(), .2);
  }
  for (int c = 0; c < 6 * sides; ++c) {  // the wall outside, which comes first, goes up to the rim
    if (mesh.corner_vertices[idx(c)] >= top) mesh.corner_vertices[idx(c)] += rim - top;
  }
  for (int k = 0; k < sides; ++k) {
    const int l = (k + 1) % sides;
    const int corners[6] = {rim + k, rim + l, top + l, rim + k, top + l, top + k};
    mesh.corner_vertices.insert(mesh.corner_vertices.end(), corners, corners + 6);
    mesh.face_sizes.insert(mesh.face_sizes.end(), 2, 3);
  }
  return mesh;
}

TEST(FlatFaces, DoNotFold) {
  for (const int level : {1, 3, 5}) {
    EXPECT_EQ(count_backward(refined(l_of_triangles(), at_level(level, Scheme::loop))), 0);
    for (const int sides : {3, 4, 5, 6, 7}) {
      EXPECT_EQ(count_backward(refined(frame(sides, 0), at_level(level, Scheme::loop))), 0);
    }
  }
}

// A long low wall between posts, its side of one polygon and two, and a ball beside it: for what is
// curved the mesh is split once before (control/keep_to_mesh.h), by rules that draw the middle of
// an edge to the middles of its faces. That of the wall is far from the edges below the posts.
TEST(FlatFaces, OfPolygonsFarLargerThanTheirNeighboursDoNotFold) {
  const std::vector<Vec2> outline{{0, 0},   {20, 0}, {20, .5}, {20, 2.5}, {19, 2.5},
                                  {19, .5}, {1, .5}, {1, 2.5}, {0, 2.5},  {0, .5}};
  const PolygonMesh wall = prism(outline, {{0, 1, 2, 5, 6, 9}, {2, 3, 4, 5}, {9, 6, 7, 8}});
  PolygonMesh mesh =
      shapes::joined(wall, shapes::moved(shapes::uv_sphere_mesh(2, 12, 8), Vec3(10, 5, 0)));
  mesh.crease_angle_deg = 60;
  mesh.cage = false;
  EXPECT_EQ(count_backward(refined(mesh, at_level(3, Scheme::catmull_clark))), 0);
}

TEST(FlatFaces, OfIrregularOutlinesDoNotFold) {
  for (const int sides : {16, 31, 40}) {
    EXPECT_EQ(count_backward(refined(frame(sides, .08), at_level(4, Scheme::loop))), 0);
  }
}

TEST(FlatFaces, WithinWhatIsNotFlatHaveTheirNormals) {
  for (const int sides : {3, 4, 5, 7, 16}) {
    const Surface surface = refined(rimmed_frame(sides, 0), at_level(4, Scheme::loop));
    for (std::size_t v = 0; v < surface.positions.size(); ++v) {
      const Vec3 &p = surface.positions[v], &n = surface.normals[v];
      const bool is_on_top = std::abs(p.z() - .3) < 1e-12 && std::abs(n.z()) > .5;
      EXPECT_TRUE(!is_on_top || n.z() > 0) << sides << ": " << p.transpose();
    }
  }
}

TEST(FlatFaces, CoverWhatTheyDid) {
  for (const int level : {2, 4}) {
    const Surface surface = refined(l_of_triangles(), at_level(level, Scheme::loop));
    EXPECT_NEAR(area(surface), 2 * .51 + 4, 1e-12);
    for (std::size_t v = 0; v < surface.positions.size(); ++v) {
      EXPECT_NEAR(surface.normals[v].cwiseAbs().maxCoeff(), 1, 1e-12);
    }
  }
}

TEST(FlatFaces, OfQuadsDoNotFold) {
  const std::vector<Vec2> outline{{0, 0},   {.3, 0}, {1, 0}, {1, .3},
                                  {.3, .3}, {.3, 1}, {0, 1}, {0, .3}};
  const PolygonMesh mesh = prism(outline, {{0, 1, 4, 7}, {1, 2, 3, 4}, {7, 4, 5, 6}});
  const Surface surface = refined(mesh, at_level(4, Scheme::catmull_clark));
  EXPECT_EQ(count_backward(surface), 0);
  EXPECT_NEAR(area(surface), 2 * .51 + 4, 1e-12);
}

// One face with teeth: at the foot of a tooth a quad has a corner of more than 180 degrees between
// two edges of the border.
std::vector<Vec2> gear_outline(int teeth) {
  std::vector<Vec2> outline;
  for (int k = 0; k < 4 * teeth; ++k) {
    const double a = 2 * pi * k / (4 * teeth), r = k % 4 < 2 ? 1 : .8;
    outline.emplace_back(r * std::cos(a), r * std::sin(a));
  }
  return outline;
}

// Of a prism of height 1.
double prism_area(const std::vector<Vec2>& outline) {
  double twice_top = 0, wall = 0;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const Vec2 &a = outline[k], &b = outline[(k + 1) % outline.size()];
    twice_top += cross(a, b);
    wall += (b - a).norm();
  }
  return twice_top + wall;
}

TEST(FlatFaces, OfGearsDoNotFold) {
  for (const int teeth : {5, 10, 18}) {
    std::vector<int> top(idx(4 * teeth));
    std::iota(top.begin(), top.end(), 0);
    PolygonMesh gear = prism(gear_outline(teeth), {top});
    gear.crease_angle_deg = 10;
    const double covered = prism_area(gear_outline(teeth));
    for (const int level : {1, 2, 3, 4}) {
      const Surface surface = refined(gear, at_level(level, Scheme::catmull_clark));
      EXPECT_EQ(count_backward(surface), 0) << teeth << " at level " << level;
      EXPECT_NEAR(area(surface), covered, 1e-9) << teeth << " at level " << level;
    }
  }
}

// Each step of the unfolding looks at signs and ties, which rounding must not choose.
TEST(FlatFaces, UnfoldAlikeWhereverTheyAre) {
  const Eigen::Affine3d motion =
      Eigen::Translation3d(5, -3, 2) * Eigen::AngleAxisd(.7, Vec3(1, 2, 3).normalized());
  for (const PolygonMesh& mesh : {l_of_triangles(), frame(16, .08), frame(31, .08)}) {
    PolygonMesh moved = mesh;
    for (Vec3& p : moved.positions) p = motion * p;
    const Surface here = refined(mesh, at_level(4, Scheme::loop));
    const Surface there = refined(moved, at_level(4, Scheme::loop));
    ASSERT_EQ(here.positions.size(), there.positions.size());
    double farthest = 0;
    for (std::size_t v = 0; v < here.positions.size(); ++v) {
      farthest = std::max(farthest, (motion * here.positions[v] - there.positions[v]).norm());
    }
    EXPECT_LT(farthest, 1e-12);
  }
}

TEST(MeanValue, IsExactForLinearFunctions) {
  const auto linear = [](const Vec2& p) { return Vec2(1 + 2 * p.x() - p.y(), 3 * p.y()); };
  std::vector<BorderPiece> border;
  for (std::size_t k = 0; k < l_outline.size(); ++k) {
    const Vec2 &from = l_outline[k], &to = l_outline[(k + 1) % l_outline.size()];
    border.push_back({from, to, linear(from), linear(to)});
  }
  for (const Vec2& p : {Vec2(.1, .1), Vec2(.7, .2), Vec2(.29, .31), Vec2(.5, 0.), Vec2(0., 0.)}) {
    EXPECT_LT((mean_value(border, p) - linear(p)).norm(), 1e-12);
  }
}

// Where a side is seen along its line, turned so that rounding puts the point a little beside it.
TEST(MeanValue, IsExactInLineWithASide) {
  const Eigen::Rotation2Dd turn(.7);
  const auto linear = [](const Vec2& p) { return Vec2(1 + 2 * p.x() - p.y(), 3 * p.y()); };
  std::vector<BorderPiece> border;
  for (std::size_t k = 0; k < l_outline.size(); ++k) {
    const Vec2 from = turn * l_outline[k], to = turn * l_outline[(k + 1) % l_outline.size()];
    border.push_back({from, to, linear(from), linear(to)});
  }
  for (int i = 1; i < 30; ++i) {
    const Vec2 p = turn * Vec2(.01 * i, .3), q = turn * Vec2(.3, .01 * i);
    EXPECT_LT((mean_value(border, p) - linear(p)).norm(), 1e-12);
    EXPECT_LT((mean_value(border, q) - linear(q)).norm(), 1e-12);
  }
}

TEST(Untangle, PutsTheMiddleOfAFanBack) {
  std::vector<Vec2> points{{3, 1}};
  std::vector<Triangle> triangles;
  for (int k = 0; k < 6; ++k) {
    points.emplace_back(std::cos(pi * k / 3), std::sin(pi * k / 3));
    triangles.push_back({0, 1 + k, 1 + (k + 1) % 6});
  }
  EXPECT_GT(count_clockwise(triangles, points), 0U);
  EXPECT_EQ(untangle(triangles, {0, 1, 1, 1, 1, 1, 1}, points), 0U);
  EXPECT_LT(points[0].norm(), 1e-12);
}

}  // namespace
}  // namespace illustrate
