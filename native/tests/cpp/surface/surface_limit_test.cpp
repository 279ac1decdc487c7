#include <gtest/gtest.h>

#include "control/split_faces.h"
#include "core/pi.h"
#include "surface/jets/curvature.h"
#include "surface/limit/limit_patches.h"
#include "tests/cpp/surface_checks.h"

namespace illustrate {
namespace {

using namespace surface_checks;

double spread(const PrincipalCurvature& a, double k1, double k2) {
  return std::abs(a.k1 - k1) + std::abs(a.k2 - k2);
}

// Largest distances of positions and normals from OpenSubdiv's patches, and of curvatures.
struct Deviation {
  double position = 0, normal = 0, curvature = 0;
};

Deviation from_patches(const PolygonMesh& mesh, Scheme scheme, int level) {
  const Surface surface = refined(mesh, at_level(level, scheme));
  SoundMesh base = sound(mesh);
  if (scheme == Scheme::loop) base = split_into_triangles(base);
  const LimitPatches patches(base, scheme);
  Deviation worst;
  for (std::size_t v = 0; v < surface.positions.size(); ++v) {
    const auto p = patches.evaluate({surface.base_faces[v], surface.base_uv[v]});
    EXPECT_TRUE(p.has_value());
    const Vec3 normal = p->du.cross(p->dv).normalized();
    const PrincipalCurvature k = principal_curvature(*p, normal);
    worst.position = std::max(worst.position, (p->position - surface.positions[v]).norm());
    worst.normal = std::max(worst.normal, (normal - surface.normals[v]).norm());
    worst.curvature =
        std::max(worst.curvature, spread(k, surface.curvature[v].k1, surface.curvature[v].k2));
  }
  return worst;
}

TEST(Limit, AgreesWithPatchesOnRegularMeshes) {
  const PolygonMesh torus = shapes::torus_mesh(2, .7, 12, 8);
  for (const int level : {0, 1, 2}) {
    const Deviation quads = from_patches(torus, Scheme::catmull_clark, level);
    EXPECT_LT(quads.position, 1e-12);
    EXPECT_LT(quads.normal, 1e-12);
    EXPECT_LT(quads.curvature, 1e-9);
  }
}

TEST(Limit, AgreesWithPatchesOfLoop) {
  const PolygonMesh split = shapes::split_the_same_way(shapes::torus_mesh(2, .7, 12, 8));
  for (const int level : {0, 1, 2}) {
    const Deviation loop = from_patches(split, Scheme::loop, level);
    EXPECT_LT(loop.position, 1e-12);
    EXPECT_LT(loop.normal, 1e-12);
    EXPECT_LT(loop.curvature, 1e-9);
  }
}

TEST(Limit, AgreesWithPatchesAtExtraordinaryVerticesAndBoundaries) {
  for (const int level : {0, 1, 3}) {
    for (const BoundaryRule rule : {BoundaryRule::corners, BoundaryRule::edges}) {
      PolygonMesh plane = bumpy_plane(5);
      plane.boundary = rule;
      PolygonMesh reentrant = plane;  // without its middle
      reentrant.face_sizes.pop_back();
      reentrant.corner_vertices.erase(reentrant.corner_vertices.begin() + 4 * 12,
                                      reentrant.corner_vertices.begin() + 4 * 13);
      for (const auto& [mesh, scheme] : std::vector<std::pair<PolygonMesh, Scheme>>{
               {shapes::cube(), Scheme::catmull_clark},
               {plane, Scheme::catmull_clark},
               {reentrant, Scheme::catmull_clark},
               {shapes::uv_sphere_mesh(1, 7, 5), Scheme::catmull_clark},
               {shapes::icosahedron(), Scheme::loop},
               {shapes::tetrahedron(), Scheme::loop},
               {plane, Scheme::loop},
               {reentrant, Scheme::loop}}) {
        const Deviation d = from_patches(mesh, scheme, level);
        EXPECT_LT(d.position, 1e-6);
        if (rule == BoundaryRule::corners) {
          EXPECT_LT(d.normal, 2e-3);  // the patches approximate there, by 1.1e-3
        }
      }
    }
  }
}

TEST(Limit, BoundaryRuleDecidesCorners) {
  PolygonMesh square = shapes::plane(1, 1);
  const Surface kept = refined(square, at_level(2));
  square.boundary = BoundaryRule::edges;
  const Surface rounded = refined(square, at_level(2));
  const auto reach = [](const Surface& s) {
    double far = 0;
    for (const Vec3& p : s.positions) far = std::max(far, p.norm());
    return far;
  };
  EXPECT_DOUBLE_EQ(reach(kept), std::sqrt(2.));
  EXPECT_LT(reach(rounded), 1.2);
}

TEST(Limit, ConvergesToTheTorusThatTheCageSamples) {
  double last = 0;
  for (const int n : {12, 24, 48}) {
    const Surface surface = refined(shapes::torus_mesh(2, 1, 2 * n, n), at_level(0));
    double worst = 0;
    for (std::size_t v = 0; v < surface.positions.size(); ++v) {
      const Vec3& p = surface.positions[v];
      const Vec3 core = 2 * Vec3(p.x(), p.y(), 0).normalized(), out = (p - core).normalized();
      const double around = out.dot(core) / 2;  // cosine of the angle round the tube
      const double other = -around / (2 + around);
      worst =
          std::max(worst, spread({surface.curvature[v].k1, surface.curvature[v].k2}, -1, other));
      EXPECT_GT(surface.normals[v].dot(out), .99);
    }
    if (last > 0) {
      EXPECT_LT(worst, last / 3.5);
    }
    last = worst;
  }
  EXPECT_LT(last, .02);
}

TEST(Limit, AppendixAStaysThatOfTheControlMesh) {
  for (const PolygonMesh& mesh : {shapes::icosahedron(), shapes::cube()}) {
    const Surface coarse = refined(mesh, at_level(0));
    const Surface fine = refined(mesh, at_level(3));
    for (std::size_t v = 0; v < coarse.positions.size(); ++v) {
      EXPECT_LT(coarse.curvature[v].k1, -.1);
      const auto same = std::min_element(
          fine.positions.begin(), fine.positions.end(), [&](const Vec3& a, const Vec3& b) {
            return (a - coarse.positions[v]).norm() < (b - coarse.positions[v]).norm();
          });
      const auto w = static_cast<std::size_t>(same - fine.positions.begin());
      EXPECT_LT((fine.positions[w] - coarse.positions[v]).norm(), 1e-12);
      EXPECT_NEAR(fine.curvature[w].k1, coarse.curvature[v].k1, 1e-9);
      EXPECT_NEAR(fine.curvature[w].k2, coarse.curvature[v].k2, 1e-9);
    }
  }
}

TEST(Creases, SharpCubeStaysACube) {
  for (const Scheme scheme : {Scheme::catmull_clark, Scheme::loop, Scheme::polygons}) {
    for (const int level : {0, 2}) {
      const Surface cube = refined(creased(shapes::cube(), 10), at_level(level, scheme));
      const int cuts = scheme == Scheme::polygons ? 1 : 1 << level;
      EXPECT_EQ(cube.positions.size(), 6U * index((cuts + 1) * (cuts + 1)));
      EXPECT_EQ(count_kind(cube, EdgeKind::crease), 24 * cuts);
      EXPECT_NEAR(area(cube), 24, 1e-12);
      for (std::size_t v = 0; v < cube.positions.size(); ++v) {
        EXPECT_NEAR(cube.normals[v].cwiseAbs().maxCoeff(), 1, 1e-12);
        EXPECT_NEAR(cube.normals[v].dot(cube.positions[v]), 1, 1e-12);
        EXPECT_NEAR(cube.curvature[v].k1, 0, 1e-9);
      }
    }
  }
}

TEST(Creases, SidesOfACurvedCreaseHaveTheirOwnNormals) {
  PolygonMesh torus = shapes::torus_mesh(2, 1, 16, 8);
  for (int i = 0; i < 16; ++i) {  // the outer equator
    torus.edge_vertices.push_back({8 * i, 8 * ((i + 1) % 16)});
    torus.edge_sharpness.push_back(10);
  }
  for (const int level : {0, 1, 2}) {
    const Surface surface = refined(torus, at_level(level));
    EXPECT_EQ(count_kind(surface, EdgeKind::crease), 2 * (16 << level));
    EXPECT_EQ(surface.positions.size(), index((16 << level) * ((8 << level) + 1)));
    EXPECT_EQ(count_backward(surface), 0);
    for (const Edge& e : surface.feature_edges) {
      const Vec3& normal = surface.normals[index(e[0])];
      EXPECT_GT(std::abs(normal.z()), .05);  // a ridge, symmetric to z = 0
      EXPECT_NEAR(surface.positions[index(e[0])].z(), 0, 1e-12);
    }
  }
}

TEST(Creases, EndOfASingleSharpEdgeIsSmooth) {
  PolygonMesh plane = bumpy_plane(4);
  plane.edge_vertices = {{6, 11}, {11, 12}};
  plane.edge_sharpness = {10, 10};
  const Surface surface = refined(plane, at_level(2));
  EXPECT_EQ(count_kind(surface, EdgeKind::crease), 2 * 2 * 4);
  EXPECT_EQ(surface.positions.size(), 17U * 17U + 7U);
}

// Its patches, which know the end of a sharp edge elsewhere, degenerate there.
TEST(Creases, CornersAtTheEndOfASharpEdgeFaceOutward) {
  for (const PolygonMesh& convex : {shapes::cube(), shapes::icosphere_mesh(1, 1)}) {
    const bool quads = convex.face_sizes[0] == 4;
    for (std::size_t c = 0; c + 1 < convex.corner_vertices.size(); ++c) {
      const int a = convex.corner_vertices[c], b = convex.corner_vertices[c + 1];
      if (static_cast<int>(c + 1) % convex.face_sizes[0] == 0) continue;
      PolygonMesh mesh = convex;
      mesh.edge_vertices = {{a, b}};
      mesh.edge_sharpness = {10};
      mesh.vertex_sharpness.assign(mesh.positions.size(), 0);
      mesh.vertex_sharpness[idx(a)] = 10;
      const Surface surface =
          refined(mesh, at_level(2, quads ? Scheme::catmull_clark : Scheme::loop));
      const Vec3 corner = mesh.positions[idx(a)];
      for (std::size_t v = 0; v < surface.positions.size(); ++v) {
        if ((surface.positions[v] - corner).norm() > 1e-12) continue;
        EXPECT_GT(surface.normals[v].dot(corner.normalized()), 0.9) << a << ", " << b;
      }
    }
  }
}

TEST(Creases, SemiSharpLimitDoesNotDependOnTheLevel) {
  const PolygonMesh cube = creased(shapes::cube(), 2.5);
  const Surface coarse = refined(cube, at_level(0)), fine = refined(cube, at_level(4));
  EXPECT_EQ(coarse.positions.size(), 8U);
  for (std::size_t v = 0; v < coarse.positions.size(); ++v) {
    double nearest = 1;
    for (const Vec3& p : fine.positions)
      nearest = std::min(nearest, (p - coarse.positions[v]).norm());
    EXPECT_LT(nearest, 1e-6);
  }
  EXPECT_EQ(count_kind(fine, EdgeKind::crease), 0);
  EXPECT_GT(fine.diagonal, refined(shapes::cube(), at_level(4)).diagonal);
}

TEST(Limit, LevelZeroOfNgonsLiesOnTheLimit) {
  // A hexagonal prism: hexagons at both ends.
  PolygonMesh prism;
  std::vector<int> top, bottom;
  for (int i = 0; i < 6; ++i) {
    prism.positions.emplace_back(std::cos(i * pi / 3), std::sin(i * pi / 3), 1);
    top.push_back(i);
    bottom.push_back(11 - i);
  }
  for (int i = 0; i < 6; ++i)
    prism.positions.push_back(prism.positions[index(i)] - 2 * Vec3::UnitZ());
  shapes::add_face(prism, top);
  shapes::add_face(prism, bottom);
  for (int i = 0; i < 6; ++i) shapes::add_face(prism, {i, i + 6, (i + 1) % 6 + 6, (i + 1) % 6});
  const Surface coarse = refined(prism, at_level(0, Scheme::catmull_clark));
  EXPECT_EQ(coarse.positions.size(), 12U);
  EXPECT_EQ(coarse.triangles.size(), 20U);
  const Surface fine = refined(prism, at_level(2, Scheme::catmull_clark));
  EXPECT_EQ(fine.triangles.size(), 36U * 4 * 2);
  for (const Vec3& p : coarse.positions) {
    double nearest = 1;
    for (const Vec3& q : fine.positions) nearest = std::min(nearest, (p - q).norm());
    EXPECT_LT(nearest, 1e-12);
  }
  EXPECT_LT(from_patches(prism, Scheme::catmull_clark, 0).position, 1e-6);
  EXPECT_LT(from_patches(prism, Scheme::catmull_clark, 2).position, 1e-6);
}

// A cone whose ring of seven and the fan within it lie in one place: what is left of their edges is
// rounding, and so were normals.
PolygonMesh blunt_cone() {
  constexpr int n = 7;
  PolygonMesh mesh;
  for (int i = 0; i < n; ++i)
    mesh.positions.emplace_back(std::cos(2 * pi * i / n), std::sin(2 * pi * i / n), 0);
  mesh.positions.resize(2 * n + 1, Vec3(.1, .2, 1.8));
  for (int i = 0; i < n; ++i) {
    const int next = (i + 1) % n;
    shapes::add_face(mesh, {i, next, n + next});
    shapes::add_face(mesh, {i, n + next, n + i});
    shapes::add_face(mesh, {n + i, n + next, 2 * n});
  }
  return mesh;
}

TEST(Limit, NormalsTurnWithTheMeshAlsoWhereEdgesHaveNoLength) {
  const Mat3 turn = Eigen::Quaterniond(.3, -.7, .5, .1).normalized().toRotationMatrix();
  PolygonMesh turned = blunt_cone();
  for (Vec3& p : turned.positions) p = turn * p + Vec3(5, -3, 2);
  const Surface here = refined(blunt_cone(), at_level(3)), there = refined(turned, at_level(3));
  ASSERT_EQ(here.normals.size(), there.normals.size());
  for (std::size_t v = 0; v < here.normals.size(); ++v)
    EXPECT_LT((turn * here.normals[v] - there.normals[v]).norm(), 1e-6) << v;
}

}  // namespace
}  // namespace illustrate
