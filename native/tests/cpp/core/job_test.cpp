#include "core/job.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <random>

#include "core/errors.h"
#include "core/parallel.h"

namespace illustrate {
namespace {

constexpr double patience_s = 60;
constexpr int repeats = 100;

void sleep_us(int microseconds) {
  std::this_thread::sleep_for(std::chrono::microseconds(microseconds));
}

// Work that reports until it is told to stop.
void endless(const Progress& progress) {
  for (;;) {
    progress.report(0.5);
    sleep_us(20);
  }
}

TEST(Job, RunsToItsEndAndTellsHowFarItIs) {
  std::atomic<int> step{0};
  Job job([&](const Progress& progress) {
    progress.part(0, 0.5, "first").report(1);
    step = 1;
    while (step == 1) sleep_us(20);
    progress.part(0.25, 1, "second").report(0);
  });
  while (step == 0) sleep_us(20);
  EXPECT_FALSE(job.is_done());
  EXPECT_FALSE(job.wait(0.001));
  EXPECT_NO_THROW(job.rethrow());
  EXPECT_EQ(job.state().fraction, 0.5);
  EXPECT_EQ(job.state().stage, "first");
  step = 2;
  EXPECT_TRUE(job.wait(patience_s));
  EXPECT_TRUE(job.is_done());
  EXPECT_NO_THROW(job.rethrow());
  EXPECT_EQ(job.state().fraction, 0.5) << "what was told never falls";
  EXPECT_EQ(job.state().stage, "second");
}

TEST(Job, WhatTheWorkThrowsIsItsEnd) {
  Job job([](const Progress&) { throw InvalidInput("edge 3"); });
  ASSERT_TRUE(job.wait(patience_s));
  EXPECT_THROW(job.rethrow(), InvalidInput);
  EXPECT_THROW(job.rethrow(), InvalidInput) << "as often as it is asked for";
}

TEST(Job, ThrowsFromThreadsOfTheWorkComeThrough) {
  Job job([](const Progress& progress) {
    parallel_for(100'000, 4, progress, [](std::size_t begin, std::size_t) {
      if (begin > 50'000) throw std::bad_alloc();
    });
  });
  ASSERT_TRUE(job.wait(patience_s));
  EXPECT_THROW(job.rethrow(), std::bad_alloc);
}

TEST(Job, TheWorkIsDestroyedWhenItEnds) {
  const auto held = std::make_shared<int>(1);
  Job job([held](const Progress&) {});
  ASSERT_TRUE(job.wait(patience_s));
  EXPECT_EQ(held.use_count(), 1);
}

TEST(Job, StopsWhenCancelledAtAnyMoment) {
  std::mt19937 random(1);
  for (int i = 0; i < repeats; ++i) {
    Job job(endless);
    sleep_us(static_cast<int>(random() % 500));
    job.cancel();
    ASSERT_TRUE(job.wait(patience_s));
    ASSERT_THROW(job.rethrow(), Cancelled);
  }
}

TEST(Job, IsDestroyedAtAnyMoment) {
  std::mt19937 random(2);
  for (int i = 0; i < repeats; ++i) {
    const auto held = std::make_shared<int>(i);
    {
      const Job job([held](const Progress& progress) { endless(progress); });
      sleep_us(static_cast<int>(random() % 500));
    }
    ASSERT_EQ(held.use_count(), 1) << "nothing runs on";
  }
}

TEST(Job, IsPolledCancelledAndAwaitedFromManyThreads) {
  std::mt19937 random(3);
  for (int i = 0; i < repeats; ++i) {
    Job job(endless);
    std::vector<std::thread> others;
    for (int k = 0; k < 3; ++k) {
      others.emplace_back([&job] {
        while (!job.wait(0)) job.state();
      });
    }
    sleep_us(static_cast<int>(random() % 300));
    job.cancel();
    for (std::thread& other : others) other.join();
    ASSERT_TRUE(job.is_done());
  }
}

TEST(Job, ManyRunAtOnce) {
  std::vector<std::unique_ptr<Job>> jobs;
  for (int i = 0; i < 20; ++i) jobs.push_back(std::make_unique<Job>(endless));
  for (const auto& job : jobs) job->cancel();
  for (const auto& job : jobs) EXPECT_TRUE(job->wait(patience_s));
}

}  // namespace
}  // namespace illustrate
