#include "contour/exact/exact_silhouettes.h"

#include <gtest/gtest.h>

#include "contour/exact/cusp_ends.h"
#include "contour/exact/exact_segment.h"
#include "tests/cpp/cameras.h"
#include "tests/cpp/contour/dense_contour.h"
#include "tests/cpp/surface_checks.h"

namespace illustrate {
namespace {

using namespace surface_checks;

struct Drawn {
  LinearSilhouettes linear;
  Silhouettes exact;
  Counts counts;
};

Drawn draw(const Surface& surface, const Camera& camera,
           Exactness exactness = Exactness::where_needed) {
  const LimitSurface limit(surface);
  const ContourFunctions functions(surface, camera);
  Drawn drawn;
  drawn.linear = linear_silhouettes(surface, functions);
  drawn.exact =
      exact_silhouettes(surface, limit, functions, camera, drawn.linear, exactness, drawn.counts);
  return drawn;
}

std::vector<dense::Segment> image_segments(const Silhouettes& found, const Camera& camera) {
  std::vector<dense::Segment> segments;
  for (std::size_t c = 0; c < found.chains.size(); ++c) {
    const Span<const ChainPoint> chain = found.chains[c];
    for (std::size_t i = 0; i + (found.closed[c] ? 0 : 1) < chain.size(); ++i) {
      segments.push_back({camera.project(chain[i].position).xy,
                          camera.project(chain[(i + 1) % chain.size()].position).xy});
    }
  }
  return segments;
}

// Farthest that one set of segments lies from another, both ways, at their ends and middles.
double apart(const std::vector<dense::Segment>& a, const std::vector<dense::Segment>& b) {
  double worst = 0;
  for (const auto* pair : {&a, &b}) {
    const dense::Nearest nearest(pair == &a ? b : a);
    for (const dense::Segment& s : *pair) {
      worst = std::max({worst, nearest(s.a), nearest((s.a + s.b) / 2)});
    }
  }
  return worst;
}

std::vector<Vec2> cusps_of(const Silhouettes& found, const Camera& camera) {
  std::vector<Vec2> cusps;
  for (const ChainPoint& p : found.chains.values) {
    if (p.cusp_jump != 0) cusps.push_back(camera.project(p.position).xy);
  }
  return cusps;
}

// Crossings of a closed chain with itself.
int self_crossings(Span<const ChainPoint> chain, const Camera& camera) {
  std::vector<Vec2> image;
  for (const ChainPoint& p : chain) image.push_back(camera.project(p.position).xy);
  const auto turn = [](const Vec2& a, const Vec2& b, const Vec2& c) {
    return cross(b - a, c - a) > 0;
  };
  int count = 0;
  const std::size_t n = image.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 2; j < n && !(i == 0 && j == n - 1); ++j) {
      const Vec2 &a = image[i], &b = image[(i + 1) % n], &c = image[j], &d = image[(j + 1) % n];
      count += turn(a, b, c) != turn(a, b, d) && turn(c, d, a) != turn(c, d, b);
    }
  }
  return count;
}

int self_crossings(const Silhouettes& found, const Camera& camera) {
  int count = 0;
  for (std::size_t c = 0; c < found.chains.size(); ++c) {
    count += self_crossings(found.chains[c], camera);
  }
  return count;
}

// A torus whose tube is so thin, and a view so steep, that all three regimes are met (b = |axis .
// view|, R = 1): r < b^2, b^2 < r < b, b < r.
struct Regime {
  double b;
  int cusps, crossings;
};
const std::vector<Regime> regimes{{.95, 0, 0}, {.8, 0, 0},  {.6, 4, 2}, {.5, 4, 2},
                                  {.45, 4, 2}, {.35, 4, 0}, {.2, 4, 0}, {.1, 4, 0}};

std::vector<Camera> cameras_at(double b) {
  const Vec3 direction(std::sqrt(1 - b * b), 0.013, b);
  // In perspective the regimes are those of a far eye.
  return {cameras::orthographic(direction, 1.6),
          cameras::perspective(40 * direction.normalized(), Vec3::Zero(), .1, 4.5)};
}

TEST(ExactSilhouettes, TorusInAllRegimes) {
  // Fine enough for the limit surface to have the torus's cusps and no others.
  const PolygonMesh quads = shapes::torus_mesh(1, .4, 64, 32);
  for (const PolygonMesh& cage : {quads, shapes::split_the_same_way(quads)}) {
    const Surface torus = refined(cage, at_level(-1));
    for (const Regime& regime : regimes) {
      for (const Camera& camera : cameras_at(regime.b)) {
        const Drawn drawn = draw(torus, camera);
        ASSERT_EQ(drawn.exact.chains.size(), 2U);
        EXPECT_EQ(drawn.exact.cusps, regime.cusps) << regime.b;
        EXPECT_EQ(self_crossings(drawn.exact, camera), regime.crossings) << regime.b;
      }
    }
  }
}

TEST(ExactSilhouettes, LieOnTheContourOfTheLimitSurface) {
  const PolygonMesh torus = shapes::torus_mesh(1, .4, 24, 12);
  PolygonMesh ellipsoid = shapes::icosphere_mesh(1, 2);
  for (Vec3& p : ellipsoid.positions) p = p.cwiseProduct(Vec3(1, .75, .5));
  for (const PolygonMesh& mesh : {torus, shapes::uv_sphere_mesh(1, 16, 8), ellipsoid}) {
    const Surface surface = refined(mesh, at_level(-1));
    for (const double b : {.9, .5, .2}) {
      for (const Camera& camera : cameras_at(b)) {
        const Drawn drawn = draw(surface, camera);
        const dense::Contour truth = dense::contour(surface, camera, drawn.linear.triangles);
        EXPECT_LT(apart(image_segments(drawn.exact, camera), truth.segments), .05) << b;
        const std::vector<Vec2> cusps = cusps_of(drawn.exact, camera);
        EXPECT_EQ(cusps.size() + 2 * static_cast<std::size_t>(drawn.counts.at("swallowtails")),
                  truth.cusps.size())
            << b;
        for (const Vec2& cusp : cusps) {
          double nearest = 1e3;
          for (const Vec2& other : truth.cusps) nearest = std::min(nearest, (cusp - other).norm());
          EXPECT_LT(nearest, .1) << b;
        }
      }
    }
  }
}

// A ridge so flat on top that a view along x meets it nearly edge-on far and wide: linear zeros lie
// off its contour, but for rows that are the same on both sides of the top. One row in eight is
// moved along the ridge's slope.
PolygonMesh uneven_ridge() {
  PolygonMesh mesh = shapes::plane(8, 200);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    Vec3& p = mesh.positions[v];
    if (v % 201 % 8 == 0) p.x() += .1;
    p.z() = -3 * std::pow(p.x(), 4);
  }
  return mesh;
}

TEST(ExactSilhouettes, StayOnTheOutlineWhereLinearOnesDrift) {
  const Surface surface = refined(uneven_ridge(), at_level(0));
  const Camera camera = cameras::orthographic(Vec3(1, 0, 0), 1);
  const Drawn drawn = draw(surface, camera);
  const dense::Contour truth = dense::contour(surface, camera, drawn.linear.triangles);
  const dense::Nearest contour(truth.segments);
  const auto farthest = [&](const auto& chains) {
    double result = 0;
    for (const auto& p : chains.values) {
      if (std::abs(p.position.y()) > .9) continue;
      result = std::max(result, contour(camera.project(p.position).xy));
    }
    return result;
  };
  EXPECT_GT(farthest(drawn.linear.chains), 1.5);
  EXPECT_LT(farthest(drawn.exact.chains), .1);
}

TEST(ExactSilhouettes, CuspsStandClearOfTheirStrands) {
  const Surface torus = refined(shapes::torus_mesh(1, .4, 24, 12), at_level(-1));
  for (const double b : {.6, .5, .3}) {
    for (const Camera& camera : cameras_at(b)) {
      const Drawn drawn = draw(torus, camera);
      for (std::size_t c = 0; c < drawn.exact.chains.size(); ++c) {
        const Span<const ChainPoint> chain = drawn.exact.chains[c];
        const std::size_t n = chain.size();
        for (std::size_t i = 0; i < n; ++i) {
          if (chain[i].cusp_jump == 0) continue;
          const Vec2 cusp = camera.project(chain[i].position).xy;
          for (const std::size_t k : {(i + 1) % n, (i + n - 1) % n}) {
            const double beside = (camera.project(chain[k].position).xy - cusp).norm();
            EXPECT_GE(beside, cusp_reach_px);
            EXPECT_LE(beside, 1.6 * cusp_reach_px);
          }
        }
      }
    }
  }
}

// Just where the cusps are born they come in pairs that no image shows.
// (u, v^2, u v) pinches at u = v = 0. Its contour from (0, 1, 1/2) is the line u = v without cusps,
// through the pinch point, which lies within a face, on an edge or at a vertex.
TEST(ExactSilhouettes, GoStraightOnThroughAPinchPoint) {
  for (const Vec2& shift : {Vec2(.031, .047), Vec2(0, .047), Vec2(0, 0)}) {
    PolygonMesh umbrella = shapes::plane(16, 16);
    for (Vec3& p : umbrella.positions) {
      const double u = p.x() + shift.x(), v = p.y() + shift.y();
      p = Vec3(u, v * v, u * v);
    }
    const Surface surface = refined(umbrella, at_level(3));
    const Camera camera = cameras::orthographic(Vec3(0, 1, .5), 2);
    const Drawn drawn = draw(surface, camera);
    double nearest = 1;
    for (const ChainPoint& p : drawn.exact.chains.values) {
      const double distance = Vec2(p.position.x(), p.position.z()).norm();
      nearest = std::min(nearest, distance);
      if (distance < .5) {
        EXPECT_EQ(p.cusp_jump, 0) << p.position.transpose();
      }
    }
    EXPECT_LT(nearest, .02);
  }
}

TEST(ExactSilhouettes, SwallowtailsTooSmallToSeeAreOnePoint) {
  const Surface torus = refined(shapes::torus_mesh(1, .4, 24, 12), at_level(-1));
  std::int64_t collapsed = 0;
  for (double b = .60; b < .66; b += .0005) {
    const Camera camera = cameras::orthographic(Vec3(std::sqrt(1 - b * b), 0.013, b), 1.6);
    const Drawn drawn = draw(torus, camera);
    EXPECT_TRUE(drawn.exact.cusps == 0 || drawn.exact.cusps == 2 || drawn.exact.cusps == 4) << b;
    EXPECT_EQ(2 * self_crossings(drawn.exact, camera), drawn.exact.cusps) << b;
    collapsed += drawn.counts.at("swallowtails");
  }
  EXPECT_GT(collapsed, 0);
}

// Two cusps at one place, a point between them by this much aside.
ExactPolyline cusps_at_one_place(double aside) {
  ExactPolyline line;
  line.edges = 5;
  for (const Vec2& p : {Vec2(-5, 0), Vec2(0, 0), Vec2(0, aside), Vec2(1e-4, 0), Vec2(5, 0)}) {
    ExactPoint point;
    point.position = Vec3(p.x(), p.y(), 0);
    point.segment = static_cast<int>(line.points.size());
    line.points.push_back(point);
  }
  line.points[1].cusp_jump = line.points[3].cusp_jump = 1;
  return line;
}

TEST(Swallowtails, WithoutExtentAreOnePoint) {
  const Camera one_px = cameras::orthographic(Vec3(0, 0, 1), 500);
  for (const double aside : {0., .01, .2}) {
    ExactPolyline line = cusps_at_one_place(aside);
    EXPECT_EQ(collapse_swallowtails({}, one_px, line), 1) << aside;
    EXPECT_EQ(line.points.size(), 3U) << aside;
  }
  ExactPolyline wide = cusps_at_one_place(.3);
  EXPECT_EQ(collapse_swallowtails({}, one_px, wide), 0);
}

TEST(ExactSilhouettes, KeepTheChainsOfTheLinearOnes) {
  for (const PolygonMesh& mesh :
       {shapes::torus_mesh(1, .4, 24, 12), shapes::klein_mesh(48, 24), bumpy_plane(5),
        creased(shapes::cube(), 10), creased(shapes::cube(), 1.5), shapes::icosahedron()}) {
    const Surface surface = refined(mesh, at_level(3));
    for (const double b : {.9, .5, .1}) {
      for (const Camera& camera : cameras_at(b)) {
        const Drawn drawn = draw(surface, camera);
        ASSERT_EQ(drawn.exact.chains.size(), drawn.linear.chains.size());
        for (std::size_t c = 0; c < drawn.exact.chains.size(); ++c) {
          EXPECT_EQ(drawn.exact.closed[c], drawn.linear.closed[c]);
          const auto jumps = [](Span<const ChainPoint> chain) {
            return std::count_if(chain.begin(), chain.end(),
                                 [](const ChainPoint& p) { return p.cusp_jump != 0; });
          };
          if (drawn.exact.closed[c]) {
            EXPECT_EQ(jumps(drawn.exact.chains[c]) % 2, 0);
          }
        }
      }
    }
  }
}

// Where everything is exact, every point is on the contour to rounding.
TEST(ExactSilhouettes, EverywhereMeansEverywhere) {
  const Surface torus = refined(shapes::torus_mesh(1, .4, 24, 12), at_level(2));
  const LimitSurface limit(torus);
  for (const Camera& camera : cameras_at(.5)) {
    const Drawn drawn = draw(torus, camera, Exactness::everywhere);
    LimitContour contour(limit, camera);
    for (const ChainPoint& p : drawn.exact.chains.values) {
      const PatchTriangle& patch = torus.patches[idx(p.on.triangle)];
      const Vec2 uv =
          (1 - p.on.b1 - p.on.b2) * patch.uv(0) + p.on.b1 * patch.uv(1) + p.on.b2 * patch.uv(2);
      EXPECT_LT(std::abs(contour.at({patch.ptex_face, uv})->g), 1e-4);
    }
    EXPECT_GT(drawn.counts.at("evaluations"), draw(torus, camera).counts.at("evaluations"));
  }
}

TEST(ExactSilhouettes, FacesSeenEdgeOnAndBehindTheEyeStayLinear) {
  PolygonMesh box = creased(shapes::cube(), 10);
  const Surface surface = refined(box, at_level(2));
  const Drawn edge_on = draw(surface, cameras::orthographic(Vec3(1, 0, 0), 2));
  for (const ChainPoint& p : edge_on.exact.chains.values) EXPECT_TRUE(p.position.allFinite());
  const Surface torus = refined(shapes::torus_mesh(1, .4, 24, 12), at_level(3));
  const Drawn inside = draw(torus, cameras::perspective(Vec3(1, 0, .1), Vec3(0, 1, 0)));
  for (const ChainPoint& p : inside.exact.chains.values) EXPECT_TRUE(p.position.allFinite());
}

}  // namespace
}  // namespace illustrate
