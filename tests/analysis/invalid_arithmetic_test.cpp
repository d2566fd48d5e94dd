// Infinity less infinity, 0 / 0 and their like have no value. The processor says so while the tests of this
// file run, as a sanitizer would: FE_INVALID is raised and not taken back.
#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <functional>

#include "analysis/thresholds/condition_differences.h"
#include "analysis/thresholds/thresholds.h"
#include "support/text/numbers.h"
#include "tests/analysis/threshold_people.h"

namespace seamline::analysis {
namespace {

using test::simulate_scores;

bool raises_invalid(const std::function<void()>& compute) {
  std::feclearexcept(FE_INVALID);
  compute();
  return std::fetestexcept(FE_INVALID) != 0;
}

TEST(InvalidArithmetic, IsSeen) {
  volatile double open = infinity, length = 0;
  EXPECT_TRUE(raises_invalid([&] { length = open - open; }));
  EXPECT_FALSE(raises_invalid([&] { length = open - 1; }));
}

/// Thresholds inside the widths, at their ends and beyond, of two people and of many.
TEST(InvalidArithmetic, IsNowhereInThresholdsAndTheirIntervals) {
  for (const double octaves : {-8.0, -2.0, 0.0, 2.0, 8.0})
    for (const int people : {2, 5, 20}) {
      test::Population population;
      for (auto& [artifact, midpoint_px] : population.observer.midpoint) midpoint_px *= std::exp2(octaves);
      const ArtifactScores scores = simulate_scores(population, Artifact::occlusion, people, 3);
      EXPECT_FALSE(raises_invalid([&] {
        const ArtifactThresholds found = estimate_thresholds(scores, {.replicates = 200, .threads = 1});
        (void)length_x(found.estimates.perceptual.ci95);
      })) << octaves
          << " octaves, " << people << " people";
    }
}

}  // namespace
}  // namespace seamline::analysis
