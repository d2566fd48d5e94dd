// Groups of people: a planted shift is found, few people are a verdict, and a field that nobody was asked is
// refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "analysis/log_analysis/headline_rows.h"
#include "analysis/log_analysis/report_numbers.h"
#include "tests/analysis/report_people.h"
#include "tests/complaint.h"

namespace seamline::analysis {
namespace {

using namespace study;
using test::complaint_of;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

/// The first `yes` people answer "yes"; with `shift` they are asked at widths that stand for twice as many
/// texels.
LogContents two_groups(int people, int yes, bool shift) {
  LogContents log = test::people_log(people, 6);
  for (std::size_t i = 0; i < log.participants.size(); ++i) {
    const bool technical = static_cast<int>(i) < yes;
    log.participants[i].form = {{.field = "technical_background", .value = technical ? "yes" : "no"},
                                {.field = "age", .value = std::to_string(20 + i)}};
    if (!technical || !shift) continue;
    for (Answer& answer : log.answers)
      if (answer.participant == log.participants[i].code) {
        answer.level *= 4;
        answer.depth_width_px *= 4;
      }
  }
  return log;
}

Analysis analysed_for_groups(LogContents log) {
  return analyze(std::move(log), false, {.replicates = 100, .seed = 1});
}

TEST(Groups, APlantedShiftOfTwoOctavesIsFound) {
  const auto compared =
      compare_groups(analysed_for_groups(two_groups(20, 10, true)), {"technical_background"});
  ASSERT_EQ(compared.size(), 1U);
  EXPECT_EQ(compared[0].verdict, "");
  ASSERT_FALSE(compared[0].shifts.rows.empty());
  const ContrastRow& all = compared[0].shifts.rows.front();  // yes less no
  EXPECT_LT(all.ci95_low, 2.0);
  EXPECT_GT(all.ci95_high, 2.0);
  EXPECT_EQ(all.verdict, ContrastVerdict::differs);
  EXPECT_THAT(all.conclusion, HasSubstr("larger width"));
  EXPECT_EQ(compared[0].shifts.correction, Correction::holm);  // of under 20 people a group
}

TEST(Groups, FewPeopleAreAVerdictWithoutANumber) {
  const auto compared =
      compare_groups(analysed_for_groups(two_groups(12, 3, false)), {"technical_background"});
  EXPECT_THAT(compared[0].verdict, HasSubstr("'yes' (3)"));
  EXPECT_TRUE(compared[0].shifts.rows.empty());
}

TEST(Groups, NumbersAreSplitAtTheMedianOrInBands) {
  const Analysis analysis = analysed_for_groups(two_groups(12, 6, false));
  const auto compared = compare_groups(analysis, {"age", "age=25", "age=22,31"});
  EXPECT_EQ(compared[0].groups, (std::vector<std::string>{"under 26", "26 and over"}));
  EXPECT_EQ(compared[1].people, (std::vector<int>{5, 7}));
  EXPECT_EQ(compared[2].groups[1], "22 to under 31");
}

TEST(Groups, WhatNobodyWasAskedIsRefused) {
  const Analysis analysis = analysed_for_groups(two_groups(12, 6, false));
  EXPECT_THAT(complaint_of([&] { (void)compare_groups(analysis, {"shoe_size"}); }),
              HasSubstr("age, technical_background"));
  EXPECT_THAT(complaint_of([&] { (void)compare_groups(analysis, {"age=40,30"}); }), HasSubstr("rising"));
  EXPECT_THAT(compare_groups(analysis, {"condition"})[0].verdict, HasSubstr("the study has one"));
}

TEST(Headline, EveryCurveHasARowForEveryRule) {
  const Analysis analysis = analysed_for_groups(test::people_log(12, 4));
  const std::vector<HeadlineRow> rows = headline_rows(analysis);
  EXPECT_EQ(rows.size(), 4 * threshold_rules.size());
  for (const HeadlineRow& row : rows) {
    EXPECT_NE(row.here.level_x.has_value(), row.here.reason.has_value()) << row.rule->name;
    EXPECT_EQ(row.paper_way.has_value(), row.rule->name == std::string("PT") ||
                                             row.rule->name == std::string("SN") ||
                                             row.rule->name == std::string("IP"));
    if (!row.here.level_x) continue;
    EXPECT_LE(row.simultaneous.low_x, row.here.ci95.low_x);
    EXPECT_GE(row.simultaneous.high_x, row.here.ci95.high_x);
  }
}

/// A scale of 0.22 octave and levels one octave apart: the report says that the form alone places thresholds.
TEST(Headline, ACurveThatFallsBetweenTwoLevelsIsSaid) {
  LogContents log = test::people_log(20, 4);
  EXPECT_THAT(analysed_for_groups(log).notes, Not(Contains(HasSubstr("falls between the tested"))));
  Random random(3, 1);
  for (Answer& answer : log.answers) {
    const bool seen = (std::log2(362.0 / answer.level)) / 0.22 > random.normal();
    answer.chosen_index = seen ? answer.right() : 1 + static_cast<int>(random.below(3));
    answer.rating = seen ? 1 + static_cast<int>(random.below(4)) : 1;
  }
  EXPECT_THAT(analysed_for_groups(std::move(log)).notes,
              Contains(HasSubstr("falls between the tested widths 256")));
}

TEST(Headline, GuessersHaveNoThresholdAndAWordForIt) {
  LogContents log = test::people_log(10, 4);
  Random random(3, 1);
  for (Answer& answer : log.answers) {
    answer.chosen_index = 1 + static_cast<int>(random.below(3));
    answer.rating = 1;
  }
  const Analysis analysis = analysed_for_groups(std::move(log));
  for (const HeadlineRow& row : headline_rows(analysis)) {
    EXPECT_FALSE(row.here.level_x) << row.rule->name;
    EXPECT_TRUE(row.here.reason.has_value());
  }
  EXPECT_THAT(analysis.notes, Contains(HasSubstr("joint model has no numbers")));
}

}  // namespace
}  // namespace seamline::analysis
