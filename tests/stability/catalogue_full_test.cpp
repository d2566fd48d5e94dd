// The whole catalogue, as `seamline lab stability` runs it.
#include <gtest/gtest.h>

#include "laboratory/stability/catalogue.h"
#include "laboratory/stability/run_cases.h"
#include "raytracer/common/parallel.h"

namespace seamline::stability {
using namespace renderer;
namespace {

TEST(WholeCatalogue, Passes) {
  const auto outcomes = run_cases(
      stability_catalogue(), {.threads = default_thread_count()}, [](std::size_t) {},
      [](const CaseOutcome& outcome) { EXPECT_TRUE(outcome.passed) << outcome_line(outcome); });
  EXPECT_EQ(outcomes.size(), stability_catalogue().size());
}

}  // namespace
}  // namespace seamline::stability
