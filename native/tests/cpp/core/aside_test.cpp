#include "core/aside.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "core/errors.h"

namespace illustrate {
namespace {

// Work that reports until it is told to stop.
int report_for_ever(const Progress& progress) {
  for (;;) progress.report(0.5);
}

TEST(Aside, GivesWhatIsMadeByAnyNumberOfThreads) {
  for (const int threads : {0, 1, 2}) {
    Aside<int> aside(threads, [](const Progress& progress) {
      progress.report(1);
      return 7;
    });
    EXPECT_EQ(aside.take({}), 7);
  }
}

TEST(Aside, BeginsAtOnceBesideTheCaller) {
  std::atomic<bool> caller_goes_on{false};
  Aside<bool> aside(2, [&](const Progress&) {
    while (!caller_goes_on) std::this_thread::yield();
    return true;
  });
  caller_goes_on = true;
  EXPECT_TRUE(aside.take({}));
}

TEST(Aside, OneThreadDoesItWhenItIsTaken) {
  bool has_begun = false;
  Aside<int> aside(1, [&](const Progress&) {
    has_begun = true;
    return 1;
  });
  EXPECT_FALSE(has_begun);
  EXPECT_EQ(aside.take({}), 1);
  EXPECT_TRUE(has_begun);
}

TEST(Aside, ThrowsWhatItsWorkThrew) {
  for (const int threads : {1, 2}) {
    Aside<int> aside(threads, [](const Progress&) -> int { throw InvalidInput("no light"); });
    EXPECT_THROW(aside.take({}), InvalidInput);
  }
}

TEST(Aside, StopsWhereItsCallerIsStopped) {
  for (const int threads : {1, 2}) {
    Aside<int> aside(threads, report_for_ever);
    int reports = 0;
    const Progress stopped([&](double, const std::string&) { return ++reports < 3; }, "tone");
    EXPECT_THROW(aside.take(stopped), Cancelled);
    EXPECT_EQ(reports, 3);
  }
}

TEST(Aside, StopsWhereNobodyTakesIt) { const Aside<int> aside(2, report_for_ever); }

}  // namespace
}  // namespace illustrate
