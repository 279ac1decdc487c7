#include "hatch/curves/curve_cells.h"

#include <gtest/gtest.h>

namespace illustrate {
namespace {

CurveNode node_at(const Vec3& position) {
  CurveNode node{};
  node.position = position.cast<float>();
  return node;
}

// The greatest number of nodes that a search looks at; nodes lie a unit apart along the diagonal.
int most_tested(const Vec3& size, double radius) {
  CurveCells cells(size, radius);
  const int count = static_cast<int>(size.norm());
  const auto place = [&](int i) { return Vec3(size * (i + 0.5) / count); };
  for (int i = 0; i < count; ++i) cells.add(node_at(place(i)));
  int most = 0;
  for (int i = 0; i < count; i += 97) {
    int tested = 0;
    bool found = false;
    cells.any_near(place(i).cast<float>(), static_cast<float>(radius), [&](const CurveNode& node) {
      ++tested;
      found = found || (node.position - place(i).cast<float>()).norm() < 0.1F;
      return false;
    });
    EXPECT_TRUE(found);
    most = std::max(most, tested);
  }
  return most;
}

TEST(CurveCells, SearchesLookAtFewNodesWhateverTheShapeOfTheBox) {
  EXPECT_LE(most_tested(Vec3(100, 100, 100), 2), 12);
  EXPECT_LE(most_tested(Vec3(300'000, 0.1, 0.1), 2), 12) << "a needle";
  EXPECT_LE(most_tested(Vec3(0.1, 0, 300'000), 2), 12) << "another";
  EXPECT_LE(most_tested(Vec3(2000, 3000, 0.1), 2), 12) << "a sheet";
}

TEST(CurveCells, TakesNodesAwayAgain) {
  CurveCells cells(Vec3(10, 10, 10), 1);
  cells.add(node_at(Vec3(2, 2, 2)));
  cells.add(node_at(Vec3(2.1, 2, 2)));
  cells.shrink(1);
  int left = 0;
  cells.any_near(Eigen::Vector3f(2, 2, 2), 1, [&](const CurveNode&) { return ++left < 0; });
  EXPECT_EQ(left, 1);
}

}  // namespace
}  // namespace illustrate
