// Whether intervals of conditions and of turned axes keep their promise, over 50 studies.
#include <gtest/gtest.h>

#include "tests/analysis/condition_people.h"

namespace seamline::analysis {
namespace {

TEST(ConditionCoverage, ThresholdsAndDifferencesLieInTheirIntervals) {
  const test::Coverage soft = test::coverage_of(test::soft_light_people(), 20, 50, 1000);
  EXPECT_GE(soft.inside, 0.91 * soft.tried) << soft.inside << " of " << soft.tried;
}

TEST(ConditionCoverage, TolerancesLieInTheirIntervals) {
  const test::Coverage mesh = test::coverage_of(test::mesh_tolerance_people(), 20, 50, 0);
  EXPECT_GE(mesh.inside, 0.90 * mesh.tried) << mesh.inside << " of " << mesh.tried;
}

}  // namespace
}  // namespace seamline::analysis
