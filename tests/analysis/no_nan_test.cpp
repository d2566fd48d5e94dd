// Nothing that a person or a program reads shows "inf" or "nan", however little the answers say.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cctype>
#include <filesystem>

#include "analysis/foresight/plan_text.h"
#include "analysis/psychometric/intervals/judged_fit.h"
#include "analysis/psychometric/report/fit_json.h"
#include "analysis/psychometric/report/fit_text.h"
#include "analysis/report/figures/figures.h"
#include "analysis/report/json/report_json.h"
#include "analysis/report/json/thresholds_json.h"
#include "analysis/report/page/methods_text.h"
#include "analysis/report/page/report_html.h"
#include "analysis/report/tables/all_tables.h"
#include "analysis/report/tables/dictionary.h"
#include "analysis/report/text/checks_text.h"
#include "analysis/report/text/numbers_text.h"
#include "analysis/report/text/predict_text.h"
#include "analysis/report/text/threshold_text.h"
#include "study/log/log_admin.h"
#include "support/files/atomic_file.h"
#include "support/files/temporary_folder.h"
#include "support/text/error.h"
#include "support/text/numbers.h"
#include "tests/analysis/report_people.h"
#include "tests/stimuli/manifest_records.h"

namespace seamline::analysis {
using namespace study;
namespace {

/// The words of a text that stand for no number, each with what is around it.
std::vector<std::string> not_numbers(const std::string& text) {
  std::vector<std::string> found;
  std::string word;
  for (std::size_t at = 0; at <= text.size(); ++at) {
    const auto letter = at < text.size() ? static_cast<unsigned char>(text[at]) : ' ';
    if (std::isalnum(letter) != 0 || letter == '_' || letter >= 0x80) {
      word += static_cast<char>(std::tolower(letter));
      continue;
    }
    if (word == "inf" || word == "nan" || word == "infinity")
      found.push_back(text.substr(at < 60 ? 0 : at - 60, 90));
    word.clear();
  }
  return found;
}

void expect_numbers(const std::string& what, const std::string& text) {
  for (const std::string& found : not_numbers(text)) ADD_FAILURE() << what << ": ..." << found;
}

TEST(NoNan, IsFoundWhereThereIsOne) {
  EXPECT_EQ(not_numbers("above -inf, NaN;eta nan, \"Infinity\"").size(), 4U);
  EXPECT_TRUE(not_numbers("information, nanometre, infinite, x_nan").empty());
}

// ---- fit ----

struct NamedCounts {
  std::string name;
  std::vector<LevelCounts> counts;
};

std::vector<NamedCounts> degenerate_counts() {
  std::vector<LevelCounts> above;
  for (const double level : {64, 128, 256, 512, 1024, 2048}) above.push_back({level, 60, 60});
  above.push_back({4096, 30, 60});
  return {{"one level", {{64, 30, 60}}},
          {"one level, all right", {{64, 60, 60}}},
          {"one level, all wrong", {{64, 0, 60}}},
          {"no trial", {{64, 0, 0}}},
          {"no trials at two levels", {{64, 0, 0}, {128, 0, 0}}},
          {"one trial", {{64, 1, 1}}},
          {"two trials", {{64, 1, 1}, {128, 0, 1}}},
          {"all right", {{64, 60, 60}, {128, 60, 60}, {256, 60, 60}}},
          {"all wrong", {{64, 0, 60}, {128, 0, 60}, {256, 0, 60}}},
          {"all alike", {{64, 30, 60}, {128, 30, 60}, {256, 30, 60}}},
          {"chance", {{64, 20, 60}, {128, 20, 60}, {256, 20, 60}}},
          {"a step between levels", {{64, 20, 60}, {128, 20, 60}, {256, 60, 60}, {512, 60, 60}}},
          {"a step through a level", {{64, 20, 60}, {128, 40, 60}, {256, 60, 60}}},
          {"an empty level", {{64, 20, 60}, {128, 0, 0}, {256, 60, 60}}},
          {"up and down", {{64, 0, 60}, {128, 30, 60}, {256, 0, 60}}},
          {"beyond the last", above},
          {"huge counts", {{64, 1000000000000, 1000000000000}, {128, 1, 1000000000000}}},
          {"far levels", {{1e-300, 1, 2}, {1e300, 2, 2}}},
          {"close levels", {{1, 1, 10}, {1.0000000001, 9, 10}}}};
}

std::vector<FitOptions> every_way() {
  std::vector<FitOptions> ways = {options_for_alternatives(3), options_for_alternatives(1)};
  ways.push_back(options_for_alternatives(3));
  ways.back().guess = free_rate(0.5);
  ways.back().overdispersed = true;
  ways.push_back(options_for_alternatives(2));
  ways.back().sigmoid = Sigmoid::gumbel;
  ways.back().axis = Axis::linear;
  ways.back().lapse = fixed_rate(0);
  ways.back().direction = Direction::increasing;
  return ways;
}

TEST(NoNan, InAFit) {
  for (const NamedCounts& data : degenerate_counts())
    for (const FitOptions& options : every_way()) {
      const JudgedFit report = judge_fit(
          data.counts, options,
          {.percents = {50, 75, 99.9}, .bootstrap_replicates = 10, .deviance_replicates = 10, .unit = "px"});
      expect_numbers("fit of " + data.name, fit_text(report));
      expect_numbers("fit of " + data.name + ", JSON", fit_json(report));
    }
}

// ---- analyze ----

enum class Answers { simulated, alike, right, wrong, wrong_and_sure, step };

void replace_answers(LogContents& log, Answers answers) {
  for (Answer& answer : log.answers) {
    const int wrong = answer.object_index % 3 + 1;
    const bool seen = answers == Answers::right || (answers == Answers::step && answer.depth_width_px < 500);
    switch (answers) {
      case Answers::simulated:
        continue;
      case Answers::alike:
        answer.chosen_index = answer.rating = 1;
        break;
      case Answers::right:
      case Answers::wrong:
      case Answers::step:
        answer.chosen_index = seen ? answer.object_index : wrong;
        answer.rating = seen ? 4 : 1;
        break;
      case Answers::wrong_and_sure:
        answer.chosen_index = wrong;
        answer.rating = 4;
    }
  }
}

void expect_numbers_in_report(const std::string& what, LogContents log, bool with_figures) {
  expect_numbers(what + ", status", status_text(log));
  std::optional<Analysis> analysed;
  try {
    analysed = analyze(std::move(log), false, {.replicates = 100, .seed = 5, .threads = 1});
  } catch (const InputError& error) {
    expect_numbers(what + ", refused", error.what());
    return;
  }
  const Analysis& analysis = *analysed;
  const ReportNumbers numbers = report_numbers(analysis);
  const TemporaryFolder folder;
  std::vector<Figure> figures;
  if (with_figures) figures = draw_figures(analysis, numbers, folder.path());
  for (const Figure& figure : figures) expect_numbers(what + ", " + figure.name, read_file(figure.svg));
  const MethodsText methods = methods_text(analysis, numbers);
  const std::vector<CsvTable> tables = all_tables(analysis, numbers);
  for (const CsvTable& table : tables) expect_numbers(what + ", " + table.name + ".csv", csv_text(table));
  expect_numbers(what + ", dictionary", csv_text(report_dictionary(tables)));
  expect_numbers(what + ", thresholds.json", thresholds_json(analysis));
  expect_numbers(what + ", report.json", report_json(analysis, methods, tables));
  expect_numbers(what + ", methods.txt", plain_text(methods));
  expect_numbers(what + ", report.html",
                 report_html(analysis, numbers, figures, std::string("No pictures.")));
  expect_numbers(what + ", terminal",
                 table_text(analysis) + checks_text(analysis) + numbers_text(analysis, numbers));
  for (const std::string& note : analysis.notes) expect_numbers(what + ", note", note);
}

TEST(NoNan, InAReportOfFewPeopleWhoAnswerAlike) {
  for (const int people : {1, 2, 5})
    for (const Answers answers : {Answers::simulated, Answers::alike, Answers::right, Answers::wrong,
                                  Answers::wrong_and_sure, Answers::step}) {
      LogContents log = people == 2 ? test::people_log(people, 1) : test::simulate_log(people, 1);
      replace_answers(log, answers);
      if (people == 2)
        for (Answer& answer : log.answers) answer.choice_ns = answer.rating_ns = 0;
      expect_numbers_in_report(fmt::format("{} people, answers {}", people, static_cast<int>(answers)),
                               std::move(log), people == 5);
    }
}

TEST(NoNan, InAReportOfFewWidths) {
  for (const int fewest : {4096, 2048}) {
    LogContents log = test::people_log(3, 2);
    std::erase_if(log.answers, [&](const Answer& answer) { return answer.depth_width_px < fewest; });
    for (ParticipantRecord& person : log.participants) person.stimulus_trials = 0;
    expect_numbers_in_report(fmt::format("widths from {}", fewest), std::move(log), true);
  }
}

TEST(NoNan, InAReportWithEmptyCellsOrNobody) {
  LogContents gaps = test::people_log(3, 2);
  std::erase_if(gaps.answers, [](const Answer& answer) {
    return answer.artifact != Artifact::receiver ||
           (answer.depth_width_px == 512 && answer.object_index == 2);
  });
  expect_numbers_in_report("empty cells", std::move(gaps), false);
  LogContents nobody = test::people_log(2, 1);
  for (ParticipantRecord& person : nobody.participants) person.completed = false;
  nobody.answers.clear();
  expect_numbers_in_report("nobody", std::move(nobody), false);
  expect_numbers("an empty log", status_text({}));
  expect_numbers_in_report("an adaptive study", test::adaptive_log(), true);
}

// ---- predict and plan ----

TEST(NoNan, InAPrediction) {
  for (const double difference : {0.0, 1e-300, 1e300})
    for (const int widths : {1, 3}) {
      Manifest manifest;
      VisibleDifferences differences;
      for (int i = 0; i < widths; ++i) {
        manifest.stimuli.push_back(test::record_of(Artifact::receiver, "left", 64 << i));
        differences[manifest.stimuli.back().id] = {.pooled = difference, .above_floor = difference};
      }
      Prediction prediction;
      prediction.observer.image_gain = 1e9;
      prediction.artifacts = predict_artifacts(manifest, differences, prediction.observer);
      expect_numbers(fmt::format("prediction from {}", difference), prediction_text(prediction));
    }
}

TEST(NoNan, InAPlanOfOpenIntervals) {
  StudyPlan plan;
  plan.request.participants = {2};
  plan.curves = {{.artifact = Artifact::receiver, .condition = "", .objects = 3, .midpoint = 300}};
  plan.targets = {{.quantity = every_planned_quantity[0], .truth_x = 9}};
  plan.level_sets = {{"all", {64, 128}}};
  plan.bias_x = {{std::nullopt}};
  plan.rows = {{.participants = 2, .interval = {.within = true, .open_share = 1}}};
  plan.designs = {{.participants = 2}};
  plan.sequential = {{}};
  expect_numbers("plan", plan_text(plan));
}

}  // namespace
}  // namespace seamline::analysis
