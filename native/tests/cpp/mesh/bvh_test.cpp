#include "mesh/bvh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <set>

#include "tests/cpp/shapes.h"

namespace illustrate {
namespace {

using Pair = std::pair<int, int>;

struct Soup {
  Points positions;
  std::vector<Triangle> triangles;
};

Soup random_soup(int count, double size, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-1, 1), offset(-size, size);
  Soup soup;
  for (int t = 0; t < count; ++t) {
    const Vec3 centre{place(random), place(random), place(random)};
    for (int k = 0; k < 3; ++k)
      soup.positions.push_back(centre + Vec3{offset(random), offset(random), offset(random)});
    soup.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  return soup;
}

std::vector<Pair> pairs_of(const Bvh& tree) {
  std::vector<Pair> pairs;
  tree.overlapping_pairs([&](int a, int b) { pairs.emplace_back(a, b); });
  return pairs;
}

std::vector<Eigen::AlignedBox3d> boxes_of(const Soup& soup) {
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const Triangle& t : soup.triangles) {
    boxes.emplace_back();
    for (const int v : t) boxes.back().extend(soup.positions[v]);
  }
  return boxes;
}

std::set<Pair> pairs_by_brute_force(const Soup& soup) {
  const std::vector<Eigen::AlignedBox3d> boxes = boxes_of(soup);
  std::set<Pair> pairs;
  for (int a = 0; a < static_cast<int>(boxes.size()); ++a)
    for (int b = a + 1; b < static_cast<int>(boxes.size()); ++b)
      if (boxes[a].intersects(boxes[b])) pairs.emplace(a, b);
  return pairs;
}

std::vector<RayHit> hits_of(const Bvh& tree, const Vec3& origin, const Vec3& direction) {
  std::vector<RayHit> hits;
  tree.hits(origin, direction, 0, std::numeric_limits<double>::infinity(), hits);
  return hits;
}

TEST(Bvh, PairsAreThoseOfBruteForceEachOnce) {
  for (const double size : {0.04, 0.1, 0.5}) {
    const Soup soup = random_soup(400, size, 3);
    const std::vector<Pair> pairs = pairs_of(Bvh(soup.positions, soup.triangles));
    const std::set<Pair> unique(pairs.begin(), pairs.end());
    EXPECT_EQ(unique.size(), pairs.size());
    EXPECT_EQ(unique, pairs_by_brute_force(soup));
    EXPECT_FALSE(pairs.empty());
  }
}

TEST(Bvh, IsTheSameForAnyNumberOfThreads) {
  const Soup soup = random_soup(30000, .01, 5);
  const Bvh one(soup.positions, soup.triangles, 1);
  const std::vector<Pair> pairs = pairs_of(one);
  EXPECT_FALSE(pairs.empty());
  const Vec3 origin(-2, .01, .02);
  const std::vector<RayHit> hits = hits_of(one, origin, {1, 0, 0});
  EXPECT_FALSE(hits.empty());
  for (const int threads : {2, 5}) {
    const Bvh many(soup.positions, soup.triangles, threads);
    EXPECT_EQ(pairs_of(many), pairs);
    const std::vector<RayHit> again = hits_of(many, origin, {1, 0, 0});
    ASSERT_EQ(again.size(), hits.size());
    for (std::size_t i = 0; i < hits.size(); ++i) EXPECT_EQ(again[i].triangle, hits[i].triangle);
  }
}

TEST(Bvh, BoxesThatOnlyTouchAreAPair) {
  const Soup soup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}, {1, 2, 0}},
                  {{0, 1, 2}, {3, 4, 5}}};
  EXPECT_EQ(pairs_of(Bvh(soup.positions, soup.triangles)), std::vector<Pair>({{0, 1}}));
}

TEST(Bvh, BoxesWithinTheMarginAreAPair) {
  const Soup soup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 1, 0.5}, {3, 1, 0.5}, {2, 2, 0.5}},
                  {{0, 1, 2}, {3, 4, 5}}};
  const Bvh tree(soup.positions, soup.triangles);
  const auto count = [&](double margin) {
    int pairs = 0;
    tree.overlapping_pairs([&](int, int) { ++pairs; }, margin);
    return pairs;
  };
  EXPECT_EQ(count(0), 0);
  EXPECT_EQ(count(0.99), 0);
  EXPECT_EQ(count(1), 1);
}

TEST(Bvh, TrianglesNearAPointAreThoseOfBruteForce) {
  const Soup soup = random_soup(400, .1, 6);
  const Bvh tree(soup.positions, soup.triangles);
  const std::vector<Eigen::AlignedBox3d> boxes = boxes_of(soup);
  for (const double reach : {0., .05, .5}) {
    for (const Vec3& p : random_soup(30, .1, 7).positions) {
      const Eigen::AlignedBox3d around(Vec3(p.array() - reach), Vec3(p.array() + reach));
      std::multiset<int> found, expected;
      tree.near_point(p, reach, [&](int t) { found.insert(t); });
      for (int t = 0; t < static_cast<int>(boxes.size()); ++t)
        if (boxes[idx(t)].intersects(around)) expected.insert(t);
      EXPECT_EQ(found, expected);
    }
  }
}

TEST(Bvh, HitsAreThoseOfTheTriangleEquation) {
  const Soup soup = random_soup(300, 0.4, 4);
  const Bvh tree(soup.positions, soup.triangles);
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  std::size_t total = 0;
  for (int i = 0; i < 300; ++i) {
    const Vec3 origin{normal(random), normal(random), normal(random)};
    const Vec3 direction{normal(random), normal(random), normal(random)};
    std::set<int> expected;
    for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
      const Vec3 &p = soup.positions[3 * t], &q = soup.positions[3 * t + 1];
      Eigen::Matrix3d m;
      m << q - p, soup.positions[3 * t + 2] - p, -direction;
      const Vec3 s = m.inverse() * (origin - p);
      if (s.x() > 0 && s.y() > 0 && s.x() + s.y() < 1 && s.z() > 0)
        expected.insert(static_cast<int>(t));
    }
    std::set<int> found;
    for (const RayHit& hit : hits_of(tree, origin, direction)) {
      found.insert(hit.triangle);
      const Triangle& t = soup.triangles[hit.triangle];
      const Vec3 n = (soup.positions[t[1]] - soup.positions[t[0]])
                         .cross(soup.positions[t[2]] - soup.positions[t[0]])
                         .normalized();
      EXPECT_NEAR(n.dot(origin + hit.distance * direction - soup.positions[t[0]]), 0, 1e-11);
    }
    EXPECT_EQ(found, expected);
    total += found.size();
  }
  EXPECT_GT(total, 200u);
}

// Boxes only say where to look: nothing is missed however far away, large or small all is.
TEST(Bvh, HitsAreThoseOfEachTriangleAlone) {
  std::mt19937 random(17);
  std::normal_distribution<double> normal;
  const auto vector = [&] { return Vec3(normal(random), normal(random), normal(random)); };
  std::size_t total = 0;
  for (const auto& [size, off, eye] : std::vector<std::array<double, 3>>{
           {1, 0, 1}, {1, 1e6, 1}, {1, 0, 1e9}, {1e-7, 1, 3}, {1e12, 1e3, 0.1}, {1e-30, 0, 1}}) {
    Soup soup = random_soup(120, 0.4, 18);
    soup.positions[0] *= 1e3;  // beside the others their boxes are small
    for (Vec3& p : soup.positions) p = size * (p + Vec3(off, -off, off / 3));
    const Bvh tree(soup.positions, soup.triangles);
    std::vector<std::vector<Triangle>> single;
    for (const Triangle& triangle : soup.triangles) single.push_back({triangle});
    std::vector<Bvh> alone;
    for (const auto& triangle : single) alone.emplace_back(soup.positions, triangle, 1);
    for (int i = 0; i < 60; ++i) {
      const Vec3 target = soup.positions[idx(6 * i)] + 0.1 * size * vector();
      const Vec3 origin = target + eye * size * vector();
      std::set<int> expected, found;
      for (std::size_t t = 0; t < alone.size(); ++t) {
        const bool is_hit = !hits_of(alone[t], origin, target - origin).empty();
        if (is_hit) expected.insert(static_cast<int>(t));
      }
      for (const RayHit& hit : hits_of(tree, origin, target - origin)) found.insert(hit.triangle);
      EXPECT_EQ(found, expected);
      total += found.size();
    }
  }
  EXPECT_GT(total, 300U);
}

TEST(Bvh, RaysThroughEdgesAndVerticesAreWatertight) {
  const Surface sphere = shapes::sphere_surface(1, 3);
  const Bvh tree(sphere.positions, sphere.triangles);
  for (std::size_t t = 0; t < sphere.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const Vec3& a = sphere.positions[sphere.triangles[t][k]];
      const Vec3& b = sphere.positions[sphere.triangles[t][next_corner(k)]];
      for (const Vec3& target : {a, Vec3((a + b) / 2), Vec3(a * 0.3 + b * 0.7)}) {
        EXPECT_EQ(hits_of(tree, Vec3::Zero(), target).size(), 1u);
        EXPECT_EQ(hits_of(tree, Vec3(0.1, 0.2, -0.3), target - Vec3(0.1, 0.2, -0.3)).size(), 1u);
        EXPECT_EQ(hits_of(tree, 3 * target, -target).size(), 2u);
      }
    }
}

TEST(Bvh, AxisParallelRaysThroughAGridHitOnce) {
  const Surface plane = shapes::plain_surface(shapes::plane(8, 8));
  const Bvh tree(plane.positions, plane.triangles);
  for (int i = 1; i < 32; ++i)
    for (int j = 1; j < 32; ++j) {
      const Vec3 above{i / 16.0 - 1, j / 16.0 - 1, 2};
      const auto hits = hits_of(tree, above, {0, 0, -4});
      ASSERT_EQ(hits.size(), 1u);
      EXPECT_DOUBLE_EQ(hits[0].distance, 0.5);
      EXPECT_TRUE(hits_of(tree, Vec3(above.x(), above.y(), 0), {1, 0, 0}).empty());
    }
}

TEST(Bvh, WindingDoesNotMatterToSharedEdges) {
  const Soup soup{{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 1, 3}}};
  const Bvh tree(soup.positions, soup.triangles);
  for (const double s : {0.25, 0.5, 0.7})
    for (const double z : {1.0, -1.0}) EXPECT_EQ(hits_of(tree, {s, s, z}, {0, 0, -z}).size(), 1u);
}

TEST(Bvh, DistancesAreBoundedOnBothSides) {
  const Surface plane = shapes::plain_surface(shapes::plane(1, 1));
  const Bvh tree(plane.positions, plane.triangles);
  const auto count = [&](double low, double high) {
    std::vector<RayHit> hits;
    tree.hits({0.1, 0.2, 1}, {0, 0, -2}, low, high, hits);
    return hits.size();
  };
  EXPECT_EQ(count(0, 1), 1u);
  EXPECT_EQ(count(0.5, 1), 0u);
  EXPECT_EQ(count(0, 0.5), 0u);
  EXPECT_EQ(count(-5, -1), 0u);
}

TEST(Bvh, DegenerateInputIsHarmless) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Soup soup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {nan, 0, 0}, {1e150, 1e150, 1e150}},
            {{0, 1, 3}, {0, 0, 0}, {0, 1, 4}}};
  for (int i = 0; i < 3000; ++i) soup.triangles.push_back({0, 1, 2});
  const Bvh tree(soup.positions, soup.triangles);
  EXPECT_EQ(hits_of(tree, {0.1, 0.2, 1}, {0, 0, -1}).size(), 3000u);
  EXPECT_TRUE(hits_of(tree, {0.2, 0.2, 1}, {0, 0, 0}).empty());
  EXPECT_TRUE(hits_of(tree, {0.2, nan, 1}, {0, 0, 1}).empty());
  EXPECT_TRUE(hits_of(Bvh({}, {}), {0, 0, 0}, {0, 0, 1}).empty());
  EXPECT_TRUE(pairs_of(Bvh({}, {})).empty());
}

TEST(Bvh, DeepTreesOfGrowingTrianglesAreWalked) {
  Soup soup;
  for (int i = 0; i < 900; ++i) {
    const double s = std::ldexp(1.0, i - 450);
    for (const Vec3& p : {Vec3(s, 0, 0), Vec3(2 * s, 0, 0), Vec3(s, s, 0)})
      soup.positions.push_back(p);
    soup.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  const Bvh tree(soup.positions, soup.triangles);
  EXPECT_EQ(hits_of(tree, {1.25, 0.125, 1}, {0, 0, -1}).size(), 1u);
}

// The least distance to points of a triangle that are close together.
double sampled_distance(const std::array<Vec3, 3>& corners, const Vec3& p) {
  constexpr int steps = 60;
  double least = std::numeric_limits<double>::max();
  for (int a = 0; a <= steps; ++a)
    for (int b = 0; a + b <= steps; ++b) {
      const double u = double(a) / steps, v = double(b) / steps;
      least =
          std::min(least, ((1 - u - v) * corners[0] + u * corners[1] + v * corners[2] - p).norm());
    }
  return least;
}

TEST(BvhNearest, FindsTheNearestPointOfAnyTriangle) {
  const Soup soup = random_soup(60, 0.3, 11);
  const Bvh tree(soup.positions, soup.triangles, 1);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-1.5, 1.5);
  for (int k = 0; k < 60; ++k) {
    const Vec3 p(place(random), place(random), place(random));
    const auto corners = [&](std::size_t t) {
      return std::array<Vec3, 3>{soup.positions[3 * t], soup.positions[3 * t + 1],
                                 soup.positions[3 * t + 2]};
    };
    double least = std::numeric_limits<double>::max();
    for (std::size_t t = 0; t < 60; ++t) least = std::min(least, sampled_distance(corners(t), p));
    const SurfacePoint found = tree.nearest(p, 10);
    ASSERT_NE(found.triangle, none);
    const auto c = corners(static_cast<std::size_t>(found.triangle));
    const Vec3 at = (1 - found.b1 - found.b2) * c[0] + found.b1 * c[1] + found.b2 * c[2];
    EXPECT_GE(std::min({found.b1, found.b2, 1 - found.b1 - found.b2}), -1e-12);
    EXPECT_LE((at - p).norm(), least + 1e-12);
    EXPECT_GE((at - p).norm(), least - 0.02);
    EXPECT_EQ(tree.nearest(p, 0.99 * (at - p).norm()).triangle, none);
    EXPECT_EQ(tree.nearest(p, 1.01 * (at - p).norm()).triangle, found.triangle);
  }
}

TEST(BvhNearest, IsTheFirstOfTrianglesThatShareThePoint) {
  const Points positions{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  const std::vector<Triangle> triangles{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}};
  const Bvh tree(positions, triangles, 1);
  const SurfacePoint found = tree.nearest({0, 0, 1}, 2);
  EXPECT_EQ(found.triangle, 0);
  EXPECT_EQ(found.b1 + found.b2, 0);
}

TEST(BvhNearest, HasNoneForNothing) {
  const Soup soup = random_soup(5, 0.3, 1);
  const Bvh tree(soup.positions, soup.triangles, 1);
  const double nan = std::nan("");
  EXPECT_EQ(tree.nearest({nan, 0, 0}, 10).triangle, none);
  EXPECT_EQ(tree.nearest({0, 0, 0}, nan).triangle, none);
  EXPECT_EQ(Bvh().nearest({0, 0, 0}, 10).triangle, none);
}

}  // namespace
}  // namespace illustrate
