#include "surface/limit/limit_surface.h"

#include <gtest/gtest.h>
#include <opensubdiv/bfr/refinerSurfaceFactory.h>
#include <opensubdiv/bfr/surface.h>

#include <map>
#include <memory>
#include <random>

#include "control/split_faces.h"
#include "core/parallel.h"
#include "surface/subdivision/level_topology.h"
#include "surface/subdivision/topology.h"
#include "tests/cpp/surface_checks.h"

namespace illustrate {
namespace {

using namespace surface_checks;

struct Case {
  const char* name;
  PolygonMesh mesh;
  Scheme scheme;
};

PolygonMesh with_boundary(PolygonMesh mesh, BoundaryRule rule) {
  mesh.boundary = rule;
  return mesh;
}

// A single sharp edge that ends inside the mesh at both ends.
PolygonMesh with_dart(PolygonMesh mesh, double sharpness) {
  mesh.edge_vertices = {{mesh.corner_vertices[0], mesh.corner_vertices[1]}};
  mesh.edge_sharpness = {sharpness};
  return mesh;
}

// Pentagons and triangles among quads.
PolygonMesh prism_tower() {
  PolygonMesh mesh;
  for (int ring = 0; ring < 4; ++ring) {
    for (int i = 0; i < 5; ++i) {
      const double a = 2 * std::acos(-1.) * i / 5;
      mesh.positions.emplace_back(std::cos(a), std::sin(a), ring + .1 * i);
    }
  }
  for (int ring = 0; ring < 3; ++ring) {
    for (int i = 0; i < 5; ++i) {
      const int a = 5 * ring + i, b = 5 * ring + (i + 1) % 5;
      shapes::add_face(mesh, {a, b, b + 5, a + 5});
    }
  }
  shapes::add_face(mesh, {4, 3, 2, 1, 0});
  shapes::add_face(mesh, {15, 16, 17, 18, 19});
  return mesh;
}

// A cube of six polygons with three corners along each edge, at which two faces meet.
PolygonMesh walled() {
  PolygonMesh mesh = shapes::cube();
  std::map<std::pair<int, int>, int> between;  // of an edge, in quarters from the lesser end
  const auto corner = [&](int from, int to, int quarters) {
    const int low = std::min(from, to), high = std::max(from, to);
    const int share = from < to ? quarters : 4 - quarters;
    const auto [found, is_new] =
        between.try_emplace({8 * low + high, share}, static_cast<int>(mesh.positions.size()));
    if (is_new) {
      const Vec3 a = mesh.positions[idx(low)], b = mesh.positions[idx(high)];
      mesh.positions.push_back(a + share / 4.0 * (b - a));
    }
    return found->second;
  };
  mesh.cage = false;
  const std::vector<int> old = std::move(mesh.corner_vertices);
  mesh.face_sizes.clear();
  mesh.corner_vertices.clear();
  for (std::size_t first = 0; first < old.size(); first += 4) {
    std::vector<int> face;
    for (std::size_t k = 0; k < 4; ++k) {
      const int a = old[first + k], b = old[first + (k + 1) % 4];
      for (const int v : {a, corner(a, b, 1), corner(a, b, 2), corner(a, b, 3)}) face.push_back(v);
    }
    std::rotate(face.begin(), face.begin() + 4 * (first / 4 % 4), face.end());
    shapes::add_face(mesh, face);
  }
  return mesh;
}

std::vector<Case> cases() {
  using shapes::cube, shapes::icosahedron, shapes::torus_mesh;
  return {
      {"torus", torus_mesh(2, .7, 12, 8), Scheme::catmull_clark},
      {"torus of triangles", torus_mesh(2, .7, 12, 8), Scheme::loop},
      {"cube", cube(), Scheme::catmull_clark},
      {"creased cube", creased(cube(), 10), Scheme::catmull_clark},
      {"semi-sharp cube", creased(cube(), 1.6), Scheme::catmull_clark},
      {"cube with a dart", with_dart(cube(), 10), Scheme::catmull_clark},
      {"cube with a semi-sharp dart", with_dart(cube(), 2.3), Scheme::catmull_clark},
      {"icosahedron", icosahedron(), Scheme::loop},
      {"icosahedron with a dart", with_dart(icosahedron(), 10), Scheme::loop},
      {"semi-sharp icosahedron", creased(icosahedron(), 1.3), Scheme::loop},
      {"plane", with_boundary(bumpy_plane(5), BoundaryRule::corners), Scheme::catmull_clark},
      {"rounded plane", with_boundary(bumpy_plane(5), BoundaryRule::edges), Scheme::loop},
      {"tower of pentagons", prism_tower(), Scheme::catmull_clark},
      {"cube of polygons", walled(), Scheme::catmull_clark},
      {"Klein bottle", shapes::klein_mesh(12, 8), Scheme::catmull_clark},
  };
}

// Points inside a face, away from its edges, where the limit is smooth.
std::vector<Vec2> inner_places(bool triangle, int count) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> within(.05, .95);
  std::vector<Vec2> places;
  while (static_cast<int>(places.size()) < count) {
    const Vec2 uv(within(random), within(random));
    if (!triangle || uv.sum() < .95) places.push_back(uv);
  }
  return places;
}

// Central difference of first derivatives, the error of step h removed by a second step of 2 h.
LimitPoint differences(const LimitSurface& surface, const BasePlace& at, int axis, double h) {
  const auto slope = [&](double step) {
    BasePlace low = at, high = at;
    low.uv[axis] -= step;
    high.uv[axis] += step;
    const LimitPoint a = *surface.evaluate(low), b = *surface.evaluate(high);
    return LimitPoint{(b.position - a.position) / (2 * step),
                      (b.du - a.du) / (2 * step),
                      (b.dv - a.dv) / (2 * step),
                      {},
                      {},
                      {}};
  };
  const LimitPoint near = slope(h), far = slope(2 * h);
  return {(4 * near.position - far.position) / 3,
          (4 * near.du - far.du) / 3,
          (4 * near.dv - far.dv) / 3,
          {},
          {},
          {}};
}

TEST(LimitSurface, DerivativesAreThoseOfThePositions) {
  constexpr double step = 1e-4, tolerance = 1e-5;
  for (const Case& c : cases()) {
    const Surface surface = refined(c.mesh, at_level(0, c.scheme));
    const LimitSurface limit(surface);
    for (int face = 0; face < limit.ptex_faces(); ++face) {
      for (const Vec2& uv : inner_places(limit.is_triangle(face), 40)) {
        const BasePlace at{face, uv};
        const LimitPoint p = *limit.evaluate(at);
        const LimitPoint u = differences(limit, at, 0, step), v = differences(limit, at, 1, step);
        const double first = p.du.norm() + p.dv.norm();
        const double second = p.duu.norm() + p.duv.norm() + p.dvv.norm() + .01 * first;
        EXPECT_LT((u.position - p.du).norm() + (v.position - p.dv).norm(), tolerance * first);
        EXPECT_LT((u.du - p.duu).norm(), tolerance * second) << c.name << " " << uv.transpose();
        EXPECT_LT((u.dv - p.duv).norm() + (v.du - p.duv).norm(), tolerance * second) << c.name;
        EXPECT_LT((v.dv - p.dvv).norm(), tolerance * second) << c.name;
      }
    }
  }
}

TEST(LimitSurface, VerticesAreItsPoints) {
  for (const Case& c : cases()) {
    for (const int level : {0, 1, 3}) {
      const Surface surface = refined(c.mesh, at_level(level, c.scheme));
      const LimitSurface limit(surface);
      for (std::size_t v = 0; v < surface.positions.size(); ++v) {
        const auto p = limit.evaluate({surface.base_faces[v], surface.base_uv[v]});
        EXPECT_LT((p->position - surface.positions[v]).norm(), 1e-6 * surface.diagonal) << c.name;
      }
    }
  }
}

TEST(LimitSurface, CornersOfTrianglesLieWhereTheirPatchesSay) {
  for (const Case& c : cases()) {
    const Surface surface = refined(c.mesh, at_level(2, c.scheme));
    const LimitSurface limit(surface);
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
      const PatchTriangle& patch = surface.patches[t];
      for (int k = 0; k < 3; ++k) {
        const auto p = limit.evaluate({patch.ptex_face, patch.uv(k)});
        const Vec3& corner = surface.positions[idx(surface.triangles[t][idx(k)])];
        EXPECT_LT((p->position - corner).norm(), 1e-6 * surface.diagonal) << c.name;
      }
    }
  }
}

SoundMesh control_mesh(const Case& c) {
  Counts report;
  SoundMesh mesh = sanitize(c.mesh, report);
  return c.scheme == Scheme::loop ? split_into_triangles(std::move(mesh)) : mesh;
}

// OpenSubdiv's own surfaces of base faces, as deep as ours.
class ReferencePatches {
 public:
  ReferencePatches(const SoundMesh& mesh, Scheme scheme)
      : refiner_(make_refiner(mesh, scheme)),
        factory_(*refiner_, Options().SetApproxLevelSmooth(7).SetApproxLevelSharp(10)),
        coordinates_(mesh.positions[0].data()) {}

  std::vector<int> control_points(int face) const {
    const auto surface = surface_of(face);
    std::vector<int> found(idx(surface->GetNumControlPoints()));
    surface->GetControlPointIndices(found.data());
    return found;
  }

  LimitPoint evaluate(int face, const Vec2& uv) const {
    const auto surface = surface_of(face);
    std::vector<double> points(3 * idx(surface->GetNumPatchPoints()));
    surface->PreparePatchPoints(coordinates_, 3, points.data(), 3);
    LimitPoint p;
    surface->Evaluate(uv.data(), points.data(), 3, p.position.data(), p.du.data(), p.dv.data(),
                      p.duu.data(), p.duv.data(), p.dvv.data());
    return p;
  }

 private:
  using Options = OpenSubdiv::Bfr::SurfaceFactory::Options;
  using Surface = OpenSubdiv::Bfr::Surface<double>;

  std::unique_ptr<Surface> surface_of(int face) const {
    return std::unique_ptr<Surface>(factory_.CreateVertexSurface<double>(face));
  }

  std::unique_ptr<OpenSubdiv::Far::TopologyRefiner> refiner_;
  OpenSubdiv::Bfr::RefinerSurfaceFactory<> factory_;
  const double* coordinates_;
};

TEST(LimitSurface, PolynomialsAreThePatchesThemselves) {
  for (const Case& c : cases()) {
    const SoundMesh mesh = control_mesh(c);
    const std::vector<int> ptex = ptex_faces(mesh, c.scheme);
    const LimitPatches ours(mesh, c.scheme);
    const ReferencePatches reference(mesh, c.scheme);
    const double scale = refined(c.mesh, at_level(0, c.scheme)).diagonal;
    for (std::size_t f = 0; f + 1 < ptex.size(); ++f) {
      if (ptex[f + 1] - ptex[f] > 1) continue;  // sub-faces have other coordinates
      for (const Vec2& uv : inner_places(c.scheme == Scheme::loop, 100)) {
        const LimitPoint p = *ours.evaluate({ptex[f], uv});
        const LimitPoint q = reference.evaluate(static_cast<int>(f), uv);
        EXPECT_LT((p.position - q.position).norm(), 1e-14 * scale) << c.name;
        EXPECT_LT((p.du - q.du).norm() + (p.dv - q.dv).norm(), 1e-12 * scale) << c.name;
        EXPECT_LT((p.duu - q.duu).norm() + (p.duv - q.duv).norm() + (p.dvv - q.dvv).norm(),
                  1e-10 * scale)
            << c.name << " " << uv.transpose();
      }
    }
  }
}

TEST(LimitSurface, FacesThatSharePatchesHaveTheirOwnControlPoints) {
  for (const Case& c : cases()) {
    const SoundMesh mesh = control_mesh(c);
    const ReferencePatches shared(mesh, c.scheme);
    for (std::size_t f = 0; f < mesh.face_sizes.size(); ++f) {
      const ReferencePatches alone(mesh, c.scheme);
      const int face = static_cast<int>(f);
      EXPECT_EQ(shared.control_points(face), alone.control_points(face)) << c.name << " " << f;
    }
  }
}

// Beside an extraordinary point curvature goes from one leaf to the next in a step.
TEST(LimitSurface, RoundingDoesNotChooseTheLeaf) {
  for (const Case& c : cases()) {
    const Surface surface = refined(c.mesh, at_level(0, c.scheme));
    const LimitSurface limit(surface);
    for (int face = 0; face < limit.ptex_faces(); ++face) {
      for (const double border : {0x1p-7, 0x1p-4, .25}) {
        const Vec2 at =
            limit.is_triangle(face) ? Vec2(.4 * border, .6 * border) : Vec2(.4 * border, border);
        const LimitPoint inside = *limit.evaluate({face, at * (1 - 4e-16)});
        const LimitPoint beyond = *limit.evaluate({face, at * (1 + 4e-16)});
        const double second = inside.duu.norm() + inside.duv.norm() + inside.dvv.norm();
        const double apart = (inside.duu - beyond.duu).norm() + (inside.duv - beyond.duv).norm() +
                             (inside.dvv - beyond.dvv).norm();
        EXPECT_LT(apart, 1e-6 * (second + surface.diagonal)) << c.name << " " << border;
      }
    }
  }
}

TEST(LimitSurface, SameWhereLeavesHaveNoRoom) {
  for (const Case& c : cases()) {
    const SoundMesh mesh = control_mesh(c);
    const LimitPatches kept(mesh, c.scheme), made_again(mesh, c.scheme, 1000);
    for (const Vec2& uv : inner_places(c.scheme == Scheme::loop, 100)) {
      for (int turn = 0; turn < 2; ++turn) {
        EXPECT_EQ(kept.evaluate({0, uv})->duv, made_again.evaluate({0, uv})->duv) << c.name;
      }
    }
  }
}

TEST(LimitSurface, KnowsTheFacesOfSeveralMeshes) {
  PolygonMesh polygons = shapes::cube();
  polygons.scheme = Scheme::polygons;
  const PolygonMesh far = shapes::moved(shapes::cube(), Vec3(1e6, 0, 0));
  Counts report;
  const Surface surface =
      refined({shapes::cube(), polygons, shapes::icosahedron(), far}, at_level(1), report);
  const LimitSurface limit(surface);
  EXPECT_EQ(limit.ptex_faces(), 6 + 20 + 6);
  EXPECT_FALSE(limit.is_triangle(5));
  EXPECT_TRUE(limit.is_triangle(6));
  EXPECT_FALSE(limit.is_triangle(26));
  EXPECT_FALSE(limit.evaluate({32, Vec2::Zero()}).has_value());
  EXPECT_FALSE(limit.evaluate({none, Vec2::Zero()}).has_value());
  const LimitPoint near = *limit.evaluate({2, Vec2(.3, .4)});
  const LimitPoint moved = *limit.evaluate({28, Vec2(.3, .4)});
  EXPECT_LT((moved.position - near.position - Vec3(1e6, 0, 0)).norm(), 1e-9);
  EXPECT_EQ(moved.duu, near.duu);  // nothing is lost far from the origin
}

TEST(LimitSurface, GoesOnSmoothlyOutsideOfAFace) {
  for (const auto& [mesh, scheme, edge] : std::vector<std::tuple<PolygonMesh, Scheme, Vec2>>{
           {shapes::cube(), Scheme::catmull_clark, Vec2(0, .4)},
           {shapes::icosahedron(), Scheme::loop, Vec2(.6, .4)}}) {
    const Surface surface = refined(mesh, at_level(0, scheme));
    const LimitSurface limit(surface);
    const Vec2 out = scheme == Scheme::loop ? Vec2(1, 1) : Vec2(-1, 0);
    const LimitPoint at = *limit.evaluate({0, edge});
    double last = 1;
    for (const double step : {.1, .05, .025}) {  // against the tangent: the error is quadratic
      const LimitPoint p = *limit.evaluate({0, edge + step * out});
      const Vec3 tangent = at.position + step * (out.x() * at.du + out.y() * at.dv);
      EXPECT_LT((p.position - tangent).norm(), last / 3.9);
      last = (p.position - tangent).norm();
    }
  }
}

TEST(LimitSurface, SameFromSeveralThreads) {
  const Surface surface = refined(shapes::uv_sphere_mesh(1, 24, 16), at_level(0));
  const auto positions = [&](int threads) {
    const LimitSurface limit(surface);
    Points found(idx(limit.ptex_faces()));
    parallel_for(found.size(), threads, [&](std::size_t begin, std::size_t end) {
      for (std::size_t f = begin; f < end; ++f) {
        found[f] = limit.evaluate({static_cast<int>(f), Vec2(.3, .6)})->duv;
      }
    });
    return found;
  };
  EXPECT_EQ(positions(1), positions(4));
}

// Each face has patches of a kind of its own, more than are remembered for others.
TEST(LimitSurface, SameInAnyOrderWherePatchesAreForgotten) {
  PolygonMesh mesh = creased(bumpy_plane(20), 1);
  std::mt19937 random(1);
  for (double& sharpness : mesh.edge_sharpness) {
    sharpness = std::uniform_real_distribution(0.0, 9.0)(random);
  }
  Counts counts;
  const SoundMesh sound = sanitize(mesh, counts);
  const auto positions = [&](bool forward) {
    const LimitPatches patches(sound, Scheme::catmull_clark);
    const int faces = static_cast<int>(sound.face_sizes.size());
    Points found(idx(faces));
    for (int i = 0; i < faces; ++i) {
      const int f = forward ? i : faces - 1 - i;
      found[idx(f)] = patches.evaluate({f, Vec2(.3, .6)})->duv;
    }
    return found;
  };
  EXPECT_EQ(positions(true), positions(false));
}

}  // namespace
}  // namespace illustrate
