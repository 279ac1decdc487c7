// illustrate_fuzz [--seconds N] [--seed S] [--cases N]: nasty meshes, one after another.
//
// Seeds S, S + 1, ...; ends after N seconds (60) or cases, or at the first failure, with the seed
// that brings it back: illustrate_fuzz --seed S --cases 1.
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <limits>

#include "tests/fuzz/run_case.h"

namespace {

constexpr unsigned seconds_per_case = 120;  // longer: it hangs

volatile std::sig_atomic_t is_running = 0;
char current_case[80] = "";

// Only what a signal handler may call.
void say_which(int signal) {
  if (is_running != 0) {
    const char* what = signal == SIGALRM ? "took too long: " : "ended at: ";
    for (const char* text : {what, static_cast<const char*>(current_case), "\n"})
      if (write(STDERR_FILENO, text, std::strlen(text)) < 0) break;
  }
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

// Sanitizers bring their own handlers, which end in SIGABRT; those stay.
void watch(int signal) {
  const auto before = std::signal(signal, say_which);
  if (before != SIG_DFL) std::signal(signal, before);
}

struct Arguments {
  double seconds = 60;
  std::uint64_t seed = 1;
  std::uint64_t cases = std::numeric_limits<std::uint64_t>::max();
};

Arguments parse(int count, char** words) {
  Arguments arguments;
  for (int i = 1; i < count; i += 2) {
    const std::string name = words[i];
    const char* value = i + 1 < count ? words[i + 1] : "";
    char* end = nullptr;
    if (name == "--seconds") arguments.seconds = std::strtod(value, &end);
    if (name == "--seed") arguments.seed = std::strtoull(value, &end, 10);
    if (name == "--cases") arguments.cases = std::strtoull(value, &end, 10);
    if (end == nullptr || end == value || *end != 0) {
      std::fprintf(stderr, "illustrate_fuzz [--seconds N] [--seed S] [--cases N]\n");
      std::exit(2);
    }
  }
  return arguments;
}

// Says whether all went well.
bool run(std::uint64_t seed) {
  std::snprintf(current_case, sizeof current_case, "--seed %llu --cases 1",
                static_cast<unsigned long long>(seed));
  is_running = 1;
  alarm(seconds_per_case);
  try {
    illustrate::fuzz::run_case(seed);
  } catch (const std::exception& error) {
    ADD_FAILURE() << error.what();
  }
  alarm(0);
  is_running = 0;
  if (::testing::Test::HasFailure()) std::fprintf(stderr, "failed: %s\n", current_case);
  return !::testing::Test::HasFailure();
}

}  // namespace

int main(int count, char** words) {
  ::testing::InitGoogleTest(&count, words);
  const Arguments arguments = parse(count, words);
  for (const int signal : {SIGABRT, SIGSEGV, SIGFPE, SIGALRM}) watch(signal);
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  const auto seconds = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
  std::uint64_t done = 0;
  for (; done < arguments.cases && seconds() < arguments.seconds; ++done)
    if (!run(arguments.seed + done)) return 1;
  std::printf("%llu meshes, all well (seeds %llu ..)\n", static_cast<unsigned long long>(done),
              static_cast<unsigned long long>(arguments.seed));
}
