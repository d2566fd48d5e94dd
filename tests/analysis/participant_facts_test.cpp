// What the log knows of its participants beside their answers, and what the report makes of it.
#include "analysis/log_analysis/participant_facts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/log_analysis/report_numbers.h"
#include "analysis/report/page/methods_text.h"
#include "analysis/report/page/sections.h"
#include "analysis/report/tables/all_tables.h"
#include "stimuli/definition/form_definition.h"
#include "tests/analysis/report_people.h"
#include "tests/complaint.h"

namespace seamline::analysis {
namespace {

using namespace study;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// The paper's 20 people: 13 with a technical background, 5 of them female; one with uncorrected vision.
LogContents the_papers_people() {
  LogContents log = test::people_log(20, 2);
  for (int p = 0; p < 20; ++p)
    log.participants[static_cast<std::size_t>(p)].form = {
        {.field = "age", .value = std::to_string(21 + p)},
        {.field = "gender", .value = p % 4 == 3 ? "female" : "male"},
        {.field = technical_question, .value = p < 13 ? "yes" : "no"},
        {.field = vision_question, .value = p == 2 ? uncorrected_vision : "normal"}};
  return log;
}

Analysis analysis_of_people(LogContents log, AnalysisOptions options = {}) {
  return analyze(std::move(log), false, {.replicates = 100, .threads = 1}, options);
}

TEST(ParticipantFacts, TheUsualFormAsksWhatTheRulesRead) {
  const auto has = [](const char* name, const char* answer) {
    for (const FormField& field : default_form())
      if (field.name == name) return !fault_of(field, answer);
    return false;
  };
  EXPECT_TRUE(has(vision_question, uncorrected_vision));
  EXPECT_TRUE(has(technical_question, "yes"));
  EXPECT_TRUE(has(technical_question, "no"));
}

TEST(ParticipantFacts, StandInSentencesTableAndMethods) {
  AnalysisOptions options;
  options.displays["sim-0"] = {
      .mode_width_px = 1920, .mode_height_px = 1080, .viewing_distance_mm = 600, .pixels_per_degree = 38.5};
  const Analysis analysis = analysis_of_people(the_papers_people(), options);
  EXPECT_THAT(participants_described(analysis),
              ElementsAre("Age: 21 to 40, mean 30.5.", "Gender: 15 male, 5 female.",
                          "Technical background: 13 yes, 7 no.", "Vision: 19 normal, 1 neither.",
                          "Screens, with the number of participants: 1920 × 1080 px (1).",
                          "Viewing distance, as entered: 600 mm.",
                          "Pixels a degree at the middle of the screen: 38.5."));
  const ReportNumbers numbers = report_numbers(analysis);
  EXPECT_THAT(plain_text(methods_text(analysis, numbers)), HasSubstr("Vision: 19 normal, 1 neither."));
  EXPECT_THAT(participant_table_html(analysis, numbers),
              HasSubstr("1920 × 1080 px, 600 mm, 38.5 px a degree"));
  const CsvTable table = participants_table(numbers);
  const std::string csv = csv_text(table);
  EXPECT_THAT(csv, HasSubstr(",form_age,form_gender,form_technical_background,form_vision,screen_width_px,"
                             "screen_height_px,viewing_distance_mm,pixels_per_degree\n"));
  EXPECT_THAT(csv, HasSubstr(",21,male,yes,normal,1920,1080,600,38.5\n"));
  EXPECT_THAT(csv, HasSubstr(",23,male,yes,neither,,,,\n"));
  for (const std::vector<CsvValue>& row : table.rows) EXPECT_EQ(row.size(), table.columns.size());
}

TEST(ParticipantFacts, GroupsAreComparedAsPromised) {
  const ReportNumbers numbers = report_numbers(analysis_of_people(the_papers_people()));
  ASSERT_TRUE(numbers.comparisons);
  std::vector<std::string> questions;
  for (const ContrastTable& table : numbers.comparisons->contrasts) questions.push_back(table.question);
  EXPECT_THAT(questions, Contains("Do groups of participants differ?"));
  EXPECT_THAT(numbers.comparisons->design.groups, ElementsAre("other", "technical"));
  // Nobody asked: no question.
  const ReportNumbers unasked = report_numbers(analysis_of_people(test::people_log(20, 2)));
  EXPECT_EQ(unasked.comparisons->contrasts.size() + 1, numbers.comparisons->contrasts.size());
}

TEST(ParticipantFacts, UncorrectedVisionIsNamedAndLeftOutWhenAsked) {
  const Analysis used = analysis_of_people(the_papers_people());
  EXPECT_EQ(used.counts.used, 20);
  EXPECT_THAT(used.notes, Contains(HasSubstr("vision is neither normal nor corrected (sim-2)")));
  AnalysisOptions options;
  options.exclude_uncorrected = true;
  const Analysis without = analysis_of_people(the_papers_people(), options);
  EXPECT_EQ(without.counts.used, 19);
  EXPECT_EQ(without.counts.vision, 1);
  EXPECT_EQ(participant_rows(without)[2].why, "vision neither normal nor corrected");
  EXPECT_THAT(plain_text(methods_text(without, report_numbers(without))),
              HasSubstr("left out: 1 (1 whose vision is neither normal nor corrected)"));
  EXPECT_THAT(without.notes, Not(Contains(HasSubstr("(sim-2)"))));
}

TEST(ParticipantFacts, InattentiveAloneAreLeftOutWhereThatWasPromised) {
  AnalysisOptions options;
  options.exclude_inattentive = true;
  for (int p = 0; p < 20; ++p)
    for (int trial = 0; trial < 4; ++trial)
      options.catches.push_back({.participant = "sim-" + std::to_string(p), .right = p != 4});
  const Analysis analysis = analysis_of_people(the_papers_people(), options);
  EXPECT_EQ(analysis.counts.screened, 1);
  EXPECT_EQ(analysis.thresholds[0].participants, 19);
}

}  // namespace
}  // namespace seamline::analysis
