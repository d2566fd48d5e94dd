// What stands beside the thresholds: how it comes into the analysis, its tables and the report.
#include "analysis/report/tables/all_tables.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "analysis/report/json/thresholds_json.h"
#include "analysis/report/page/report_html.h"
#include "analysis/report/page/sections.h"
#include "analysis/report/text/checks_text.h"
#include "analysis/report/text/threshold_text.h"
#include "support/text/error.h"
#include "tests/analysis/threshold_people.h"

namespace seamline::analysis {
namespace {

using namespace study;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr ResamplingRequest few = {.replicates = 200, .seed = 3};

/// 20 `threshold` observers, of whom the third answers as somebody who looks at nothing.
LogContents log_with_a_random_rater() {
  LogContents log = test::simulate_log(20, 4);
  Random random(8);
  for (Answer& answer : log.answers) {
    if (answer.participant != "sim-2") continue;
    answer.chosen_index = 1 + static_cast<int>(random.below(3));
    answer.rating = 1 + static_cast<int>(random.below(4));
  }
  return log;
}

AnalysisOptions excluding() {
  AnalysisOptions options;
  options.exclude_screened = true;
  return options;
}

TEST(Checks, ScreenedPeopleAreNamedAndUsed) {
  const Analysis analysis = analyze(log_with_a_random_rater(), false, few);
  EXPECT_EQ(analysis.counts.used, 20);
  EXPECT_EQ(analysis.counts.screened, 0);
  EXPECT_THAT(analysis.notes, Contains(HasSubstr("Screening by correlation names 1 participant (sim-2)")));
  ASSERT_GE(analysis.screened.size(), 2U);
  EXPECT_THAT(analysis.screened[0].left_out, IsEmpty());
  EXPECT_THAT(analysis.screened[1].left_out, ElementsAre("sim-2"));
  EXPECT_EQ(analysis.screened[1].thresholds[0].participants, 19);
  EXPECT_EQ(analysis.thresholds[0].estimates.slightly_noticeable.level_x,
            analysis.screened[0].thresholds[0].estimates.slightly_noticeable.level_x);
}

TEST(Checks, ScreenedPeopleAreLeftOutWhenAsked) {
  const Analysis analysis = analyze(log_with_a_random_rater(), false, few, excluding());
  EXPECT_EQ(analysis.counts.used, 19);
  EXPECT_EQ(analysis.counts.screened, 1);
  EXPECT_EQ(analysis.thresholds[0].participants, 19);
  EXPECT_EQ(analysis.screened[0].thresholds[0].participants, 20);  // everybody stays beside it
  EXPECT_EQ(analysis.screening.people.size(), 20U);
  // The same as a log where the researcher excluded that person.
  LogContents log = log_with_a_random_rater();
  log.participants[2].excluded = true;
  const Analysis by_hand = analyze(std::move(log), false, few);
  for (std::size_t a = 0; a < 4; ++a) {
    EXPECT_EQ(analysis.thresholds[a].estimates.slightly_noticeable.ci95.low_x,
              by_hand.thresholds[a].estimates.slightly_noticeable.ci95.low_x);
    EXPECT_EQ(analysis.guessing.curves[a].perceptual_bootstrap.high_x,
              by_hand.guessing.curves[a].perceptual_bootstrap.high_x);
  }
}

TEST(Checks, WhenNobodyIsNamedThereIsOneTable) {
  const Analysis analysis = analyze(test::simulate_log(20, 4), false, few);
  EXPECT_EQ(analysis.screened.size(), 1U);
  EXPECT_THAT(
      checks_text(analysis),
      testing::ContainsRegex("kurtosis names 0 .it would name .*correlation .limit 0.33. names 0 .it would"));
}

TEST(Checks, LeavingOneObjectOutIsTheCurveOfTheOthers) {
  LogContents log = test::simulate_log(20, 5);
  const std::vector<ParticipantUse> people = select_participants(log, false);
  const NoticeabilityData data = average_answers(log, people);
  const std::vector<ObjectInfluence> influence = leave_one_object_out(log, people, data);
  ASSERT_EQ(influence.size(), 4U);
  ASSERT_EQ(influence[1].without.size(), 3U);
  std::erase_if(log.answers, [](const Answer& answer) { return answer.object_index == 2; });
  const NoticeabilityData rest = average_answers(log, people);
  const CurveThresholds& found = influence[1].without[1].thresholds;
  for (std::size_t w = 0; w < 7; ++w) {
    std::vector<double> means;
    for (const CellMean& cell : rest.artifacts[1].cells) means.push_back(cell.mean);
    EXPECT_DOUBLE_EQ(found.isotonic.value[w], fit_non_increasing(means).value[w]);
  }
  const LevelInterval& range = *influence[1].slightly_noticeable;
  for (const WithoutObject& without : influence[1].without) {
    EXPECT_LE(range.low_x, *without.thresholds.slightly_noticeable.level_x);
    EXPECT_GE(range.high_x, *without.thresholds.slightly_noticeable.level_x);
  }
}

TEST(Checks, OfOneObjectLeaveNothingOut) {
  LogContents log = test::simulate_log(4, 5);
  std::erase_if(log.answers, [](const Answer& answer) { return answer.object_index != 2; });
  const Analysis analysis = analyze(std::move(log), false, few);
  EXPECT_THAT(analysis.object_influence[0].without, IsEmpty());
  EXPECT_FALSE(analysis.object_influence[0].perceptual);
  EXPECT_TRUE(
      nlohmann::json::parse(thresholds_json(analysis))["artifacts"][0]["one_object_left_out"].is_null());
}

TEST(Checks, OfOnePersonAreComputedWithoutIntervals) {
  const Analysis analysis = analyze(test::simulate_log(1, 5), false, few);
  EXPECT_EQ(analysis.guessing.curves[0].estimates.perceptual.ci95.high_x, above_every_level);
  EXPECT_TRUE(std::isnan(analysis.opinion[0].ci95_low));
  EXPECT_FALSE(checks_text(analysis).empty());
}

TEST(Checks, EveryColumnIsInTheDictionary) {
  const std::vector<CsvTable> tables = checks_tables(analyze(log_with_a_random_rater(), false, few));
  std::size_t columns = 0;
  for (const CsvTable& table : tables) {
    columns += table.columns.size();
    EXPECT_FALSE(table.rows.empty()) << table.name;
    for (const CsvColumn& column : table.columns) EXPECT_FALSE(column.meaning.empty()) << column.name;
    for (const auto& row : table.rows) ASSERT_EQ(row.size(), table.columns.size()) << table.name;
  }
  EXPECT_EQ(data_dictionary(tables).rows.size(), columns);
}

TEST(Checks, AreInTheJson) {
  AnalysisOptions options;
  options.field_of_view_deg = 60;
  const Analysis analysis = analyze(log_with_a_random_rater(), false, few, options);
  const auto json = nlohmann::json::parse(thresholds_json(analysis));
  EXPECT_EQ(json["screening"]["correlation"]["named"], nlohmann::json::array({"sim-2"}));
  EXPECT_EQ(json["screening"]["attention"]["judged"], false);
  EXPECT_EQ(json["screening"]["people"].size(), 20U);
  EXPECT_EQ(json["thresholds_by_screen"][0]["who"], "everybody");
  EXPECT_GT(json["guessing"]["wrong_choices"].get<double>(), 100);
  EXPECT_GT(json["sos_parameter"]["a"].get<double>(), 0);
  for (const auto& artifact : json["artifacts"]) {
    EXPECT_EQ(artifact["field_of_view"]["degrees"], 60);
    const double px = artifact["slightly_noticeable_px"]["estimate"];
    EXPECT_NEAR(artifact["field_of_view"]["slightly_noticeable"]["equirectangular_px"].get<double>(), px / 6,
                1e-3 * px);
    EXPECT_EQ(artifact["corrected_for_guessing"]["curve"].size(), 7U);
    EXPECT_EQ(artifact["one_object_left_out"]["without"].size(), 3U);
    EXPECT_TRUE(artifact["logistic_thresholds"]["perceptual_threshold_px"].contains("ci95"));
  }
}

TEST(Checks, InTheReportAreEscaped) {
  LogContents log = log_with_a_random_rater();
  const std::string evil = "<b>sim</b>";
  log.participants[2].code = evil;
  for (Answer& answer : log.answers)
    if (answer.participant == "sim-2") answer.participant = evil;
  const std::string html = checks_html(analyze(std::move(log), false, few), {});
  EXPECT_THAT(html, Not(HasSubstr(evil)));
  EXPECT_THAT(html, HasSubstr("&lt;b&gt;sim"));
  EXPECT_THAT(html, HasSubstr("corrected for guessing"));
}

/// Intervals of under five people hold less often than they say, and that is said.
TEST(Checks, FewPeopleAreWarnedOf) {
  for (const int people : {2, 4, 5, 9}) {
    const std::vector<std::string> notes = analyze(test::simulate_log(people, 1), false, few).notes;
    const bool warned = std::any_of(notes.begin(), notes.end(), [](const std::string& note) {
      return note.find("hold the truth less often than they say") != std::string::npos;
    });
    EXPECT_EQ(warned, people < 5) << people;
  }
}

}  // namespace
}  // namespace seamline::analysis
