// Triangles of polygons: those whose least angles are largest.
#include "mesh/delaunay_flips.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

#include "core/pi.h"
#include "mesh/polygons.h"

namespace illustrate {
namespace {

// Round the origin, as seen from which each corner is seen.
Points star(int corners, std::mt19937& random) {
  std::uniform_real_distribution<double> radius(1, 3);
  Points polygon;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * pi * i / corners;
    polygon.push_back(radius(random) * Vec3(std::cos(angle), std::sin(angle), 0));
  }
  return polygon;
}

double area(const Points& p, const Triangle& t) {
  return (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]).z() / 2;
}

double angle_at(const Vec3& p, const Vec3& a, const Vec3& b) {
  return std::atan2((a - p).cross(b - p).norm(), (a - p).dot(b - p));
}

// Where both diagonals of the quad lie inside.
void expect_delaunay(const Points& p, const std::vector<Triangle>& triangles) {
  std::map<Edge, int> opposite;  // of each side as its triangle runs along it
  for (const Triangle& t : triangles)
    for (int k = 0; k < 3; ++k) opposite[{t[k], t[next_corner(k)]}] = t[previous_corner(k)];
  for (const auto& [side, c] : opposite) {
    const auto other = opposite.find({side[1], side[0]});
    if (other == opposite.end()) continue;
    const int d = other->second;
    if (area(p, {side[0], d, c}) <= 0 || area(p, {d, side[1], c}) <= 0) continue;
    EXPECT_LE(angle_at(p[c], p[side[0]], p[side[1]]) + angle_at(p[d], p[side[0]], p[side[1]]),
              pi + 1e-5);
  }
}

TEST(DelaunayFlips, LeaveNoDiagonalThatIsWorseThanTheOther) {
  std::mt19937 random(7);
  for (int corners = 5; corners < 60; ++corners) {
    const Points polygon = star(corners, random);
    const std::vector<Triangle> triangles = triangulate({polygon.data(), polygon.size()});
    ASSERT_EQ(triangles.size(), polygon.size() - 2);
    double sum = 0;
    for (const Triangle& t : triangles) {
      EXPECT_GE(area(polygon, t), -1e-12);
      sum += area(polygon, t);
    }
    EXPECT_NEAR(sum, newell_normal({polygon.data(), polygon.size()}).z() / 2, 1e-9);
    expect_delaunay(polygon, triangles);
  }
}

TEST(DelaunayFlips, KeepWhatIsAsGood) {
  const ImagePoints square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (const auto& triangles :
       {std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}, std::vector<Triangle>{{1, 2, 3}, {1, 3, 0}}}) {
    std::vector<Triangle> flipped = triangles;
    flip_to_delaunay(square, flipped);
    EXPECT_EQ(flipped, triangles);
  }
}

}  // namespace
}  // namespace illustrate
