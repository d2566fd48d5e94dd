#include <gmock/gmock.h>

#include <cmath>

#include "analysis/over_scenes/scene_thresholds.h"
#include "tests/analysis/scene_people.h"

namespace seamline::test {

namespace {

using namespace analysis;

const ThresholdOverScenes& found_of(const CurveOverScenes& over, JointQuantity quantity) {
  for (const ThresholdOverScenes& threshold : over.thresholds)
    if (threshold.quantity == quantity) return threshold;
  throw std::logic_error("a threshold that was not asked for");
}

bool holds(const LevelInterval& interval, double x) {
  return interval.low_x <= x && x <= interval.high_x;
}

/// How often the intervals of simulated studies hold the mean threshold of all scenes.
struct SceneCoverage {
  int studies = 0, like_these = 0, these = 0, without = 0;
  double between_squares = 0;  ///< sum over studies of the estimated variance between scenes
};

SceneCoverage cover_scenes(const ScenePeople& of, int studies, JointQuantity quantity, double truth_x) {
  SceneCoverage coverage;
  for (int study = 0; study < studies; ++study) {
    const CurveOverScenes over =
        threshold_over_scenes(answer_in_scenes(of, static_cast<std::uint64_t>(study) + 1), 1);
    const ThresholdOverScenes& found = found_of(over, quantity);
    ++coverage.studies;
    coverage.without += found.reason.empty() ? 0 : 1;
    if (!found.reason.empty()) continue;
    coverage.like_these += holds(found.like_these, truth_x) ? 1 : 0;
    coverage.these += holds(found.these, truth_x) ? 1 : 0;
    coverage.between_squares += found.spreads.between_scenes * found.spreads.between_scenes;
  }
  return coverage;
}

}  // namespace

// CGM's sum for thresholds that people move alike and each on its own: both variances are known.
TEST(OverScenes, TwoWayVarianceIsPeopleAndScenesLessBoth) {
  Eigen::VectorXd x(4);
  x << 8, 9, 9.5, 8.5;
  const double together = 0.04, own = 0.01;
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Constant(4, 4, together);
  covariance.diagonal().array() += own;
  const TwoSpreads spreads = two_spreads(x, covariance, 20);
  const double s2 = (x.array() - x.mean()).square().sum() / 3;
  EXPECT_DOUBLE_EQ(spreads.mean_x, 8.75);
  EXPECT_NEAR(spreads.people_variance, together + own / 4, 1e-12);
  EXPECT_NEAR(spreads.between_scenes * spreads.between_scenes, s2 - own, 1e-12);
  EXPECT_NEAR(spreads.people_variance + spreads.scenes_variance, together + s2 / 4, 1e-12);
  EXPECT_GT(spreads.degrees, 3);
  EXPECT_LT(spreads.degrees, 3 + 19);
  EXPECT_GT(spreads.half_like_these(), spreads.half_these());
}

TEST(OverScenes, ScenesThatDifferByNoMoreThanNoiseAddNothing) {
  const Eigen::VectorXd x = Eigen::VectorXd::Constant(5, 9);
  const TwoSpreads spreads = two_spreads(x, 0.02 * Eigen::MatrixXd::Identity(5, 5), 12);
  EXPECT_EQ(spreads.between_scenes, 0);
  EXPECT_DOUBLE_EQ(spreads.degrees, 11);
  EXPECT_DOUBLE_EQ(spreads.half_like_these(), spreads.half_these());
}

TEST(OverScenes, MoreScenesShortenWhatMorePeopleCannot) {
  double last = INFINITY;
  for (const int scenes : {3, 5, 10, 30}) {
    const double half = expected_spreads(0.01, 1000, 0.5, scenes).half_like_these();
    EXPECT_LT(half, last);
    EXPECT_GT(half, 1.96 * 0.5 / std::sqrt(scenes));
    last = half;
  }
}

// 0.5 octave between scenes, 20 people, by a generator that the model does not fit.
TEST(OverScenes, IntervalOverScenesHoldsTheMeanOfAllScenes) {
  const ScenePeople of{.scenes = 5};
  const double truth = of.mean_x + true_scene_offset(of, 1, true);
  const SceneCoverage coverage = cover_scenes(of, 24, JointQuantity::slightly_noticeable_corrected, truth);
  EXPECT_EQ(coverage.without, 0);
  EXPECT_GE(coverage.like_these, 19);  // of 24; at 95 % fewer are held in 1 of 3000 runs
  EXPECT_LT(coverage.these, coverage.like_these);
  EXPECT_NEAR(std::sqrt(coverage.between_squares / coverage.studies), 0.5, 0.12);
}

}  // namespace seamline::test
