// The report's files: every section is there, numbers are the same everywhere, text is escaped, and every
// field is explained.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "analysis/report/json/report_json.h"
#include "analysis/report/json/thresholds_json.h"
#include "analysis/report/page/methods_text.h"
#include "analysis/report/page/report_html.h"
#include "analysis/report/tables/all_tables.h"
#include "analysis/report/tables/dictionary.h"
#include "analysis/report/text/numbers_text.h"
#include "support/files/atomic_file.h"
#include "support/text/html.h"
#include "tests/analysis/report_people.h"

namespace seamline::analysis {
namespace {

using namespace study;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;
using Json = nlohmann::json;

struct Report {
  Analysis analysis;
  ReportNumbers numbers;
  std::vector<CsvTable> tables;
  MethodsText methods;
  std::string html;
};

Report report_of(LogContents log) {
  Report report;
  report.analysis = analyze(std::move(log), false, {.replicates = 200, .seed = 3});
  report.numbers = report_numbers(report.analysis);
  report.tables = all_tables(report.analysis, report.numbers);
  report.methods = methods_text(report.analysis, report.numbers);
  const std::filesystem::path folder = std::filesystem::path(SEAMLINE_TEST_OUTPUT) / "report_page";
  std::filesystem::create_directories(folder);
  report.html = report_html(report.analysis, report.numbers,
                            draw_figures(report.analysis, report.numbers, folder), std::string("no set"));
  return report;
}

/// Paths of all leaves; a list is "[]", an empty list or null its own leaf.
void add_paths(const Json& json, const std::string& path, std::set<std::string>& paths) {
  if (json.is_object())
    for (const auto& [key, value] : json.items())
      add_paths(value, path.empty() ? key : path + "." + key, paths);
  else if (json.is_array() && !json.empty())
    for (const Json& value : json) add_paths(value, path + "[]", paths);
  else
    paths.insert(path);
}

void expect_explained(const std::string& json_text, const std::string& file, const CsvTable& dictionary) {
  std::set<std::string> paths, explained;
  add_paths(Json::parse(json_text), "", paths);
  for (const auto& row : dictionary.rows)
    if (std::get<std::string>(row[0]) == file) explained.insert(std::get<std::string>(row[1]));
  for (const std::string& path : paths) {
    // Null or empty in this log, a structure in others: something below it is explained.
    const auto next = explained.lower_bound(path);
    EXPECT_TRUE(next != explained.end() &&
                (*next == path || next->starts_with(path + ".") || next->starts_with(path + "[]")))
        << file << ": " << path;
  }
}

TEST(ReportPage, HasEverySectionAndFigure) {
  const Report report = report_of(test::people_log(8, 4));
  for (const char* section : {"thresholds", "model", "order", "noticeability", "psychometric", "comparisons",
                              "checks", "times", "participants", "stimuli", "methods", "data"}) {
    EXPECT_THAT(report.html, HasSubstr(std::string("<h2 id=\"") + section + "\">"));
    EXPECT_THAT(report.html, HasSubstr(std::string("href=\"#") + section + "\""));
  }
  std::size_t figures = 0;
  for (std::size_t at = 0; (at = report.html.find("<figure ", at)) != std::string::npos; ++at) ++figures;
  EXPECT_EQ(figures, 8U);
}

TEST(ReportPage, EveryFieldIsInTheDictionary) {
  for (LogContents log : {test::people_log(8, 4), test::simulate_log(1, 1)}) {
    const Report report = report_of(std::move(log));
    const CsvTable dictionary = report_dictionary(report.tables);
    expect_explained(thresholds_json(report.analysis), "thresholds.json", dictionary);
    expect_explained(report_json(report.analysis, report.methods, report.tables), "report.json", dictionary);
    for (const auto& row : dictionary.rows) EXPECT_FALSE(std::get<std::string>(row[3]).empty());
    for (const CsvTable& table : report.tables)
      for (const auto& row : table.rows) ASSERT_EQ(row.size(), table.columns.size()) << table.name;
  }
}

TEST(ReportPage, OneCurveHasNothingToBeComparedWith) {
  LogContents log = test::people_log(8, 4);
  const std::string introduction = "Thresholds and slopes of the joint model.";
  EXPECT_THAT(report_of(log).html, HasSubstr(introduction));
  std::erase_if(log.answers, [](const Answer& answer) { return answer.artifact != Artifact::receiver; });
  const Report report = report_of(std::move(log));
  ASSERT_EQ(report.analysis.data.artifacts.size(), 1U);
  ASSERT_TRUE(report.analysis.joint);
  EXPECT_THAT(report.html, HasSubstr("The joint model has one curve, and nothing to compare it with."));
  EXPECT_THAT(report.html, Not(HasSubstr(introduction)));
}

TEST(ReportPage, NumbersAreTheSameOnThePageInJsonAndInTheTerminal) {
  const Report report = report_of(test::people_log(12, 4));
  const Json tables = Json::parse(report_json(report.analysis, report.methods, report.tables))["tables"];
  ASSERT_EQ(tables["psychometric"].size(), 4U);
  const std::string terminal = numbers_text(report.analysis, report.numbers);
  for (const Json& row : tables["psychometric"]) {
    ASSERT_EQ(row["verdict"], "identified");
    const auto px = [&](const char* key) { return std::to_string(std::lround(row[key].get<double>())); };
    const std::string interval = px("threshold_low_px") + " to " + px("threshold_high_px");
    EXPECT_THAT(report.html, HasSubstr(px("threshold_px") + " (" + interval + ")"));
    EXPECT_THAT(terminal, HasSubstr(interval));
  }
  ASSERT_FALSE(tables["joint_contrasts"].empty());
  for (const Json& row : tables["joint_contrasts"]) {
    EXPECT_THAT(report.html, HasSubstr(html_escape(row["conclusion"].get<std::string>())));
    EXPECT_THAT(terminal, HasSubstr(row["conclusion"].get<std::string>()));
  }
  EXPECT_EQ(tables["participants"].size(), 12U);
  EXPECT_EQ(tables["answers"].size(), 12U * 84U);
  EXPECT_EQ(tables["tracks"].size(), 0U);
}

TEST(ReportPage, MethodsNameNumbersSeedsVersionAndReferences) {
  LogContents log = test::people_log(8, 4);
  log.participants[1].excluded = true;
  const Report report = report_of(std::move(log));
  const std::string text = plain_text(report.methods);
  for (const char* words :
       {"8 participants are in the log", "left out: 1 (1 excluded by the researcher)",
        "7 participants with 588 trials", "seed 3", "Seamline ", "Wichmann and Hill", "Response times"})
    EXPECT_THAT(text, HasSubstr(words));
  EXPECT_THAT(report.methods.references, Contains(HasSubstr("Wichmann, F. A.")));
  EXPECT_THAT(report.methods.references, Not(Contains(HasSubstr("Watson"))));
}

TEST(ReportPage, EscapesTextFromPeople) {
  LogContents log = test::people_log(6, 4);
  const std::string evil = "<script>alert(1)</script>";
  log.participants[0].code = evil;
  for (Answer& answer : log.answers) {
    if (answer.participant == "sim-0") answer.participant = evil;
    answer.object += evil;
    answer.scene += evil;
    answer.stimulus_id += evil;
  }
  for (std::string* text : {&log.study_name, &log.study_hash, &log.set_hash, &log.study_text}) *text += evil;
  log.file = "/logs/" + evil + ".sqlite";
  log.set_folder = "/sets/\"" + evil;
  for (ParticipantRecord& record : log.participants)
    record.form = {{.field = "remark" + evil, .value = "'\"" + evil}};
  const Report report = report_of(std::move(log));
  EXPECT_THAT(report.html, Not(HasSubstr("<script")));
  EXPECT_THAT(report.html, HasSubstr("&lt;script&gt;"));
  EXPECT_THAT(report.html, Not(HasSubstr("\"<")));  // no attribute ends early
  EXPECT_TRUE(Json::accept(report_json(report.analysis, report.methods, report.tables)));
}

TEST(ReportPage, TablesAreSafeToOpenInASpreadsheet) {
  LogContents log = test::people_log(6, 4);
  const std::string formula = "=cmd|' /C calc'!A0";
  for (Answer& answer : log.answers) answer.object = formula;
  for (ParticipantRecord& record : log.participants) record.form = {{.field = "+1", .value = "@SUM(1,2)"}};
  const Report report = report_of(std::move(log));
  std::size_t shown = 0;
  for (const CsvTable& table : report.tables) {
    const std::string text = csv_text(table);
    for (const char* begin : {"\n=", ",=", "\n@", ",@", "\n+", ",+", "\"=", "\"@"})
      EXPECT_THAT(text, Not(HasSubstr(begin))) << table.name;
    shown += text.find("'=cmd|") != std::string::npos ? 1 : 0;
  }
  EXPECT_GT(shown, 2U);
}

TEST(ReportPage, OfOnePersonSaysWhatIsMissing) {
  const Report report = report_of(test::people_log(1, 4));
  EXPECT_THAT(report.html, HasSubstr("one participant answered, and intervals over participants need"));
  EXPECT_THAT(report.html, HasSubstr("No comparison is made"));
  EXPECT_THAT(report.html, HasSubstr("Response times"));
}

TEST(ReportPage, NamesOfDottedLinesCoverNoPoint) {
  Report report = report_of(test::people_log(1, 4));
  const std::filesystem::path folder = std::filesystem::path(SEAMLINE_TEST_OUTPUT) / "report_page";
  const auto script = [&](double mean_at_first_level) {
    for (ArtifactScores& scores : report.analysis.data.artifacts)
      for (CellMean& cell : scores.cells)
        if (cell.level == scores.level.front()) cell.mean = mean_at_first_level;
    static_cast<void>(draw_figures(report.analysis, report.numbers, folder));
    return read_file(folder / "fig7_averages.gnuplot");
  };
  const std::string pt = "'PT  0.5' at graph 0.004, first 0.5 left offset ",
                    sn = "'SN  1.0' at graph 0.004, first 1.0 left offset ";
  EXPECT_THAT(script(3.5), AllOf(HasSubstr(pt + "0,0.45"), HasSubstr(sn + "0,0.45")));
  EXPECT_THAT(script(0.67), AllOf(HasSubstr(pt + "0,-0.55"), HasSubstr(sn + "0,0.45")));
  EXPECT_THAT(script(1.2), AllOf(HasSubstr(pt + "0,0.45"), HasSubstr(sn + "0,-0.55")));
}

TEST(ReportPage, OfAnAdaptiveLogShowsTracksAndSaysWhatIsMissing) {
  const Report report = report_of(test::adaptive_log());
  for (const char* words : {"<h3>Tracks</h3>", "There is no curve of everybody", "Artifacts are not compared",
                            "Thresholds are not estimated otherwise", "There are no response times"})
    EXPECT_THAT(report.html, HasSubstr(words));
  EXPECT_THAT(report.html, Not(HasSubstr("nan")));
  EXPECT_THAT(plain_text(report.methods), HasSubstr("Watson, 2017"));
  EXPECT_THAT(plain_text(report.methods), Not(HasSubstr("isotonic")));
  const CsvTable dictionary = report_dictionary(report.tables);
  expect_explained(thresholds_json(report.analysis), "thresholds.json", dictionary);
  expect_explained(report_json(report.analysis, report.methods, report.tables), "report.json", dictionary);
}

}  // namespace
}  // namespace seamline::analysis
