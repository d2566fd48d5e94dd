// Infinity less infinity, 0 / 0 and their like have no value. The processor is asked to interrupt whoever
// computes one, in any thread and in every test of this program. The test fails and says where.
#include <dlfcn.h>
#include <execinfo.h>
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cfenv>
#include <cmath>
#include <csignal>
#include <functional>
#include <thread>

#include "analysis/thresholds/condition_differences.h"
#include "analysis/thresholds/thresholds.h"
#include "support/text/numbers.h"
#include "tests/analysis/threshold_people.h"

namespace seamline::analysis {
namespace {

using test::simulate_scores;

/// Where the first one was computed since the watch began; threads that are made meanwhile are watched too.
std::array<void*, 24> invalid_places{};
std::atomic<int> invalid_depth = 0;

#ifdef __x86_64__

/// Notes the place, and lets the thread compute on as if nobody watched.
void note_invalid(int signal, siginfo_t* about, void* context) {
  if (about->si_code != FPE_FLTINV) {  // a division of whole numbers by zero: it comes again, and ends us
    std::signal(signal, SIG_DFL);
    return;
  }
  if (invalid_depth == 0)
    invalid_depth = ::backtrace(invalid_places.data(), static_cast<int>(invalid_places.size()));
  constexpr unsigned sse_mask = 1U << 7, x87_mask = 1;
  auto* registers = static_cast<ucontext_t*>(context)->uc_mcontext.fpregs;
  registers->mxcsr |= sse_mask;
  registers->cwd |= x87_mask;
}

void watch_for_invalid() {
  struct sigaction action = {};
  action.sa_sigaction = note_invalid;
  action.sa_flags = SA_SIGINFO;
  ::sigaction(SIGFPE, &action, nullptr);
  (void)::backtrace(invalid_places.data(), 1);  // loads what it needs, outside of the signal
  invalid_depth = 0;
  std::feclearexcept(FE_INVALID);
  ::feenableexcept(FE_INVALID);
}

bool seen_invalid() {
  ::fedisableexcept(FE_INVALID);
  return invalid_depth > 0;
}

#else  // the flags of the test's own thread

void watch_for_invalid() {
  std::feclearexcept(FE_INVALID);
}

bool seen_invalid() {
  return std::fetestexcept(FE_INVALID) != 0;
}

#endif

/// Places that `addr2line -Cfe PROGRAM` reads.
std::string invalid_text() {
  std::string text = "a number that has no value (infinity less infinity, 0 / 0, a comparison with NaN) at";
  for (int i = 0; i < invalid_depth; ++i) {
    Dl_info info = {};
    if (::dladdr(invalid_places[static_cast<std::size_t>(i)], &info) == 0) continue;
    const auto offset =
        static_cast<char*>(invalid_places[static_cast<std::size_t>(i)]) - static_cast<char*>(info.dli_fbase);
    text += fmt::format(" {:#x}", offset);
  }
  return text;
}

class EveryTestIsWatched : public testing::EmptyTestEventListener {
  void OnTestStart(const testing::TestInfo&) override { watch_for_invalid(); }
  void OnTestEnd(const testing::TestInfo&) override {
    if (!seen_invalid()) return;
    ADD_FAILURE() << invalid_text();
  }
};

const bool every_test_is_watched = [] {
  testing::UnitTest::GetInstance()->listeners().Append(new EveryTestIsWatched);
  return true;
}();

bool raises_invalid(const std::function<void()>& compute) {
  watch_for_invalid();
  compute();
  const bool raises = seen_invalid();
  watch_for_invalid();
  return raises;
}

TEST(InvalidArithmetic, IsSeenInEveryThread) {
  ASSERT_TRUE(every_test_is_watched);
  volatile double open = infinity, length = 0;
  EXPECT_TRUE(raises_invalid([&] { length = open - open; }));
  EXPECT_FALSE(raises_invalid([&] { length = open - 1; }));
  EXPECT_TRUE(raises_invalid([&] { length = open - open; }));
#ifdef __x86_64__
  EXPECT_TRUE(raises_invalid([&] { std::thread([&] { length = open - open; }).join(); }));
#endif
}

/// Thresholds inside the widths, at their ends and beyond, of two people and of many.
TEST(InvalidArithmetic, IsNowhereInThresholdsAndTheirIntervals) {
  for (const double octaves : {-8.0, -2.0, 0.0, 2.0, 8.0})
    for (const int people : {2, 5, 20}) {
      test::Population population;
      for (auto& [artifact, midpoint_px] : population.observer.midpoint) midpoint_px *= std::exp2(octaves);
      const ArtifactScores scores = simulate_scores(population, Artifact::occlusion, people, 3);
      EXPECT_FALSE(raises_invalid([&] {
        const ArtifactThresholds found = estimate_thresholds(scores, {.replicates = 200, .threads = 2});
        (void)length_x(found.estimates.perceptual.ci95);
      })) << octaves
          << " octaves, " << people << " people";
    }
}

}  // namespace
}  // namespace seamline::analysis
