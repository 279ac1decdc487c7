#include "core/parallel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>

#include "core/errors.h"

namespace illustrate {
namespace {

class ParallelTest : public testing::TestWithParam<int> {};

TEST_P(ParallelTest, EveryElementOnceAndReportsBeforeEachPiece) {
  for (const std::size_t count : {0, 1, 4096, 4097, 300'001}) {
    std::vector<std::atomic<int>> visits(count);
    std::atomic<std::size_t> between = 0, most = 0;
    std::vector<double> reports;
    const Progress progress(
        [&](double fraction, const std::string&) {
          reports.push_back(fraction);
          most = std::max(most.load(), between.exchange(0));
          return true;
        },
        "");
    parallel_for(count, GetParam(), progress, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) ++visits[i];
      between += end - begin;
    });
    for (const auto& visit : visits) ASSERT_EQ(visit, 1);
    EXPECT_LE(std::max(most.load(), between.load()), 4096U * static_cast<std::size_t>(GetParam()));
    EXPECT_TRUE(std::is_sorted(reports.begin(), reports.end()));
    EXPECT_EQ(reports.empty(), count == 0);
  }
}

TEST_P(ParallelTest, StopsBeforeTheNextPiece) {
  std::atomic<std::size_t> done = 0;
  int reports = 0;
  const Progress progress([&](double, const std::string&) { return ++reports < 3; }, "");
  const auto body = [&](std::size_t begin, std::size_t end) { done += end - begin; };
  EXPECT_THROW(parallel_for(1'000'000, GetParam(), progress, body), Cancelled);
  EXPECT_EQ(done, 2U * 4096U * static_cast<std::size_t>(GetParam()));
}

TEST_P(ParallelTest, ExceptionsComeThrough) {
  const auto body = [](std::size_t begin, std::size_t end) {
    if (begin <= 77'777 && 77'777 < end) throw InvalidInput("element 77777");
  };
  EXPECT_THROW(parallel_for(100'000, GetParam(), body), InvalidInput);
  EXPECT_THROW(parallel_for(100'000, GetParam(), {}, body), InvalidInput);
}

TEST_P(ParallelTest, EachElementOnceWhoeverIsFree) {
  for (const std::size_t count : {0, 1, 3, 100}) {
    std::vector<std::atomic<int>> visits(count);
    parallel_each(count, GetParam(), {}, [&](std::size_t i) { ++visits[i]; });
    for (const auto& visit : visits) EXPECT_EQ(visit, 1);
  }
}

TEST_P(ParallelTest, EachStopsWhenCancelledOrFailed) {
  std::atomic<int> done = 0;
  const Progress cancel([&](double, const std::string&) { return false; }, "");
  EXPECT_THROW(parallel_each(1000, GetParam(), cancel, [&](std::size_t) { ++done; }), Cancelled);
  const auto fails = [](std::size_t i) {
    if (i == 7) throw InvalidInput("element 7");
  };
  EXPECT_THROW(parallel_each(1000, GetParam(), {}, fails), InvalidInput);
}

TEST(Parts, GetAllThreadsWhereTheyAreLargeOrMostOfTheWork) {
  struct Case {
    std::vector<std::size_t> sizes;
    std::vector<std::size_t> alone;
  };
  const PartSizes limits{100, 10};
  for (const auto& [sizes, alone] : {Case{{}, {}}, Case{{1}, {0}}, Case{{1, 1}, {}},
                                     Case{{3, 1, 1}, {0}}, Case{{50, 101, 60, 102}, {1, 3}}}) {
    std::vector<int> threads(sizes.size(), 0);
    std::vector<double> reports;
    const Progress progress(
        [&](double fraction, const std::string&) {
          reports.push_back(fraction);
          return true;
        },
        "");
    parallel_parts(sizes, limits, 7, progress, [&](std::size_t part, int given, const Progress& p) {
      threads[part] = given;
      p.report(1);
    });
    for (std::size_t part = 0; part < sizes.size(); ++part) {
      const bool is_alone = std::count(alone.begin(), alone.end(), part) > 0;
      EXPECT_EQ(threads[part], is_alone ? 7 : 1);
    }
    EXPECT_TRUE(std::is_sorted(reports.begin(), reports.end()));
    EXPECT_GE(reports.size(), alone.size());
  }
}

TEST_P(ParallelTest, PartsStopWhenCancelledOrFailed) {
  const std::vector<std::size_t> sizes{1, 200, 1, 1};
  const Progress cancel([](double, const std::string&) { return false; }, "");
  const auto asks = [](std::size_t, int, const Progress& progress) { progress.report(0); };
  EXPECT_THROW(parallel_parts(sizes, {100, 1}, GetParam(), cancel, asks), Cancelled);
  const auto fails = [](std::size_t part, int, const Progress&) {
    if (part == 3) throw InvalidInput("part 3");
  };
  EXPECT_THROW(parallel_parts(sizes, {100, 1}, GetParam(), {}, fails), InvalidInput);
}

TEST(Shares, HoldWorkEnoughAndEverything) {
  EXPECT_EQ(shares_of({}, 5), (std::vector<std::size_t>{0}));
  EXPECT_EQ(shares_of({1}, 5), (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(shares_of({9, 1, 1, 3, 9, 1}, 5), (std::vector<std::size_t>{0, 1, 4, 5, 6}));
}

INSTANTIATE_TEST_SUITE_P(Threads, ParallelTest, testing::Values(1, 2, 5));

}  // namespace
}  // namespace illustrate
