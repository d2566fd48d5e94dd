// Thresholds by halves of a session: a planted change is found, none is said where there is none, and
// what cannot be compared is a sentence.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <span>
#include <vector>

#include "support/arithmetic/random.h"
#include "tests/analysis/report_people.h"
#include "tests/analysis/true_halves.h"

namespace seamline::analysis {
namespace {

using ::testing::HasSubstr;

TEST(SessionHalves, APlantedChangeOfHalfAnOctaveIsFound) {
  const test::HalvesTally tally = test::tally_halves({}, 1.0, 20, 12);
  EXPECT_NEAR(tally.sum / tally.studies, 0.5, 0.1);
  EXPECT_GE(tally.said, 11);
  EXPECT_GE(tally.held, 10);
}

TEST(SessionHalves, WithoutAChangeNothingIsSaid) {
  const test::HalvesTally tally = test::tally_halves({}, 0.0, 20, 12);
  EXPECT_EQ(tally.without, 0);
  EXPECT_NEAR(tally.sum / tally.studies, 0.0, 0.1);
  EXPECT_LE(tally.said, 2);
}

/// Everybody in an order of their own.
study::LogContents log_in_any_order(int people) {
  study::LogContents log = test::people_log(people, 4);
  std::vector<int> places(log.answers.size());
  for (std::size_t i = 0; i < places.size(); ++i) places[i] = static_cast<int>(i);
  Random random(9, 1);
  shuffle(std::span<int>(places), random);
  for (std::size_t i = 0; i < places.size(); ++i) log.answers[i].trial_index = places[i];
  return log;
}

TEST(SessionHalves, OfALogAreThoseOfItsAnswers) {
  const SessionHalves halves = session_halves(analyze(log_in_any_order(16), false, {.replicates = 0}));
  ASSERT_EQ(halves.missing, "");
  ASSERT_FALSE(halves.shifts.rows.empty());
  EXPECT_THAT(halves.shifts.rows.front().name, HasSubstr("all curves together"));
  EXPECT_TRUE(std::isfinite(halves.shifts.rows.front().ci95_low));
}

TEST(SessionHalves, ACurveShownInOneHalfIsLeftOut) {
  // Everybody sees the artifacts one after another, so no curve has levels in both halves.
  const SessionHalves halves = session_halves(analyze(test::people_log(16, 4), false, {.replicates = 0}));
  EXPECT_TRUE(halves.shifts.rows.empty());
  EXPECT_THAT(halves.missing, HasSubstr("no curve has a threshold in both halves"));
}

TEST(SessionHalves, OnePersonIsASentence) {
  const SessionHalves halves = session_halves(analyze(test::people_log(1, 4), false, {.replicates = 0}));
  EXPECT_TRUE(halves.shifts.rows.empty());
  EXPECT_THAT(halves.missing, HasSubstr("not estimated"));
}

}  // namespace
}  // namespace seamline::analysis
