#include "contour/exact/steady_signs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace illustrate {
namespace {

double cost_of(const std::vector<int>& signs, const std::vector<double>& numbers, double price) {
  double cost = 0;
  for (std::size_t i = 0; i < signs.size(); ++i) {
    if (signs[i] * numbers[i] < 0) cost += std::abs(numbers[i]);
    if (i > 0 && signs[i] != signs[i - 1]) cost += price;
  }
  return cost;
}

double least_cost(const std::vector<double>& numbers, double price) {
  double least = std::numeric_limits<double>::infinity();
  for (unsigned way = 0; way < 1U << numbers.size(); ++way) {
    std::vector<int> signs;
    for (std::size_t i = 0; i < numbers.size(); ++i) signs.push_back((way >> i) % 2 == 1 ? 1 : -1);
    least = std::min(least, cost_of(signs, numbers, price));
  }
  return least;
}

TEST(SteadySigns, PassOverNoiseAndChangeForGood) {
  EXPECT_EQ(steady_signs({1, 1, -1.5, 1, 1}, 1), (std::vector<int>{1, 1, 1, 1, 1}));
  EXPECT_EQ(steady_signs({-1, -1, .5, -1, 1, 1, 1}, 1),
            (std::vector<int>{-1, -1, -1, -1, 1, 1, 1}));
  EXPECT_TRUE(steady_signs({}, 1).empty());
}

TEST(SteadySigns, AreTheBestOfAllWays) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int round = 0; round < 200; ++round) {
    std::vector<double> numbers(10);
    for (double& n : numbers) n = number(random);
    const double price = std::abs(number(random));
    EXPECT_NEAR(cost_of(steady_signs(numbers, price), numbers, price), least_cost(numbers, price),
                1e-12);
  }
}

}  // namespace
}  // namespace illustrate
