// A group's threshold: the interval over participants holds the planted one; the long table is in
// psychometric_coverage_full_test.cpp.
#include <gtest/gtest.h>

#include "support/text/error.h"
#include "tests/analysis/psychometric_people.h"
#include "tests/analysis/threshold_people.h"

namespace seamline::analysis {
using namespace study;
namespace {

using test::Group;

TEST(PsychometricPooled, TheIntervalOverParticipantsCoversWhereThePlainOneDoesNot) {
  const Group group;
  const double planted_px = test::planted_threshold_px(group);
  EXPECT_NEAR(planted_px, 512, 1);  // normal people around a normal group: the same function, wider
  int covered = 0, plain = 0;
  constexpr int studies = 300;
  for (std::uint64_t seed = 1; seed <= studies; ++seed) {
    const PooledFit pooled = fit_pooled_choices(test::simulate_group(group, seed), test::group_options());
    covered += pooled.threshold_ci95.low <= planted_px && planted_px <= pooled.threshold_ci95.high ? 1 : 0;
    const Interval binomial = threshold_interval(pooled.fit);
    plain += binomial.low <= planted_px && planted_px <= binomial.high ? 1 : 0;
  }
  EXPECT_GE(covered, 0.92 * studies);
  EXPECT_LE(covered, 0.98 * studies);
  EXPECT_LT(plain, 0.91 * studies);
}

TEST(PsychometricPooled, OrderOfParticipantsDoesNotMatterAndOneIsTooFew) {
  PooledChoices choices = test::simulate_group({}, 3);
  const PooledFit pooled = fit_pooled_choices(choices, test::group_options());
  EXPECT_EQ(pooled.verdict.kind, Verdict::Kind::identified);
  EXPECT_GT(pooled.design_effect, 0.3);
  choices.correct = choices.correct.colwise().reverse().eval();
  const PooledFit reversed = fit_pooled_choices(choices, test::group_options());
  EXPECT_NEAR(reversed.threshold_ci95.low, pooled.threshold_ci95.low, 1e-6 * pooled.threshold_ci95.low);
  choices.correct.conservativeResize(1, Eigen::NoChange);
  choices.trials.conservativeResize(1, Eigen::NoChange);
  EXPECT_THROW((void)fit_pooled_choices(choices, test::group_options()), InputError);
}

TEST(PsychometricPooled, ChoicesOfALogAreCountedByPersonAndWidth) {
  const LogContents log = test::simulate_log(4, 1);
  const PooledChoices choices = pooled_choices(log, {"sim-2", "sim-0", "nobody"}, Artifact::shadow);
  EXPECT_EQ(choices.people, (std::vector<std::string>{"sim-2", "sim-0"}));
  ASSERT_EQ(choices.level.size(), 7U);
  EXPECT_EQ(choices.level.front(), 64);
  EXPECT_TRUE((choices.trials.array() == 3).all());
  double right = 0;
  for (const Answer& answer : log.answers)
    if (answer.artifact == Artifact::shadow && answer.participant == "sim-2")
      right += answer.correct() ? 1 : 0;
  EXPECT_EQ(choices.correct.row(0).sum(), right);
}

}  // namespace
}  // namespace seamline::analysis
