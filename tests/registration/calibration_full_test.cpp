// 200 planted rigs: the ellipsoids that calibration states hold 95 % of the truth.
#include <gtest/gtest.h>

#include "registration/calibration/opencv.h"
#include "tests/registration/planted_rig.h"

namespace seamline::registration {
namespace {

TEST(CalibrationCoverage, TwoHundredRigsAreHeldWithinTheirOwnCovarianceIn95Percent) {
  if (!has_opencv()) GTEST_SKIP() << "built without OpenCV";
  const test::RigCoverage coverage = test::rig_coverage(200, 7);
  std::printf("of 200: together %d, depth camera %d, colour camera %d, pose %d\neach parameter:",
              coverage.together.held, coverage.depth.held, coverage.colour.held, coverage.pose.held);
  for (const test::Held& held : {coverage.together, coverage.depth, coverage.colour, coverage.pose})
    EXPECT_TRUE(held.is_95_percent()) << held.held << " of " << held.trials;
  for (std::size_t i = 0; i < coverage.each.size(); ++i) {
    std::printf(" %d", coverage.each[i].held);
    EXPECT_TRUE(coverage.each[i].is_95_percent()) << i << ": " << coverage.each[i].held;
  }
  const test::Held pairs = test::pairs_coverage(1000, 8);
  std::printf("\npairs: %d of %d\n", pairs.held, pairs.trials);
  EXPECT_TRUE(pairs.is_95_percent()) << pairs.held;
}

}  // namespace
}  // namespace seamline::registration
