// Levels of any quantity and conditions: what is the same, what is turned, what is recovered.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "analysis/log_analysis/analysis.h"
#include "analysis/log_analysis/report_numbers.h"
#include "analysis/log_analysis/threshold_rows.h"
#include "analysis/report/json/thresholds_json.h"
#include "analysis/report/page/methods_text.h"
#include "analysis/report/tables/all_tables.h"
#include "analysis/report/tables/dictionary.h"
#include "tests/analysis/condition_people.h"

namespace seamline::analysis {
namespace {
using ::testing::HasSubstr;
using ::testing::Not;

Analysis analysed(study::LogContents log, int replicates = 200) {
  return analyze(std::move(log), false, {.replicates = replicates, .seed = 1, .threads = 1});
}

TEST(LevelAxis, TurnsBackWhatItTurns) {
  for (const Quantity quantity : every_quantity)
    for (const Direction direction : {Direction::increasing, Direction::decreasing}) {
      const LevelAxis axis{.quantity = quantity, .noticeability = direction, .unit = 0.7};
      double before = -infinity;
      for (const double level :
           direction == Direction::increasing ? std::vector{9.0, 3.0, 0.25} : std::vector{0.25, 3.0, 9.0}) {
        EXPECT_NEAR(level_at(axis, x_of(axis, level)), level, 1e-12);
        EXPECT_LT(before, x_of(axis, level));
        before = x_of(axis, level);
      }
      const LevelRange open = range_at(axis, {});
      EXPECT_EQ(open.low, -infinity);
      EXPECT_EQ(open.high, infinity);
    }
}

/// Levels k become 2^18 / k, and noticeability rises.
study::LogContents mirrored(study::LogContents log) {
  log.quantity = Quantity::mesh_tolerance;
  log.noticeability = Direction::increasing;
  for (study::Answer& answer : log.answers) answer.level = std::exp2(18) / answer.level;
  return log;
}

TEST(Conditions, AMirroredAxisGivesMirroredThresholds) {
  const Analysis plain = analysed(test::simulate_log(12, 3));
  const Analysis turned = analysed(mirrored(test::simulate_log(12, 3)));
  const std::vector<ThresholdRow> a = threshold_rows(plain), b = threshold_rows(turned);
  ASSERT_EQ(a.size(), b.size());
  const auto expect_mirrored = [](double level, double other) {
    if (!std::isfinite(level)) {
      EXPECT_EQ(other, -level);
    } else {
      EXPECT_NEAR(std::log2(level) + std::log2(other), 18, 1e-5);
    }
  };
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a[i].here.level_x.has_value(), b[i].here.level_x.has_value());
    if (a[i].here.level_x)
      expect_mirrored(*level_of(a[i].here, plain.data.axis), *level_of(b[i].here, turned.data.axis));
    const LevelRange one = range_at(plain.data.axis, a[i].here.ci95),
                     other = range_at(turned.data.axis, b[i].here.ci95);
    expect_mirrored(one.low, other.high);
    expect_mirrored(one.high, other.low);
  }
}

TEST(Conditions, EstimatesOfTexelsPerDegreeStandInTheirColumn) {
  study::LogContents log = test::simulate_log(12, 3);
  log.quantity = Quantity::texels_per_degree;
  for (study::Answer& answer : log.answers) answer.level /= 360;
  const Analysis analysis = analysed(std::move(log), 50);
  const std::vector<CsvTable> tables = noticeability_tables(analysis);
  const auto found = std::find_if(tables.begin(), tables.end(),
                                  [](const CsvTable& one) { return one.name == "thresholds"; });
  ASSERT_NE(found, tables.end());
  const CsvTable& table = *found;
  EXPECT_EQ(table.columns[3].name, "estimate_texels_per_degree");
  EXPECT_EQ(std::count_if(table.columns.begin(), table.columns.end(),
                          [](const auto& column) { return column.name == "estimate_texels_per_degree"; }),
            1);
  const auto rows = threshold_rows(analysis);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto level = level_of(rows[i].here, analysis.data.axis);
    if (!level) continue;
    EXPECT_NEAR(std::get<double>(table.rows[i][3]), *level, 1e-5 * *level);
  }
}

/// The same answers again, in a second condition.
study::LogContents twice(study::LogContents log, const std::string& first, const std::string& second) {
  const std::vector<study::Answer> answers = log.answers;
  for (study::Answer& answer : log.answers) answer.condition = first;
  for (study::Answer answer : answers) {
    answer.condition = second;
    log.answers.push_back(answer);
  }
  return log;
}

TEST(Conditions, TheSameAnswersDifferByNothing) {
  const Analysis analysis = analysed(twice(test::simulate_log(10, 5), "plain", "again"));
  ASSERT_EQ(analysis.differences.size(), 12U);
  for (const ThresholdDifference& found : analysis.differences) {
    EXPECT_EQ(found.condition, "again");
    EXPECT_EQ(found.to, "plain");
    if (found.estimate) {
      EXPECT_DOUBLE_EQ(*found.estimate, 0);
    }
    EXPECT_LE(found.ci95.low, 0);
    EXPECT_GE(found.ci95.high, 0);
  }
}

TEST(Conditions, TheirNamesChangeNothingElse) {
  const Analysis a = analysed(twice(test::simulate_log(8, 6), "aaa", "bbb"));
  const Analysis b = analysed(twice(test::simulate_log(8, 6), "zzz", "yyy"));
  std::string json = thresholds_json(b);
  for (const auto& [from, to] : {std::pair<std::string, std::string>{"zzz", "aaa"}, {"yyy", "bbb"}})
    for (std::size_t at = json.find(from); at != std::string::npos; at = json.find(from, at))
      json.replace(at, from.size(), to);
  EXPECT_EQ(thresholds_json(a), json);
}

TEST(Conditions, EachHasTheThresholdsItWouldHaveAlone) {
  const study::LogContents alone = test::simulate_log(10, 7);
  const Analysis one = analysed(alone), two = analysed(twice(alone, "plain", "again"));
  for (std::size_t i = 0; i < one.thresholds.size(); ++i)
    for (std::size_t c = 0; c < 2; ++c) {
      const ArtifactThresholds& found = two.thresholds[2 * i + c];
      EXPECT_EQ(found.artifact, one.thresholds[i].artifact);
      EXPECT_EQ(found.estimates.perceptual.level_x, one.thresholds[i].estimates.perceptual.level_x);
      EXPECT_EQ(found.estimates.perceptual.ci95.low_x, one.thresholds[i].estimates.perceptual.ci95.low_x);
    }
  EXPECT_THAT(thresholds_json(one), Not(HasSubstr("condition\"")));
  EXPECT_THAT(thresholds_json(two), Not(HasSubstr("\"paper\"")));
}

TEST(Conditions, AThresholdThatIsNotReachedGivesABound) {
  study::LogContents log = twice(test::simulate_log(10, 5), "plain", "clear");
  for (study::Answer& answer : log.answers)
    if (answer.condition == "clear") {
      answer.chosen_index = answer.object_index;
      answer.rating = 4;
    }
  bool some = false;
  for (const ThresholdDifference& found : analysed(log).differences) {
    if (found.quantity == "IP") continue;
    EXPECT_FALSE(found.estimate);
    EXPECT_FALSE(std::isnan(found.bounds.low) || std::isnan(found.bounds.high));
    EXPECT_EQ(found.bounds.high, infinity);
    some = some || found.text.starts_with("above ");
  }
  EXPECT_TRUE(some);
}

TEST(Conditions, ALevelThatStandsApartIsNoPartOfAnyFit) {
  study::LogContents with = mirrored(test::simulate_log(9, 2)), without = with;
  for (study::Answer answer : without.answers) {
    if (answer.level != 64) continue;
    answer.level = 0;
    with.answers.push_back(answer);
  }
  const Analysis a = analysed(without), b = analysed(with);
  ASSERT_EQ(b.data.artifacts.front().level.size(), 8U);
  EXPECT_EQ(b.data.artifacts.front().level.back(), 0);
  for (std::size_t i = 0; i < a.thresholds.size(); ++i) {
    EXPECT_EQ(a.thresholds[i].estimates.perceptual.level_x, b.thresholds[i].estimates.perceptual.level_x);
    EXPECT_EQ(a.thresholds[i].estimates.inflection.level_x, b.thresholds[i].estimates.inflection.level_x);
  }
  const ReportNumbers numbers = report_numbers(b);
  ASSERT_TRUE(numbers.choices.front().pooled);
  EXPECT_EQ(numbers.choices.front().pooled->fit.levels.size(), 7U);
  EXPECT_TRUE(numbers.choices.front().apart);
}

TEST(Conditions, TextsOfARisingAxisSayItsDirectionAndItsQuantity) {
  const Analysis rising = analysed(mirrored(test::simulate_log(9, 2)));
  const ReportNumbers numbers = report_numbers(rising);
  const std::string methods = plain_text(methods_text(rising, numbers));
  EXPECT_THAT(
      methods,
      HasSubstr("the smallest levels of the mesh tolerance at which the non-decreasing isotonic regression"));
  EXPECT_THAT(methods, Not(HasSubstr("non-increasing")));
  EXPECT_THAT(methods, Not(HasSubstr("depth map width")));
  ASSERT_TRUE(numbers.comparisons) << numbers.comparisons_missing;
  bool said = false;
  for (const ContrastTable& table : numbers.comparisons->contrasts)
    said = said || table.question.starts_with("Do artifacts differ at a mesh tolerance of ");
  EXPECT_TRUE(said);
}

/// A sentence names the study's quantity and says each thing once: "the mean that the level implies at a
/// level" names two things by one word.
TEST(Conditions, TextsOfEveryQuantityAreSentences) {
  for (const Quantity quantity : every_quantity) {
    study::LogContents log = test::simulate_log(6, 2);
    log.quantity = quantity;
    log.noticeability = facts(quantity).noticeability;
    const Analysis analysis = analysed(log, 20);
    const ReportNumbers numbers = report_numbers(analysis);
    const std::string methods = plain_text(methods_text(analysis, numbers));
    const bool widths = quantity == Quantity::depth_width_px;
    EXPECT_THAT(methods, HasSubstr(widths ? "depth map widths" : std::string(facts(quantity).name)));
    for (const char* riddle : {"level at a level", "the level at a", "levels level", "the level implies",
                               "linear the level", "log2 the level"})
      EXPECT_THAT(methods, Not(HasSubstr(riddle))) << facts(quantity).key;
    if (!widths) {
      for (const char* of_widths : {"log2 width", "depth map width", "every width", "widths tested"})
        EXPECT_THAT(methods, Not(HasSubstr(of_widths))) << facts(quantity).key;
    }
    // What is ours needs no guard against a spreadsheet's formulas.
    const std::vector<CsvTable> tables = all_tables(analysis, numbers);
    EXPECT_THAT(csv_text(report_dictionary(tables, numbers.axis, numbers.conditions)), Not(HasSubstr("'-")));
  }
}

TEST(Conditions, AreAFactorOfTheOrdinalModel) {
  const ReportNumbers numbers =
      report_numbers(analysed(test::condition_log(test::soft_light_people(), 14, 3)));
  ASSERT_TRUE(numbers.comparisons) << numbers.comparisons_missing;
  bool levels = false, slopes = false;
  for (const ContrastTable& table : numbers.comparisons->contrasts) {
    levels = levels || table.question.starts_with("Do conditions differ within an artifact");
    slopes = slopes || table.question.starts_with("Do conditions differ in how");
  }
  EXPECT_TRUE(levels);
  EXPECT_TRUE(slopes);
}

TEST(ConditionRecovery, PlantedThresholdsLieInTheirIntervals) {
  for (const test::PlantedStudy& people : {test::soft_light_people(), test::mesh_tolerance_people()}) {
    const test::Coverage found = test::coverage_of(people, 20, 6, 0);
    EXPECT_GE(found.share_held(), 0.85);
  }
}

}  // namespace
}  // namespace seamline::analysis
