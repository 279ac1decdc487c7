#include "visibility/labels/label_problem.h"

#include <gtest/gtest.h>

#include <random>

namespace illustrate {
namespace {

constexpr int most_label = 4;  // labels of the small problems are at most this

class RandomProblems {
 public:
  LabelProblem next() {
    LabelProblem problem;
    problem.unknowns = between(1, 6);
    for (int i = between(0, 8); i > 0; --i) {
      const int low = between(0, 3);
      problem.values.push_back({between(0, problem.unknowns - 1), low, low + between(0, 1),
                                between(0, 9), between(0, 9)});
    }
    for (int i = 0; i < problem.unknowns; ++i)
      problem.values.push_back({i, 0, most_label, 0, 1000});
    for (int i = problem.unknowns > 1 ? between(0, 10) : 0; i > 0; --i) add_difference(problem);
    return problem;
  }

  std::vector<int> labels(int count) {
    std::vector<int> result;
    for (int i = 0; i < count; ++i) result.push_back(between(0, most_label + 1));
    return result;
  }

 private:
  int between(int low, int high) {
    return low + static_cast<int>(random_() % static_cast<unsigned>(high - low + 1));
  }

  void add_difference(LabelProblem& problem) {
    const int from = between(0, problem.unknowns - 1), to = between(0, problem.unknowns - 1);
    if (from == to) return;
    problem.differences.push_back({from, to, between(-2, 2), between(0, 9), between(0, 9)});
  }

  std::mt19937 random_{1};
};

// The next of all labels up to `most_label`; false after the last.
bool advance(std::vector<int>& x) {
  for (int& label : x) {
    if (++label <= most_label) return true;
    label = 0;
  }
  return false;
}

// By trying all: the labels that are least where several have the least price.
std::vector<int> tried_labels(const LabelProblem& problem) {
  std::vector<int> x(idx(problem.unknowns), 0), best = x;
  do {
    const std::int64_t gain = price(problem, best) - price(problem, x);
    if (gain > 0) best = x;
    if (gain != 0) continue;
    for (std::size_t i = 0; i < x.size(); ++i) best[i] = std::min(best[i], x[i]);
  } while (advance(x));
  return best;
}

TEST(LeastLabels, AreThoseFoundByTryingAll) {
  RandomProblems random;
  for (int i = 0; i < 500; ++i) {
    const LabelProblem problem = random.next();
    const std::vector<int> found = least_labels(problem, random.labels(problem.unknowns));
    ASSERT_EQ(found, tried_labels(problem)) << "problem " << i;
  }
}

TEST(LeastLabels, DoNotDependOnTheStart) {
  RandomProblems random;
  for (int i = 0; i < 500; ++i) {
    const LabelProblem problem = random.next();
    const std::vector<int> from_zero =
        least_labels(problem, std::vector<int>(idx(problem.unknowns), 0));
    ASSERT_EQ(least_labels(problem, random.labels(problem.unknowns)), from_zero);
  }
}

// A long chain whose two ends say 0 and 7: all the change is where it is cheapest.
TEST(LeastLabels, BreakAChainAtItsCheapestLink) {
  constexpr int count = 20000, cheapest = 12345;
  LabelProblem problem;
  problem.unknowns = count;
  for (int i = 0; i + 1 < count; ++i) {
    const std::int64_t link = i == cheapest ? 10 : 11 + i % 5;
    problem.differences.push_back({i, i + 1, 0, link, link});
  }
  problem.values = {{0, 0, 0, 1000, 1000}, {count - 1, 7, 7, 1000, 1000}};
  const std::vector<int> x = least_labels(problem, std::vector<int>(count, 3));
  EXPECT_EQ(price(problem, x), 70);
  for (int i = 0; i < count; ++i) ASSERT_EQ(x[idx(i)], i <= cheapest ? 0 : 7) << i;
}

TEST(LeastLabels, OfNothingAreZero) {
  EXPECT_TRUE(least_labels({}, {}).empty());
  LabelProblem problem;
  problem.unknowns = 2;
  problem.differences.push_back({0, 1, 0, 1, 1});
  EXPECT_EQ(least_labels(problem, {3, 1}), (std::vector<int>{0, 0}));
}

}  // namespace
}  // namespace illustrate
