// The whole catalogue, as `seamline stability` runs it.
#include <gtest/gtest.h>

#include "renderer/parallel.h"
#include "stability/catalogue.h"
#include "stability/run_cases.h"

namespace seamline {
namespace {

TEST(WholeCatalogue, Passes) {
  for (const StabilityCase& one : stability_catalogue()) {
    const CaseOutcome outcome = run_case(one, {.threads = default_thread_count()});
    EXPECT_TRUE(outcome.passed) << outcome_line(outcome);
  }
}

}  // namespace
}  // namespace seamline
