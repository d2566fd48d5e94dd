// What the report computes beside the thresholds, against the same from elsewhere or by hand.
#include "analysis/log_analysis/report_numbers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "analysis/report/tables/all_tables.h"
#include "tests/analysis/report_people.h"

namespace seamline::analysis {
namespace {

using namespace study;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

Analysis analysed_people(LogContents log, int threads = 1) {
  return analyze(std::move(log), false, {.replicates = 200, .seed = 3, .threads = threads});
}

TEST(ReportNumbers, FitOfRightChoicesIsThePooledFit) {
  const Analysis analysis = analysed_people(test::people_log(10, 1));
  const ReportNumbers numbers = report_numbers(analysis);
  ASSERT_EQ(numbers.choices.size(), 4U);
  std::vector<std::string> codes;
  for (const ParticipantUse& person : analysis.people) codes.push_back(person.record.code);
  FitOptions options = options_for_alternatives(3);
  options.direction = Direction::decreasing;
  for (const ChoiceCurve& curve : numbers.choices) {
    const PooledFit fit = fit_pooled_choices(pooled_choices(analysis.log, codes, curve.artifact), options);
    ASSERT_TRUE(curve.pooled);
    EXPECT_EQ(curve.pooled->fit.function.threshold, fit.fit.function.threshold);
    EXPECT_EQ(curve.pooled->threshold_ci95.low, fit.threshold_ci95.low);
    EXPECT_EQ(curve.people, 10);
    EXPECT_EQ(curve.goodness.residuals.size(), 7U);
  }
}

TEST(ReportNumbers, BandHoldsTheCurveWithinZeroAndOneAndIsTheSameForAnyThreads) {
  const ReportNumbers one = report_numbers(analysed_people(test::people_log(12, 2), 1)),
                      two = report_numbers(analysed_people(test::people_log(12, 2), 2));
  for (std::size_t a = 0; a < one.choices.size(); ++a) {
    const ChoiceCurve& curve = one.choices[a];
    EXPECT_EQ(curve.band_replicates, 200);
    ASSERT_FALSE(curve.band.empty());
    EXPECT_NEAR(curve.band.front().level, 64, 1e-9);
    EXPECT_NEAR(curve.band.back().level, 4096, 1e-6);
    for (std::size_t i = 0; i < curve.band.size(); ++i) {
      const BandPoint& point = curve.band[i];
      EXPECT_LE(0, point.low);
      EXPECT_LE(point.low, point.fitted + 0.02);
      EXPECT_LE(point.fitted, point.high + 0.02);
      EXPECT_LE(point.high, 1);
      EXPECT_EQ(point.low, two.choices[a].band[i].low);
      EXPECT_EQ(point.high, two.choices[a].band[i].high);
    }
    EXPECT_EQ(curve.deviance_p, two.choices[a].deviance_p);
  }
}

TEST(ReportNumbers, QuartilesOfTimes) {
  const Quartiles times = quartiles({4, 1, 3, 2, 5});
  EXPECT_DOUBLE_EQ(times.lower_s, 2);
  EXPECT_DOUBLE_EQ(times.median_s, 3);
  EXPECT_DOUBLE_EQ(times.upper_s, 4);
  EXPECT_TRUE(std::isnan(quartiles({}).median_s));
}

TEST(ReportNumbers, TimesCountEveryAnswerOfPeopleOnceAndLeaveSimulatedObserversOut) {
  LogContents log = test::people_log(6, 3);
  log.participants[2].simulated = true;
  log.participants[4].excluded = true;
  const ResponseTimes times = response_times(analysed_people(std::move(log)));
  int all = 0, by_choice = 0, by_artifact = 0;
  for (const ResponseTime& row : times.rows) {
    EXPECT_LE(row.people, 4);
    EXPECT_NEAR(row.rating.median_s, 1, 1e-9);
    EXPECT_LE(row.choice.lower_s, row.choice.upper_s);
    (row.artifact                     ? by_artifact
     : row.which == TimedAnswers::all ? all
                                      : by_choice) +=
        row.artifact && row.which != TimedAnswers::all ? 0 : row.answers;
  }
  EXPECT_EQ(all, 4 * 84);
  EXPECT_EQ(by_choice, 4 * 84);
  EXPECT_EQ(by_artifact, 4 * 84);
}

TEST(ReportNumbers, SimulatedObserversHaveNoTimes) {
  const ResponseTimes times = response_times(analysed_people(test::simulate_log(4, 1)));
  EXPECT_THAT(times.rows, IsEmpty());
  EXPECT_THAT(times.missing, HasSubstr("simulated"));
}

TEST(ReportNumbers, EveryParticipantHasALineThatSaysWhyTheyAreNotUsed) {
  LogContents log = test::people_log(5, 3);
  log.participants[1].excluded = true;
  log.participants[2].pilot = true;
  log.participants[3].completed = false;
  int ratings = 0;
  for (const Answer& answer : log.answers)
    if (answer.participant == "sim-0") ratings += answer.rating;
  const std::vector<ParticipantRow> rows = participant_rows(analysed_people(std::move(log)));
  ASSERT_EQ(rows.size(), 5U);
  EXPECT_EQ(rows[0].why, "");
  EXPECT_TRUE(rows[0].screened);
  EXPECT_DOUBLE_EQ(rows[0].mean_rating, ratings / 84.0);
  EXPECT_EQ(rows[1].why, "excluded by the researcher");
  EXPECT_FALSE(rows[1].screened);
  EXPECT_EQ(rows[2].why, "pilot");
  EXPECT_EQ(rows[3].why, "did not finish: 84 of 84 trials");
}

TEST(ReportNumbers, OfOnePersonSayWhatIsMissing) {
  const ReportNumbers numbers = report_numbers(analysed_people(test::people_log(1, 3)));
  for (const ChoiceCurve& curve : numbers.choices) {
    EXPECT_FALSE(curve.pooled);
    EXPECT_THAT(curve.missing, HasSubstr("at least two"));
  }
  ASSERT_TRUE(numbers.comparisons);
  EXPECT_EQ(numbers.comparisons->fit.verdict, OrdinalVerdict::one_participant);
  EXPECT_THAT(numbers.comparisons->contrasts, IsEmpty());
  EXPECT_FALSE(numbers.times.rows.empty());
}

TEST(ReportNumbers, OfAnAdaptiveLogAreItsTracks) {
  const Analysis analysis = analysed_people(test::adaptive_log());
  const ReportNumbers numbers = report_numbers(analysis);
  EXPECT_TRUE(analysis.adaptive);
  EXPECT_FALSE(numbers.comparisons);
  EXPECT_THAT(numbers.comparisons_missing, HasSubstr("placed by the answers"));
  for (const ChoiceCurve& curve : numbers.choices)
    EXPECT_THAT(curve.missing, HasSubstr("placed by the answers"));
  EXPECT_EQ(numbers.tracks.size() % 3, 0U);
  ASSERT_FALSE(numbers.tracks.empty());
  EXPECT_EQ(tracks_table(numbers).name, "tracks");
  EXPECT_EQ(tracks_table(numbers).rows.size(), numbers.tracks.size());
}

}  // namespace
}  // namespace seamline::analysis
