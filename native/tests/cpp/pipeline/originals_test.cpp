#include "pipeline/originals.h"

#include <gtest/gtest.h>

#include "mesh/instance.h"
#include "pipeline/prepare.h"
#include "tests/cpp/check_surface.h"
#include "tests/cpp/shapes.h"

// What a frame takes over from the last one.
namespace illustrate {
namespace {

using Scene = std::vector<PolygonMesh>;

// Without symmetry, with singularities, and of coarse and fine faces.
PolygonMesh dented_ball() {
  PolygonMesh mesh = shapes::uv_sphere_mesh(1, 16, 12);
  for (Vec3& p : mesh.positions) {
    p *= 1 + 0.15 * std::sin(3 * p.x() + 1) * std::cos(4 * p.y()) + 0.1 * std::sin(5 * p.z());
  }
  mesh.name = "ball";
  mesh.edge_length = 0.1;
  return mesh;
}

PolygonMesh ring() {
  PolygonMesh mesh = shapes::moved(shapes::torus_mesh(1, 0.3, 16, 8), Vec3(4, 0, 0));
  mesh.name = "ring";
  mesh.edge_length = 0.1;
  return mesh;
}

Similarity turn() {
  return {Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix(), 1, Vec3(0, 1, 5)};
}

PolygonMesh moved(PolygonMesh mesh, const Similarity& motion) {
  for (Vec3& p : mesh.positions) p = motion.point(p);
  return mesh;
}

PolygonMesh stretched(PolygonMesh mesh) {
  for (Vec3& p : mesh.positions) p.z() *= 1.2;
  return mesh;
}

std::shared_ptr<const Prepared> frame(const Scene& scene,
                                      const std::shared_ptr<const Prepared>& last = nullptr,
                                      int budget = 100000, bool has_field = true) {
  std::vector<MeshPointer> meshes;
  for (const PolygonMesh& mesh : scene) {
    meshes.push_back(std::make_shared<const PolygonMesh>(mesh));
  }
  PrepareOptions options;
  options.surface.triangle_budget = budget;
  options.field = has_field;
  auto made = prepare(meshes, options, last.get());
  if (has_field) made->families();
  return made;
}

// An object of the one and of the other, the field turned by a motion; `tolerance` 0: to the bit.
void expect_same(const Prepared& a, int object, const Prepared& b, int other,
                 const Similarity& motion, double tolerance) {
  const Surface &s = a.surface(), &r = b.surface();
  const int first = first_vertices(s)[idx(object)], end = first_vertices(s)[idx(object) + 1];
  const int shift = first_vertices(r)[idx(other)] - first;
  ASSERT_EQ(end + shift, first_vertices(r)[idx(other) + 1]);
  for (int i = first; i < end; ++i) {
    const std::size_t v = idx(i), w = idx(i + shift);
    EXPECT_LE((motion.point(s.positions[v]) - r.positions[w]).norm(), tolerance);
    EXPECT_LE((motion.direction(s.normals[v]) - r.normals[w]).norm(), tolerance);
    const Vec3 turned = motion.direction(a.field().directions[v]);
    EXPECT_LE((turned - b.field().directions[w]).norm(), tolerance);
    EXPECT_EQ(a.families()[v], b.families()[w]);
    EXPECT_LE(std::abs(a.hatch_curvature()[v].k1 - b.hatch_curvature()[w].k1), tolerance);
  }
}

TEST(LastFrame, LeavesWhatMovesAsARigidBody) {
  const auto first = frame({dented_ball(), ring()});
  const auto second = frame({moved(dented_ball(), turn()), ring()}, first);
  expect_same(*first, 0, *second, 0, turn(), 1e-12);
  expect_same(*first, 1, *second, 1, {}, 0);
  check_surface(second->surface());
  const auto third = frame({moved(dented_ball(), turn() * turn()), ring()}, second);
  expect_same(*first, 0, *third, 0, turn() * turn(), 1e-12);
  const auto alone = frame({moved(dented_ball(), turn()), ring()});
  EXPECT_EQ(second->report(), alone->report());
}

TEST(LastFrame, ComesBackToTheBitWhereNothingHasMoved) {
  const auto first = frame({moved(dented_ball(), turn()), ring()});
  const auto second = frame({moved(dented_ball(), turn()), stretched(ring())}, first);
  expect_same(*first, 0, *second, 0, {}, 0);
  check_surface(second->surface());
}

TEST(LastFrame, IsFollowedByWhatBends) {
  const auto first = frame({dented_ball(), ring()});
  const auto second = frame({dented_ball(), stretched(ring())}, first);
  const auto whole = frame({dented_ball(), stretched(ring())});
  const Surface &s = second->surface(), &r = whole->surface();
  EXPECT_EQ(s.positions, r.positions);
  EXPECT_EQ(s.normals, r.normals);
  EXPECT_EQ(s.triangles, r.triangles);
  EXPECT_EQ(s.neighbours, r.neighbours);
  EXPECT_EQ(s.curvature, r.curvature);
  EXPECT_EQ(second->hatch_curvature(), whole->hatch_curvature());
  EXPECT_EQ(second->report(), whole->report());
}

// Lines alone are drawn while something is dragged.
TEST(LastFrame, IsTheLastThatHadAField) {
  const Scene dragged{moved(dented_ball(), turn()), stretched(ring())};
  const Scene end{moved(dented_ball(), turn() * turn()), stretched(ring())};
  const auto first = frame({dented_ball(), ring()});
  auto last = first;
  for (const Scene& scene : {dragged, dragged, end}) last = frame(scene, last, 100000, false);
  last = frame(end, last);
  expect_same(*first, 0, *last, 0, turn() * turn(), 1e-12);
  expect_same(*frame(end, first), 1, *last, 1, {}, 0);
  const auto back = frame({dented_ball(), ring()}, frame(dragged, first, 100000, false));
  expect_same(*first, 0, *back, 0, {}, 1e-12);
}

TEST(LastFrame, KnowsObjectsByTheirNames) {
  const auto first = frame({dented_ball(), ring()});
  PolygonMesh added = shapes::moved(shapes::cube(), Vec3(0, 5, 0));
  added.name = "cube";
  added.edge_length = 0.1;
  const auto more = frame({added, ring(), dented_ball()}, first);
  expect_same(*first, 0, *more, 2, {}, 0);
  expect_same(*first, 1, *more, 1, {}, 0);
  PolygonMesh renamed = dented_ball();
  renamed.name = "moon";
  expect_same(*first, 0, *frame({renamed, ring()}, first), 0, {}, 0);
  const auto fewer = frame({dented_ball()}, more);
  expect_same(*first, 0, *fewer, 0, {}, 0);
  PolygonMesh other = ring();
  other.name = "ball";
  check_surface(frame({other}, fewer)->surface());
}

TEST(LastFrame, IsNotKeptWhereLevelsChange) {
  const auto first = frame({dented_ball(), ring()});
  PolygonMesh near = ring();
  near.edge_length = 0.02;
  const auto second = frame({dented_ball(), near}, first);
  EXPECT_GT(second->report().at("level_1"), first->report().at("level_1"));
  expect_same(*first, 0, *second, 0, {}, 0);
  // What the ring wants more of is taken from the ball.
  const int budget = static_cast<int>(first->surface().triangles.size());
  PolygonMesh finer = dented_ball();
  finer.edge_length = 0.02;
  const auto tight = frame({dented_ball(), ring()}, nullptr, budget);
  const auto after = frame({finer, near}, tight, budget);
  const auto alone = frame({finer, near}, nullptr, budget);
  EXPECT_EQ(after->report(), alone->report());
  EXPECT_EQ(after->surface().positions, alone->surface().positions);
}

TEST(LastFrame, KeepsOriginalsOfCopiesThatMove) {
  const auto original = std::make_shared<const PolygonMesh>(dented_ball());
  const auto scene = [&](double x) {
    Mat4 place = Mat4::Identity();
    place(0, 3) = x;
    return Scene{instance(original, Mat4::Identity(), "a"), instance(original, place, "b"), ring()};
  };
  const auto first = frame(scene(3)), second = frame(scene(4), first);
  expect_same(*first, 0, *second, 0, {}, 0);
  expect_same(*first, 1, *second, 1, {Mat3::Identity(), 1, Vec3(1, 0, 0)}, 1e-14);
  EXPECT_EQ(second->report(), frame(scene(4))->report());
}

// Levels by the size of the scene change with it.
TEST(LastFrame, IsNotKeptWhereLevelsGoByTheScene) {
  Scene scene{dented_ball(), ring()};
  for (PolygonMesh& mesh : scene) mesh.edge_length.reset();
  const auto first = frame(scene);
  scene[1] = shapes::moved(scene[1], Vec3(300, 0, 0));
  const auto second = frame(scene, first);
  EXPECT_EQ(second->report(), frame(scene)->report());
}

}  // namespace
}  // namespace illustrate
